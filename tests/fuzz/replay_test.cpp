#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/fuzz/targets.h"

namespace cuesta::fuzz {
namespace {

namespace fs = std::filesystem;

class Replay : public ::testing::TestWithParam<Target> {};

std::vector<fs::path> files_of(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<uint8_t> bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return std::vector<uint8_t>(std::istreambuf_iterator<char>(file), {});
}

TEST_P(Replay, SeedsAndFormerFindingsAreReadOrRefused) {
  const std::vector<fs::path> files = files_of(fs::path("tests/fuzz/corpus") / GetParam().name);
  EXPECT_FALSE(files.empty());
  for (const fs::path& file : files) {
    EXPECT_NO_THROW(GetParam().run(bytes_of(file))) << file;
  }
}

TEST_P(Replay, SoIsEveryHeadOfASeed) {
  for (const fs::path& file : files_of(fs::path("tests/fuzz/corpus") / GetParam().name)) {
    const std::vector<uint8_t> bytes = bytes_of(file);
    const size_t step = 1 + bytes.size() / 16;
    for (size_t size = 0; size < bytes.size(); size += step) {
      EXPECT_NO_THROW(GetParam().run(Bytes(bytes).first(size))) << file << " cut to " << size;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, Replay, ::testing::ValuesIn(kTargets),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace
}  // namespace cuesta::fuzz
