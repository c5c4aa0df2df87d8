#include "sim/session/machines.h"

#include <algorithm>

#include "models/common/error.h"
#include "sim/config/on_architecture.h"
#include "sim/machine/transaction_run.h"

namespace cuesta {

std::vector<ResolvedArchitecture> resolve_machines(std::span<const std::string> names,
                                                   const std::vector<std::string>& settings,
                                                   Fidelity fidelity) {
  std::vector<ResolvedArchitecture> found;
  for (const std::string& name : names) {
    found.push_back(resolve_architecture(name, settings, fidelity != Fidelity::kFunctional));
    if (fidelity == Fidelity::kTransaction) check_loosely_timed(found.back().architecture);
    if (fidelity == Fidelity::kRtl) {
      for (const std::string& setting : settings) {
        if (setting.starts_with("units."))
          throw usage_error("--set " + setting +
                            ": --fidelity rtl says it all; accepted with it is --fidelity cycle.");
      }
      found.back().set("units.hmt_top", static_cast<int64_t>(Implementation::kRtl), "--fidelity rtl");
    }
    for (size_t k = 0; k + 1 < found.size(); ++k) {
      if (found[k].architecture.name == found.back().architecture.name) {
        throw usage_error("Two architectures are named " + found[k].architecture.name +
                          "; accepted are different names, since results are told apart by them.");
      }
    }
  }
  if (found.empty())
    throw usage_error("--arch names no architecture; `cuesta list architectures` prints all.");
  return found;
}

void check_searches(std::span<const Algorithm> algorithms, std::span<const ResolvedArchitecture> machines) {
  for (const Algorithm& algorithm : algorithms) {
    if (algorithm.exact()) continue;
    for (const ResolvedArchitecture& machine : machines) {
      algorithm_on(algorithm, machine.architecture.traverse);
      const UnitParameters& units = machine.architecture.units;
      if (units.hmt_top == Implementation::kRtl || units.traverse == Implementation::kRtl) {
        throw usage_error("The hardware (--fidelity rtl, [units]) has exact algorithms, and " + algorithm.id +
                          " is a search; accepted with it are exact algorithms.");
      }
    }
  }
}

int most_pipelines(std::span<const ResolvedArchitecture> machines) {
  int most = 1;
  for (const ResolvedArchitecture& machine : machines) {
    most = std::max(most, machine.architecture.machine.pipelines);
  }
  return most;
}

}  // namespace cuesta
