#pragma once

#include <memory>

#include "models/units/hit_queue/hit_queue.h"
#include "models/units/hmt/hmt_unit.h"
#include "models/units/result_writer/hit_drain.h"
#include "models/units/result_writer/result_writer.h"
#include "sim/machine/cycle_machine.h"

namespace cuesta {

/// The instances of one pipeline, in the data's way; bound in wiring.cpp.
struct CycleMachine::Pipeline {
  Pipeline(CycleMachine& m, int p, uint64_t write_base, const CycleHooks& hooks, PortLog* log);

  HitQueue hit_queue;
  ResultWriter writer;
  HitDrain drain;
  std::unique_ptr<HmtUnit> hmt;
};

}  // namespace cuesta
