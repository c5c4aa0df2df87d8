#pragma once

#include <cstdint>
#include <span>

namespace cuesta {

/// How one picture differs from another of the same size, both with values from 0 to 1, row by row.
struct PictureError {
  /// Peak signal-to-noise ratio, 10 log10(1 / mean square error) dB, in 1/100 dB; at most 100 dB.
  int64_t psnr = 0;
  int64_t ssim = 0;  ///< in millionths: structural similarity, 1,000,000 for equal pictures; below 0: 0
};

/// Compares them; SSIM after Wang, Bovik, Sheikh, Simoncelli 2004 (its constants K1 = 0.01, K2 = 0.03), with
/// the mean over windows of 8 x 8 pixels every 4 pixels in the place of its Gaussian window: ours. The same
/// bits on every host.
PictureError picture_error(std::span<const double> truth, std::span<const double> found, int width);

}  // namespace cuesta
