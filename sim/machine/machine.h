#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/units/architecture.h"
#include "models/work/outcome.h"
#include "models/work/workload.h"

namespace cuesta {

/// kTransaction: kCycle with rays that run ahead of time; its cycles are an estimate. kRtl: kCycle with the hardware in
/// the place of ray_setup, traverse and height_l1 (units.hmt_top).
enum class Fidelity : uint8_t { kFunctional, kTransaction, kCycle, kRtl };

/// Runs every unit in time, traverse loosely: a transaction is a run of steps that find their lines in height_l1
/// (models/units/traverse/run_ahead_traverse.h). Hits, steps and addresses are those of the other fidelities; the
/// order in which height_l1 is asked, and with it traffic and machine.cycles, is nearly that of run_cycle. The same
/// counters, planes and laws. Throws usage_error for units in hardware, and Error(kNoProgress) as run_cycle.
Outcome run_transaction(const Workload& work, const Architecture& architecture,
                        const Progress& progress = {});

/// Runs every cycle of every unit. Throws Error(kNoProgress) with each queue's fill and who waits for whom.
Outcome run_cycle(const Workload& work, const Architecture& architecture, const Progress& progress = {});

/// Checks the conservation laws over one outcome: in = out at every unit, stall reasons add up, bytes balance, planes +
/// nobody = totals. Returns one sentence per broken law; empty when all hold.
std::vector<std::string> broken_laws(const Workload& work, const Architecture& architecture,
                                     Fidelity fidelity, const Outcome& outcome);

}  // namespace cuesta
