#include "models/common/error.h"
#include "models/common/words.h"
#include "sim/explore/accuracy/accuracy.h"
#include "sim/explore/accuracy/accuracy_pictures.h"
#include "sim/explore/bandwidth/bandwidth.h"
#include "sim/explore/fidelity/fidelity.h"
#include "sim/explore/iterations/iterations.h"
#include "sim/explore/precision/precision.h"
#include "sim/explore/stability/stability.h"
#include "sim/explore/study/study.h"
#include "sim/explore/study/study_pages.h"

namespace cuesta {
namespace {

constexpr Study kStudies[] = {
    {"iterations", iterations_plan, 2, iterations_planned, make_iterations_bench, iterations_page,
     iterations_headline},
    {"bandwidth", bandwidth_plan, 2, bandwidth_planned, make_bandwidth_bench, bandwidth_page,
     bandwidth_headline},
    {"fidelity", fidelity_plan, 2, fidelity_planned, make_fidelity_bench, fidelity_page, fidelity_headline,
     nullptr, fidelity_times, fidelity_timed_page},
    {"accuracy", accuracy_plan, 2, nullptr, make_accuracy_bench, accuracy_page, accuracy_headline,
     accuracy_pictures, accuracy_times, accuracy_timed_page},
    {"precision", precision_plan, 2, nullptr, make_precision_bench, precision_page, precision_headline},
    {"stability", stability_plan, 2, nullptr, make_stability_bench, stability_page, stability_headline,
     nullptr, stability_times, stability_timed_page},
};

}  // namespace

std::span<const Study> studies() { return kStudies; }

const Study& find_study(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Study& study : kStudies) {
    if (study.name == name) return study;
    names.push_back(study.name);
  }
  const std::string near = did_you_mean(name, names);
  throw usage_error("There is no study `" + printable(name) + "`; accepted are " + joined(names) +
                    (near.empty() ? "." : near));
}

}  // namespace cuesta
