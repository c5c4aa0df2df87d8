#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>

#include "tests/hard_cases/catalogue.h"
#include "tests/hard_cases/hard_cases.h"

namespace cuesta {
namespace {

TEST(HardCaseCatalogue, ReadmeSaysWhatTheTablesHold) {
  const char* path = "tests/hard_cases/README.md";
  if (std::getenv("CUESTA_WRITE_CATALOGUE") != nullptr) std::ofstream(path, std::ios::binary) << catalogue();
  std::ifstream file(path, std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), catalogue())
      << "CUESTA_WRITE_CATALOGUE=1 writes it anew";
}

TEST(HardCaseCatalogue, MapsAreWhatTheyAreEveryTimeAndHaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const HardMap& map : hard_maps()) {
    EXPECT_TRUE(names.insert(map.name).second) << map.name;
    const HeightGrid grid = map.make();
    EXPECT_EQ(grid.texels, map.make().texels) << map.name;
    EXPECT_EQ(grid.texels.size(), static_cast<size_t>(grid.width) * static_cast<size_t>(grid.height))
        << map.name;
  }
  for (const HardRays& rays : hard_rays()) EXPECT_TRUE(names.insert(rays.name).second) << rays.name;
}

}  // namespace
}  // namespace cuesta
