#include "sim/cli/map_size.h"

#include <gtest/gtest.h>

#include "models/common/error.h"

namespace cuesta {
namespace {

TEST(MapSize, OneSideOrTwoAreReadWholeOrRefused) {
  int width = 0, height = 0;
  parse_map_size("640x480", width, height);
  EXPECT_EQ(width, 640);
  EXPECT_EQ(height, 480);
  parse_map_size("16384", width, height);
  EXPECT_EQ(width, 16384);
  EXPECT_EQ(height, 16384);
  for (const char* wrong :
       {"", "x", "0", "-4", "4x", "x4", "4x4x4", "16385", "4 x 4", "1e3", "99999999999"}) {
    EXPECT_THROW(parse_map_size(wrong, width, height), Error) << wrong;
  }
}

}  // namespace
}  // namespace cuesta
