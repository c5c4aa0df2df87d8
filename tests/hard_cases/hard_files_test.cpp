#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <optional>

#include "models/common/error.h"
#include "models/common/random.h"
#include "tests/hard_cases/catalogue.h"
#include "tests/hard_cases/hard_check.h"
#include "tests/support/temporary_folder.h"
#include "traces/heightmaps/height_source_text.h"
#include "traces/heightmaps/image_reader.h"

// Float maps with what no height can be: refused with a sentence, or heights like any other.

namespace cuesta {
namespace {

class HardFiles : public ::testing::Test {
 protected:
  HeightSource write(const HardFile& file) const {
    HeightSource source;
    source.path = folder_.path("map.r32");
    std::ofstream out(source.path, std::ios::binary);
    for (const float height : file.heights) {
      char bytes[4];
      std::memcpy(bytes, &height, 4);
      out.write(bytes, 4);
    }
    source.raw = parse_raw_shape("4x4:float", "the test");
    if (!file.nodata.empty()) source.nodata = parse_nodata(std::string(file.nodata), "the test");
    return source;
  }
  TemporaryFolder folder_;
};

TEST_F(HardFiles, AreRefusedWithASentenceOrTraversedExactly) {
  for (const HardFile& file : hard_files()) {
    std::optional<LoadedHeights> loaded;
    try {
      loaded = load_heights(write(file));
    } catch (const Error& error) {
      const std::string sentence = error.what();
      EXPECT_EQ(error.code(), ExitCode::kInput) << file.name;
      ASSERT_FALSE(file.refused.empty()) << file.name << ": " << sentence;
      EXPECT_NE(sentence.find(file.refused), std::string::npos) << file.name << ": " << sentence;
      continue;
    }
    EXPECT_TRUE(file.refused.empty()) << file.name;
    HardCounts counts;
    HardChecker checker(std::move(loaded->grid), AddressMode::kWrap, {8, 32, 20, 4}, true);
    Random random(3);
    for (int k = 0; k < 40; ++k) {
      TracedRay ray;
      for (double& place : ray.origin) place = random.unit();
      for (double& along : ray.direction) along = random.unit() - 0.5;
      checker.check_exact(ray, 0, counts);
      checker.check_searches(ray, counts);
      checker.check_bilinear(ray, counts);
    }
    EXPECT_EQ(counts.faults(), 0) << file.name << ": " << counts.first_failure;
  }
}

}  // namespace
}  // namespace cuesta
