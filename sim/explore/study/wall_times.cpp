#include "sim/explore/study/wall_times.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "models/common/build_info.h"
#include "sim/session/host_facts.h"

namespace cuesta {

StudyTimes times_of_this_host(std::string frame) {
  StudyTimes times;
  times.host = host_name();
  times.processor = processor_name();
  times.load = load_average();
  times.date = time_now("%Y-%m-%d");
  times.build = std::string(build_info().compiler) + ", " + std::string(build_info().flags);
  times.frame = std::move(frame);
  return times;
}

double median_seconds(const std::function<void()>& go) {
  std::array<double, 3> seconds{};
  for (double& one : seconds) {
    const auto start = std::chrono::steady_clock::now();
    go();
    one = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[1];
}

}  // namespace cuesta
