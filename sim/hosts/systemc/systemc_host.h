#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "sim/machine/machine.h"
#include "traces/ray_trace.h"

namespace cuesta {

/// Throws usage_error for a search: the host serves the bytes of the pyramid's image.
void check_served_by_systemc(const std::optional<Search>& search);

/// Runs machines inside a SystemC simulation: the machine's shell, its rays from a bus initiator, dram behind a TLM
/// socket. The same outcome as run_cycle, cycle for cycle.
///
/// One process has one simulation. It is elaborated once; runs follow one another in it, each on a new machine in the
/// same shell, as after a reset. So one object a process.
class SystemCHost {
 public:
  /// `vcd`: a trace file of the (one) run; empty: none. `pipelines`: of the machine with most.
  SystemCHost(const std::string& vcd, int pipelines, bool quiet);
  ~SystemCHost();

  /// `rays`: as traced, in the order of `work.rays`. Throws as run_cycle, and Error for what SystemC reports.
  Outcome run(const Workload& work, std::span<const TracedRay> rays, const Architecture& architecture,
              const Progress& progress);

 private:
  struct Modules;
  std::unique_ptr<Modules> modules_;
};

}  // namespace cuesta
