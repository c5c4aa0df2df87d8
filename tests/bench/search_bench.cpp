#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "models/heightmap/generator.h"
#include "models/heightmap/pyramid.h"
#include "models/search/preprocessing.h"
#include "models/search/search_map.h"

// How long a search's map takes to make, one thread: 8 and 16 bits, every kind of generated map, wrapped.
//
//   search_bench [SIDE]      default: 1024

namespace cuesta {
namespace {

int print_table(int side) {
  std::printf("%d x %d, wrapped\n%-10s %5s %-14s %9s %14s %14s\n", side, side, "map", "bits", "search",
              "seconds", "reads/texel", "bytes/texel");
  for (const char* kind : {"fractal", "noise", "spikes", "rocks", "text"}) {
    for (const int bits : {8, 16}) {
      const Pyramid pyramid = build_max_pyramid(generate(kind, side, side, bits));
      for (const SearchKind search :
           {SearchKind::kCone, SearchKind::kRelaxedCone, SearchKind::kSafetyRadius, SearchKind::kDistance}) {
        const auto start = std::chrono::steady_clock::now();
        const SearchMap map({search}, pyramid, AddressMode::kWrap);
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const double texels = static_cast<double>(side) * side;
        std::printf("%-10s %5d %-14s %9.2f %14.1f %14.1f\n", kind, bits,
                    std::string(search_rows()[static_cast<size_t>(search)].id).c_str(), seconds,
                    static_cast<double>(map.cost().texels_read) / texels,
                    static_cast<double>(map.size_bytes()) / texels);
        std::fflush(stdout);
      }
    }
  }
  return 0;
}

}  // namespace
}  // namespace cuesta

int main(int argc, char** argv) {
  const int side = argc > 1 ? std::atoi(argv[1]) : 1024;
  if (argc > 2 || side < 1 || side > 16384) {
    std::fprintf(stderr, "usage: search_bench [SIDE], 1 to 16384\n");
    return 2;
  }
  return cuesta::print_table(side);
}
