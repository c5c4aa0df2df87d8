#include "sim/explore/accuracy/picture_error.h"

#include <gtest/gtest.h>

#include <vector>

namespace cuesta {
namespace {

constexpr int kSide = 16;

TEST(PictureError, EqualPicturesHaveNone) {
  std::vector<double> picture;
  for (int k = 0; k < kSide * kSide; ++k) picture.push_back(k % 7 / 7.0);
  const PictureError error = picture_error(picture, picture, kSide);
  EXPECT_EQ(error.psnr, 100'00);
  EXPECT_EQ(error.ssim, 1'000'000);
}

TEST(PictureError, AConstantOffsetGivesTheNumbersWorkedByHand) {
  const std::vector<double> truth(kSide * kSide, 0.5), found(kSide * kSide, 0.6);
  const PictureError error = picture_error(truth, found, kSide);
  EXPECT_EQ(error.psnr, 20'00);  // mean square 0.01
  // No variance: (2 * 0.5 * 0.6 + 0.0001) / (0.25 + 0.36 + 0.0001) = 0.6001 / 0.6101
  EXPECT_EQ(error.ssim, 983'609);
}

TEST(PictureError, APictureTurnedOverIsNotSimilar) {
  std::vector<double> truth, found;
  for (int k = 0; k < kSide * kSide; ++k) {
    truth.push_back(k % 2);
    found.push_back(1 - k % 2);
  }
  const PictureError error = picture_error(truth, found, kSide);
  EXPECT_EQ(error.psnr, 0);
  EXPECT_EQ(error.ssim, 0);
}

}  // namespace
}  // namespace cuesta
