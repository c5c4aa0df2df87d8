#include "sim/verify/lockstep/difference.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <tuple>

namespace cuesta {
namespace {

constexpr std::array<std::string_view, 9> kUnits = {"ray_dispatch", "ray_setup", "traverse",
                                                    "height_l1",    "hit_queue", "result_writer",
                                                    "dram",         "ray",       "machine"};
/// Fields of ports; all others are counters and fills.
constexpr std::array<std::string_view, 3> kPorts = {"entry", "request", "hit"};

/// What is computed from other counters.
constexpr std::array<std::string_view, 3> kDerived = {"fill_bytes", "cycles", "line_accesses"};

auto rank(const Difference& difference) {
  const std::string_view unit = std::string_view(difference.unit).substr(0, difference.unit.find('['));
  const std::string_view field = std::string_view(difference.field).substr(0, difference.field.find('.'));
  const auto place = std::ranges::find(kUnits, unit) - kUnits.begin();
  const int kind = std::ranges::count(kPorts, field) > 0     ? 0
                   : std::ranges::count(kDerived, field) > 0 ? 2
                                                             : 1;
  return std::tuple(difference.cycle, place, kind);
}

std::string line(const Difference& difference, const std::string (&names)[2]) {
  return fmt::format("{}.{}: {} {}; {} {}", difference.unit, difference.field, names[0], difference.values[0],
                     names[1], difference.values[1]);
}

}  // namespace

Difference difference_of(const std::string& path, Cycle cycle) {
  const size_t dot = path.find('.');
  Difference difference;
  difference.cycle = cycle;
  difference.unit = path.substr(0, dot);
  difference.field = path.substr(dot + 1);
  return difference;
}

std::string decoded(int64_t value) { return fmt::format("{} ({:#x})", value, static_cast<uint64_t>(value)); }

void sort_by_cause(std::vector<Difference>& differences) {
  std::ranges::stable_sort(differences,
                           [](const Difference& a, const Difference& b) { return rank(a) < rank(b); });
}

std::string report(const std::vector<Difference>& differences, const std::string (&names)[2], size_t most) {
  if (differences.empty()) return "no difference\n";
  const Difference& first = differences.front();
  std::string text =
      fmt::format("first difference: cycle {}, {}, {}\n  {:<8}{}\n  {:<8}{}\n", first.cycle, first.unit,
                  first.field, names[0], first.values[0], names[1], first.values[1]);
  const auto with_ray = std::ranges::find_if(differences, [](const Difference& d) { return !d.ray.empty(); });
  if (with_ray != differences.end()) text += "  ray     " + with_ray->ray + "\n";
  const size_t shown = std::min(differences.size(), most);
  if (shown > 1) text += "in the same cycle:\n";
  for (size_t k = 1; k < shown; ++k) text += "  " + line(differences[k], names) + "\n";
  if (differences.size() > shown) text += fmt::format("  and {} more\n", differences.size() - shown);
  return text;
}

}  // namespace cuesta
