#include "models/common/error.h"
#include "models/common/words.h"
#include "sim/explore/accuracy/accuracy.h"
#include "sim/explore/bandwidth/bandwidth.h"
#include "sim/explore/fidelity/fidelity.h"
#include "sim/explore/iterations/iterations.h"
#include "sim/explore/precision/precision.h"
#include "sim/explore/stability/stability.h"
#include "sim/explore/study/study.h"

namespace cuesta {

std::span<const Study> studies() {
  static const Study kStudies[] = {
      iterations_study(), bandwidth_study(), fidelity_study(),
      accuracy_study(),   precision_study(), stability_study(),
  };
  return kStudies;
}

const Study& find_study(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Study& study : studies()) {
    if (study.name == name) return study;
    names.push_back(study.name);
  }
  const std::string near = did_you_mean(name, names);
  throw usage_error("There is no study `" + printable(name) + "`; accepted are " + joined(names) +
                    (near.empty() ? "." : near));
}

}  // namespace cuesta
