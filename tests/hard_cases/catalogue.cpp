#include "tests/hard_cases/catalogue.h"

#include <limits>

#include "tests/hard_cases/found_cases.h"
#include "tests/hard_cases/hard_cases.h"

namespace cuesta {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::vector<float> slope_with(std::vector<float> odd) {
  std::vector<float> heights(16);
  for (size_t k = 0; k < heights.size(); ++k) heights[k] = static_cast<float>(k) / 15;
  for (size_t k = 0; k < odd.size(); ++k) heights[3 * k + 2] = odd[k];
  return heights;
}

constexpr std::string_view kHead =
    "# Hard cases\n\n"
    "Maps, rays and numbers on which heightmap traversals have failed, each with its reason; a case is one "
    "of each in one\n"
    "address mode. `hard_cases_test` (label `hard`) runs every algorithm over all of them: exact schedules "
    "in fixed point\n"
    "against rational arithmetic, in float and double against the leaf walk to the bit, stopped at every "
    "level, over texels\n"
    "and bilinear patches; approximate searches against their guarantee, or counted by verdict. It prints "
    "its counts.\n"
    "CUESTA_HARD_EVERY=N takes one ray in N (1: all), CUESTA_HARD_ROUNDS=N makes N times as many.\n\n"
    "The tables are those of `hard_maps.cpp`, `hard_rays.cpp` and `catalogue.cpp`; `CUESTA_WRITE_CATALOGUE=1 "
    "ctest -R\n"
    "Catalogue` in the build folder writes this file anew. What is said of no listing "
    "or paper is ours.\n";

template <class Row>
std::string table(std::string_view title, std::string_view first, std::span<const Row> rows) {
  std::string text =
      "\n## " + std::string(title) + "\n| " + std::string(first) + " | holds | reason |\n|---|---|---|\n";
  for (const Row& row : rows) {
    text += "| " + std::string(row.name) + " | " + std::string(row.holds) + " | " + std::string(row.reason) +
            " |\n";
  }
  return text;
}

}  // namespace

std::span<const HardFile> hard_files() {
  static const std::vector<HardFile> files = {
      {"NaN", "one NaN among floats", "one texel would poison every maximum above it, or vanish from them",
       slope_with({kNan}), "", "NaN"},
      {"NaN as no data", "two NaN, named as cells without data", "they become height 0 and are counted",
       slope_with({kNan, kNan}), "nan", ""},
      {"infinity", "one +infinity", "normalised, it would flatten all others to 0", slope_with({kInfinity}),
       "", "infinity"},
      {"minus infinity", "one -infinity", "the same from below", slope_with({-kInfinity}), "", "infinity"},
      {"NaN and infinity", "both, of which NaN is named", "naming one does not excuse the other",
       slope_with({kNan, kInfinity}), "nan", "infinity"},
      {"all NaN", "nothing but NaN, named", "no number is left to say what 0 and full scale are",
       std::vector<float>(16, kNan), "nan", "no data"},
      {"all NaN, unnamed", "nothing but NaN", "as one NaN", std::vector<float>(16, kNan), "", "NaN"},
      {"denormal floats", "0 to 1e-38, and 1e-45", "a range that underflows when it is divided",
       slope_with({1e-38F, 1e-45F}), "", ""},
      {"huge floats", "-1e29 to 1e29", "all else becomes one height", slope_with({-1e29F, 1e29F}), "", ""},
      {"lowest float", "-3e38", "a marker of cells without data, more likely than a height",
       slope_with({-3e38F}), "", "the extreme marks cells without data"},
      {"minus zero", "-0.0 among 0 to 1", "must not count as negative", slope_with({-0.0F}), "", ""},
  };
  return files;
}

std::string catalogue() {
  std::string text(kHead);
  text += table("Maps", "map", hard_maps());
  text +=
      "| the largest | 16384 x 16384, 16 bits, spikes over low ground | indices of 28 bits; optimised builds "
      "only |\n";
  text += table("Rays", "rays", hard_rays());
  text += table("Rays over a million tiles, on maps of one texel", "rays", std::span(&far_rays(), 1));
  text += table("Numbers", "format", hard_numbers());
  text += table("Numbers for a million tiles", "format", std::span(&far_numbers(), 1));
  text += table("Files of floats (`hard_files_test`)", "file", hard_files());
  text += found_table();
  return text;
}

}  // namespace cuesta
