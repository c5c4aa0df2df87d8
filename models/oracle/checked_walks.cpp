#include "models/oracle/checked_walks.h"

#include <array>

namespace cuesta {

std::string describe(const HitRecord& r) {
  if (r.status == HitStatus::kDidNotFinish) return "did not finish";
  if (r.status != HitStatus::kHit) return "miss, " + std::to_string(r.steps) + " steps";
  constexpr std::array<std::string_view, 5> kFaces = {"none", "top", "wall x", "wall y", "inside"};
  return "hit (" + std::to_string(r.i) + ", " + std::to_string(r.j) + "), t " + std::to_string(r.t) + ", " +
         std::string(kFaces[static_cast<size_t>(r.face)]) + ", " + std::to_string(r.steps) + " steps";
}

std::string describe(const Schedule& s) {
  return "start " + std::string(name_of(s.start)) + ", down " + std::string(name_of_down(s.down)) + ", up " +
         std::string(name_of(s.up)) + ", stop " + std::to_string(s.stop_level);
}

bool same_answer(const HitRecord& a, const HitRecord& b) {
  return a.status == b.status && a.i == b.i && a.j == b.j && a.t == b.t && a.face == b.face;
}

std::vector<Schedule> checked_schedules(bool all_combinations, int stop_level) {
  std::vector<Schedule> list;
  for (const Algorithm& algorithm : algorithms()) list.push_back(algorithm.schedule);
  for (const Algorithm& part : algorithm_parts()) list.push_back(part.schedule);
  if (all_combinations) {
    for (int start = 0; start < 3; ++start) {
      for (const int down : kDownValues) {
        for (int up = 0; up < 8; ++up) {
          list.push_back({static_cast<StartRule>(start), down, static_cast<UpRule>(up), 0});
        }
      }
    }
  }
  for (Schedule& schedule : list) schedule.stop_level = stop_level;
  return list;
}

}  // namespace cuesta
