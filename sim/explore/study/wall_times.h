#pragma once

#include <functional>
#include <string>

#include "reports/study/study_times.h"

namespace cuesta {

/// Begins times without runs: this host, its load and the build, and the frame that is going to be run.
StudyTimes times_of_this_host(std::string frame);

/// Measures the median wall time of three goes, in seconds.
double median_seconds(const std::function<void()>& go);

}  // namespace cuesta
