#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "models/common/random.h"
#include "models/heightmap/generator.h"
#include "models/heightmap/pyramid.h"
#include "models/search/preprocessing.h"
#include "models/search/search_map.h"
#include "tests/models/search/brute_force.h"

// How long a search's map takes to make, one thread: 8 and 16 bits, several kinds of generated maps, wrapped; and
// SAMPLES texels of each against brute force over the map and its copies (seconds a texel at 1024 x 1024).
//
//   search_bench [SIDE [SAMPLES]]      default: 1024 2

namespace cuesta {
namespace {

/// Texels drawn at random, each held against brute force over all texels of the map and its copies.
std::string check_samples(const HeightGrid& grid, const SearchMap& map, SearchKind kind, int samples) {
  if (kind == SearchKind::kDistance) return "-";
  Random random(7);
  int wrong = 0;
  for (int k = 0; k < samples; ++k) {
    const auto i = static_cast<int>(random.below(static_cast<uint64_t>(grid.width)));
    const auto j = static_cast<int>(random.below(static_cast<uint64_t>(grid.height)));
    const long double ratio = kind == SearchKind::kCone ? brute_cone(grid, AddressMode::kWrap, i, j)
                              : kind == SearchKind::kRelaxedCone
                                  ? brute_relaxed_cone(grid, AddressMode::kWrap, i, j)
                                  : brute_radius(grid, AddressMode::kWrap, i, j);
    wrong += !is_rounded_down(map.added_at(i, j), ratio);
  }
  return std::to_string(wrong) + " of " + std::to_string(samples) + " wrong";
}

int print_table(int side, int samples) {
  std::printf("%d x %d, wrapped\n%-10s %5s %-14s %9s %14s %14s\n", side, side, "map", "bits", "search",
              "seconds", "reads/texel", "bytes/texel");
  for (const char* kind : {"fractal", "noise", "spikes", "rocks", "text"}) {
    for (const int bits : {8, 16}) {
      const HeightGrid grid = generate(kind, side, side, bits);
      const Pyramid pyramid = build_max_pyramid(grid);
      for (const SearchKind search :
           {SearchKind::kCone, SearchKind::kRelaxedCone, SearchKind::kSafetyRadius, SearchKind::kDistance}) {
        const auto start = std::chrono::steady_clock::now();
        const std::clock_t cpu = std::clock();
        const SearchMap map({search}, pyramid, AddressMode::kWrap);
        const double cpu_seconds = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const double texels = static_cast<double>(side) * side;
        std::printf("%-10s %5d %-14s %9.2f %9.2f %12.1f %12.1f   %s\n", kind, bits,
                    std::string(search_rows()[static_cast<size_t>(search)].id).c_str(), seconds, cpu_seconds,
                    static_cast<double>(map.cost().texels_read) / texels,
                    static_cast<double>(map.size_bytes()) / texels,
                    check_samples(grid, map, search, samples).c_str());
        std::fflush(stdout);
      }
    }
  }
  return 0;
}

}  // namespace
}  // namespace cuesta

int main(int argc, char** argv) {
  const int side = argc > 1 ? std::atoi(argv[1]) : 1024, samples = argc > 2 ? std::atoi(argv[2]) : 2;
  if (argc > 3 || side < 1 || side > 16384 || samples < 0) {
    std::fprintf(stderr, "usage: search_bench [SIDE [SAMPLES]], 1 to 16384\n");
    return 2;
  }
  return cuesta::print_table(side, samples);
}
