#include "sim/explore/accuracy/picture_error.h"

#include <algorithm>
#include <cmath>

#include "models/common/elementary.h"

namespace cuesta {
namespace {

constexpr int kWindow = 8, kStride = 4;

/// Gives the structural similarity of one window of two pictures.
double similarity(std::span<const double> a, std::span<const double> b, int width, int x, int y) {
  constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03, kPixels = kWindow * kWindow;
  double sum_a = 0, sum_b = 0, square_a = 0, square_b = 0, product = 0;
  for (int j = y; j < y + kWindow; ++j) {
    for (int i = x; i < x + kWindow; ++i) {
      const size_t at = static_cast<size_t>(j) * static_cast<size_t>(width) + static_cast<size_t>(i);
      sum_a += a[at];
      sum_b += b[at];
      square_a += a[at] * a[at];
      square_b += b[at] * b[at];
      product += a[at] * b[at];
    }
  }
  const double mean_a = sum_a / kPixels, mean_b = sum_b / kPixels;
  const double variance_a = square_a / kPixels - mean_a * mean_a;
  const double variance_b = square_b / kPixels - mean_b * mean_b;
  const double covariance = product / kPixels - mean_a * mean_b;
  return (2 * mean_a * mean_b + kC1) * (2 * covariance + kC2) /
         ((mean_a * mean_a + mean_b * mean_b + kC1) * (variance_a + variance_b + kC2));
}

}  // namespace

PictureError picture_error(std::span<const double> truth, std::span<const double> found, int width) {
  constexpr int64_t kMostPsnr = 100'00;
  double squares = 0;
  for (size_t k = 0; k < truth.size(); ++k) squares += (truth[k] - found[k]) * (truth[k] - found[k]);
  const double mean = squares / static_cast<double>(std::max<size_t>(1, truth.size()));
  PictureError error;
  error.psnr = kMostPsnr;
  if (mean > 0) {
    constexpr double kLog10Of2 = 0.30102999566398119521;
    const double decibels = -10 * kLog10Of2 * elementary::log2(mean);
    error.psnr = std::clamp<int64_t>(std::llround(100 * decibels), 0, kMostPsnr);
  }
  const int height = static_cast<int>(truth.size()) / width;
  double sum = 0;
  int64_t windows = 0;
  for (int y = 0; y + kWindow <= height; y += kStride) {
    for (int x = 0; x + kWindow <= width; x += kStride, ++windows)
      sum += similarity(truth, found, width, x, y);
  }
  if (windows > 0) error.ssim = std::max<int64_t>(0, std::llround(1e6 * sum / static_cast<double>(windows)));
  return error;
}

}  // namespace cuesta
