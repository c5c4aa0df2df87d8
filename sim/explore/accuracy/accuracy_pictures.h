#pragma once

#include <vector>

#include "reports/study/study_data.h"

namespace cuesta {

/// Shows what errors look like: depth, steps and wrong pixels of several algorithms side by side. `quick`:
/// smaller.
std::vector<StudyPicture> accuracy_pictures(bool quick);

}  // namespace cuesta
