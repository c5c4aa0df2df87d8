#include "sim/machine/transaction_run.h"

#include "models/common/error.h"
#include "sim/hardware/choose_set.h"
#include "sim/machine/cycle_machine.h"

namespace cuesta {

void check_loosely_timed(const Architecture& architecture) {
  if (rtl::has_rtl(architecture)) {
    throw usage_error(
        "units." + std::string(architecture.units.hmt_top == Implementation::kRtl ? "hmt_top" : "traverse") +
        " = \"rtl\" is hardware, which ticks every cycle, and fidelity transaction leaves cycles out; "
        "accepted "
        "with it is \"model\", or --fidelity cycle.");
  }
}

Outcome run_transaction(const Workload& work, const Architecture& architecture, const Progress& progress) {
  check_loosely_timed(architecture);
  CycleHooks hooks;
  hooks.loosely_timed = true;
  return run_cycle_detailed(work, architecture, progress, hooks, nullptr);
}

}  // namespace cuesta
