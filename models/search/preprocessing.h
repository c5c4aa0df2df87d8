#pragma once

#include <cstdint>
#include <vector>

#include "models/heightmap/pyramid.h"
#include "models/rays/machine_ray.h"
#include "models/search/feature_search.h"

// The bytes that a SearchMap adds to the heights, each a pure function of heights and address mode.

namespace cuesta {

struct Preprocessed {
  std::vector<uint8_t> bytes;
  uint64_t texels_read = 0;  ///< heights and pyramid nodes looked at
};

/// Cones (Dummer 2006): from the centre of each texel at its own height, the widest cone that no higher texel reaches
/// into: the smallest distance / (h' - h) over all higher texels h' of map and repetitions, distance to the nearest
/// point of the constant texel. Found through the max pyramid; equal to asking every texel.
Preprocessed make_cone_map(const Pyramid& max_pyramid, AddressMode mode);

/// Relaxed cones (Policarpo & Oliveira 2007), generated from their definition (ours; published generators sample rays
/// and give cones too wide, EGSR 2024): the widest cone of which no ray that starts on its axis above the texel and
/// does not rise leaves the surface again inside. On constant texels such a ray leaves where the surface steps down,
/// away from the texel: the smallest distance / (h' - h) over the edges and corners, outward, of higher texels h'
/// with a lower neighbour behind. Border mode: nothing lies behind the map's edge, which is lower than any texel.
Preprocessed make_relaxed_cone_map(const Pyramid& max_pyramid, AddressMode mode);

/// Safety radii (Baboud & Decoret 2006; the definition reconstructed, its form on constant texels ours): around the
/// centre of each texel, how far a ray that passes above it and does not rise pierces the surface once at most. The
/// texel itself is left out: a search knows its height. As the relaxed cone's edges, whatever their height.
Preprocessed make_safety_radii(const Pyramid& max_pyramid, AddressMode mode);

/// Distances (Donnelly 2005): distance_field.cpp.
Preprocessed make_distance_field(const Pyramid& max_pyramid, AddressMode mode);

/// Height of the slab in the distance field's metric: an eighth of the longer tile side, in texels (ours: near the
/// depth of usual scenes). One step of a distance byte is this / 255.
inline double distance_slab_texels(int width, int height) { return (width > height ? width : height) / 8.0; }

/// The largest byte b with (b / 255)^2 <= (distance / longer side) / (rise / full scale); 255 where there is no line.
uint8_t cone_byte(const FlattestLine& line, int longer_side, uint32_t full_scale);

}  // namespace cuesta
