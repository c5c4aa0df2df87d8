#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "sim/session/measure.h"
#include "sim/session/progress.h"

namespace cuesta {

/// Which signals of the hardware are wanted, and where: those of the cycles given, or from dispatch to completion of
/// the rays of a pixel, or of the first thousand cycles.
struct WaveRequest {
  std::string file;                                   ///< a new FST file; empty: none
  std::optional<std::pair<int64_t, int64_t>> cycles;  ///< first and last
  std::optional<std::pair<int64_t, int64_t>> pixel;   ///< x and y
  int pipeline = 0;  ///< whose hardware; a pixel is shown in its own pipeline

  bool wanted() const { return !file.empty(); }
};

/// Makes what runs a machine and writes the waves. A pixel's cycles are found by a run of the model before. What was
/// written, or that nothing was, is a remark to `observer`, which must outlive the runner. The runner throws
/// usage_error for a pixel without rays and for a pipeline that the machine does not have.
CycleRunner wave_runner(const WaveRequest& waves, Observer& observer);

}  // namespace cuesta
