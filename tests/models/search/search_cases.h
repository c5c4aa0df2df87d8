#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include "models/common/error.h"
#include "models/heightmap/pyramid.h"
#include "models/oracle/oracle.h"
#include "models/oracle/random_cases.h"
#include "models/oracle/verdict.h"
#include "models/search/search_walk.h"

// What the searches' tests share: a map with its pyramid, a ray's search with everything that it read, the exact
// answer.

namespace cuesta {

/// Collects the reads of each step and refuses what no step may do.
struct RecordingSink {
  uint64_t size_bytes = 0;
  int most_reads = 1;
  int reads = 0, computes = 0;  ///< of the step that is open
  std::vector<int> steps;       ///< reads of each; 0: a slot without memory
  std::vector<uint64_t> offsets;

  void read(uint64_t offset) {
    if (offset >= size_bytes) throw std::logic_error("read beyond the map");
    ++reads;
    offsets.push_back(offset);
  }
  void compute() { ++computes; }
  void end_step() {
    if (reads + computes == 0) throw std::logic_error("an empty step");
    if (reads > most_reads || computes > 1) throw std::logic_error("too much in a step");
    steps.push_back(reads);
    reads = computes = 0;
  }
};

struct SearchCase {
  HeightGrid grid;
  MapShape shape;
  NumberFormat format;
  Pyramid pyramid;

  SearchCase(HeightGrid heights, AddressMode mode, const NumberFormat& number)
      : grid(std::move(heights)), format(number), pyramid(build_max_pyramid(grid)) {
    shape = {grid.width, grid.height, pyramid.root_level(), grid.bits, mode};
  }
  explicit SearchCase(const RandomMap& map) : SearchCase(map.grid, map.shape.address_mode, map.format) {}
};

struct SearchAnswer {
  HitRecord hit;
  RecordingSink sink;
  long double t = 0;  ///< of a hit, in machine time units
};

template <class Real>
SearchAnswer run_search(const SearchCase& c, const Search& search, const SearchMap& map,
                        const MachineRay& ray, double depth = 0.1) {
  SearchAnswer answer;
  answer.sink.size_bytes = map.size_bytes();
  answer.sink.most_reads = search.filter == SearchFilter::kBilinear ? 4 : 1;
  const Searcher<Real> searcher(search, map, c.shape, c.format, depth);
  const Arithmetic times = sizeof(Real) == 4 ? Arithmetic::kFloat : Arithmetic::kDouble;
  answer.hit = searcher.trace(ray, times, answer.sink);
  const auto format = RealArithmetic<Real>::format(c.shape, c.format);
  const double t = sizeof(Real) == 4
                       ? static_cast<double>(std::bit_cast<float>(static_cast<uint32_t>(answer.hit.t)))
                       : std::bit_cast<double>(answer.hit.t);
  answer.t = static_cast<long double>(t) / static_cast<long double>(format.unit_of_time);
  return answer;
}

/// The exact answer of the machine's own ray.
struct SearchTruth {
  ExactRay<Int128> ray;
  OracleMap map;
  OracleHit<Int128> hit;
  long double t = 0;  ///< of a hit, in machine time units

  SearchTruth(const SearchCase& c, const MachineRay& input)
      : ray(exact_ray(input, c.shape, c.format, OracleInput::kMachineInput)),
        map(oracle_map(c.grid, c.shape)),
        hit(oracle_leaf_walk(ray, map)) {
    if (hit.hit) t = ray.in_machine_units(hit.t);
  }
  Verdict verdict(const SearchAnswer& answer) const {
    return judge(ray, map, hit, {answer.hit.status == HitStatus::kHit, answer.hit.i, answer.hit.j, answer.t});
  }
};

/// A random ray on the machine's grid; nothing when it starts beyond the format's tiles.
inline std::optional<MachineRay> random_machine_ray(Random& random, const RandomMap& map, uint64_t id) {
  try {
    return quantise(random_ray(random, map, id), map.shape, map.format);
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// A ray in tile units.
inline MachineRay ray_from(const SearchCase& c, double u, double v, double z, double du, double dv,
                           double dz) {
  TracedRay ray;
  ray.origin[0] = u;
  ray.origin[1] = v;
  ray.origin[2] = z;
  ray.direction[0] = du;
  ray.direction[1] = dv;
  ray.direction[2] = dz;
  return quantise(ray, c.shape, c.format);
}

inline HeightGrid flat_grid(int width, int height, int bits, uint16_t value) {
  HeightGrid grid{width, height, bits, {}};
  grid.texels.assign(static_cast<size_t>(width) * static_cast<size_t>(height), value);
  return grid;
}

}  // namespace cuesta
