#pragma once

#include <cstdint>
#include <optional>

#include "models/heightmap/height_grid.h"
#include "models/oracle/exact_ray.h"
#include "models/rays/hit.h"
#include "models/rays/machine_ray.h"

namespace cuesta {

/// The heights that the oracle looks at: one level of a pyramid, `values[j * width + i]`, level 0 for texels.
struct OracleMap {
  const uint16_t* values = nullptr;
  int width = 1;   ///< nodes of this level along u
  int height = 1;  ///< nodes of this level along v
  int level = 0;
  int64_t highest = 0;  ///< of all values; above level 0: of the texels, where a rising ray gives up
  MapShape shape;       ///< of the whole map, in texels
};

/// A view of `width * height` values at `level` of a map, by its own search for the highest value.
OracleMap oracle_map(const uint16_t* values, int width, int height, int level, const MapShape& shape);
OracleMap oracle_map(const HeightGrid& grid, const MapShape& shape);

/// What a ray finds, exactly. i, j as in HitRecord.
template <class Int>
struct OracleHit {
  bool hit = false;
  int64_t i = 0, j = 0;
  ExactTime<Int> t;
  HitFace face = HitFace::kNone;
  uint64_t visits = 0;  ///< leaf walk: cells looked at
};

/// The cells of one axis, seen from the mirrored frame: node `index` of the map's own frame (unwrapped, rising with
/// place) covers the mirrored planes [lower, upper).
struct OracleSpan {
  int64_t lower = 0, upper = 0;
  int64_t index = 0;
  int stored = 0;  ///< index in the map after the address mode
};
OracleSpan oracle_span(int64_t mirrored_leaf, bool mirrored, int size, int level, AddressMode mode);
/// The span of the node of that `index`.
OracleSpan oracle_span_of_node(int64_t index, bool mirrored, int size, int level, AddressMode mode);

/// (a) From the cell at t_start on, cell by cell: a plane at t_out advances its axis.
template <class Int>
OracleHit<Int> oracle_leaf_walk(const ExactRay<Int>& ray, const OracleMap& map);

/// (b) Every cell of every tile that the ray can meet is asked by itself; of those that answer, the earliest.
/// Nothing when that would be more than `cell_limit` cells.
template <class Int>
std::optional<OracleHit<Int>> oracle_brute_force(const ExactRay<Int>& ray, const OracleMap& map,
                                                 int64_t cell_limit = 1 << 16);

/// As the machine writes it; times are those of OracleInput::kSetup, steps the cells visited.
HitRecord to_record(const OracleHit<Int128>& hit, uint64_t ray_id, int stop_level);

}  // namespace cuesta

#include "models/oracle/oracle_walks.h"
