#include "models/units/statistics.h"

#include <algorithm>
#include <string>
#include <vector>

#include "models/common/error.h"
#include "models/units/dram/counters.h"
#include "models/units/height_l1/counters.h"
#include "models/units/hit_queue/counters.h"
#include "models/units/machine_statistics.h"
#include "models/units/ray_dispatch/counters.h"
#include "models/units/ray_setup/counters.h"
#include "models/units/result_writer/counters.h"
#include "models/units/traverse/counters.h"
#include "models/work/counters.h"

namespace cuesta {
namespace {

const StatisticDefinition& definition(const StatisticDefinition& row) { return row; }
template <class Counts>
const StatisticDefinition& definition(const CounterRow<Counts>& row) {
  return row.definition;
}

/// The rows of all tables, sorted by name.
std::vector<StatisticDefinition> all_definitions() {
  std::vector<StatisticDefinition> all;
  const auto add = [&](const auto&... tables) {
    const auto rows = [&](const auto& table) {
      for (const auto& row : table) all.push_back(definition(row));
    };
    (rows(tables), ...);
  };
  add(kWorkCounters, kErrorCounters, kNoAnswerCounters, kPreprocessingCounters, kWorkStatistics,
      kMachineCounters, kTimeStatistics, kRayDispatchCounters, kRaySetupCounters, kTraverseCounters,
      kHeightL1Counters, kHitQueueCounters, kResultWriterCounters, kDramTraffic, kDramCounters);
  std::ranges::sort(all, {}, &StatisticDefinition::name);
  return all;
}

}  // namespace

std::span<const StatisticDefinition> statistic_definitions() {
  static const std::vector<StatisticDefinition> definitions = all_definitions();
  return definitions;
}

const StatisticDefinition& definition_of(std::string_view path) {
  std::string name(path);
  const size_t open = name.find('['), close = name.find(']');
  if (open != std::string::npos && close != std::string::npos) name.erase(open, close - open + 1);
  for (const StatisticDefinition& row : statistic_definitions()) {
    if (row.name == name) return row;
  }
  throw Error(ExitCode::kInternal, "The statistic '" + std::string(path) + "' has no definition.");
}

}  // namespace cuesta
