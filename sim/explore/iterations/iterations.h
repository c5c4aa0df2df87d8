#pragma once

#include "sim/explore/study/study.h"

namespace cuesta {

/// How many steps, and how unlike each other, does each schedule take? Functional; no time.
StudyData iterations_plan(bool quick);
bool iterations_planned(const StudyData& plan, const StudyPlace& place);
std::unique_ptr<StudyBench> make_iterations_bench(const StudyData& plan,
                                                  std::span<const uint16_t> size_and_map);

}  // namespace cuesta
