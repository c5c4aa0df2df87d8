#pragma once

#include "reports/study/study_data.h"

namespace cuesta::tests {

/// Two maps, two angles, three algorithms; steps(map, angle, algorithm) are given, all other counts follow
/// from them.
inline StudyData example_iterations() {
  StudyData data;
  data.study = "iterations";
  data.question = "Which?";
  data.conditions = {"Made for a test: 1 < 2 & \"so\"."};
  data.axes = {{"size", "texels", "Side.", {"256"}},
               {"map", "", "Map.", {"fractal", "spikes"}},
               {"depth", "tiles", "Depth.", {"0.05"}},
               {"angle", "degrees", "Angle.", {"10", "80"}},
               {"algorithm", "", "Schedule.", {"dda", "oh2006", "yun2013"}}};
  for (const char* name : {"rays", "steps", "steps_median", "steps_p99", "steps_max", "simt_slots", "fetches",
                           "unique_texels", "unique_lines"}) {
    data.counters.push_back({name, "units", "Sentence."});
  }
  constexpr int64_t kSteps[2][2][3] = {{{300, 900, 450}, {4000, 1500, 1200}},
                                       {{200, 800, 320}, {9000, 2000, 1000}}};
  for (uint16_t map = 0; map < 2; ++map) {
    for (uint16_t angle = 0; angle < 2; ++angle) {
      for (uint16_t algorithm = 0; algorithm < 3; ++algorithm) {
        if (map == 1 && angle == 1 && algorithm == 0) continue;  // not planned
        const int64_t steps = kSteps[map][angle][algorithm];
        data.cases.push_back(
            {{0, map, 0, angle, algorithm},
             {100, steps, steps / 100, steps / 50, steps / 10, 2 * steps, steps, steps / 2, 7}});
      }
    }
  }
  data.planned = data.cases.size();
  return data;
}

}  // namespace cuesta::tests
