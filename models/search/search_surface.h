#pragma once

#include <cstdint>

#include "models/search/search_map.h"
#include "models/search/search_ray.h"

namespace cuesta {

/// The surface as samples see it. kTexel: the texel that holds the point, one record read. kBilinear: between the four
/// nearest texel centres, four records read, row by row; the record's added byte is filtered alike, as a texture unit
/// does. Neighbours go through the address mode; in border mode, where every sample lies inside the map, as clamp.
template <class Real>
class SearchSurface {
 public:
  struct Sample {
    Real height;
    Real added;  ///< the byte that the map adds to a height
  };

  SearchSurface(const SearchMap& map, SearchFilter filter) : map_(&map), filter_(filter) {}

  const SearchMap& map() const { return *map_; }
  bool bilinear() const { return filter_ == SearchFilter::kBilinear; }

  /// The cell of a point, unwrapped; in border mode the nearest one inside: what lies beyond is rounding.
  int64_t cell_x(const SearchPoint<Real>& point) const { return inside(point.cell_x(), map_->width()); }
  int64_t cell_y(const SearchPoint<Real>& point) const { return inside(point.cell_y(), map_->height()); }

  /// One sample of heights.
  template <class Sink>
  Real height(const SearchPoint<Real>& point, Sink& sink) const {
    return blend(point, [&](int i, int j) {
      sink.read(map_->offset(i, j));
      return static_cast<Real>(map_->height_at(i, j));
    });
  }

  /// One sample of heights and what the map adds to them.
  template <class Sink>
  Sample both(const SearchPoint<Real>& point, Sink& sink) const {
    Sample sample;
    sample.height = height(point, sink);
    sample.added = blend(point, [&](int i, int j) { return static_cast<Real>(map_->added_at(i, j)); });
    return sample;
  }

  /// One sample of a layer of the distance field, in its byte's unit.
  template <class Sink>
  Real distance(const SearchPoint<Real>& point, int layer, Sink& sink) const {
    return blend(point, [&](int i, int j) {
      sink.read(map_->offset(i, j, layer));
      return static_cast<Real>(map_->distance_at(i, j, layer));
    });
  }

 private:
  int64_t inside(int64_t k, int size) const {
    if (map_->address_mode() != AddressMode::kBorder) return k;
    return k < 0 ? 0 : k >= size ? size - 1 : k;
  }

  template <class At>
  Real blend(const SearchPoint<Real>& point, At&& at) const {
    const AddressMode mode = map_->address_mode();
    const int width = map_->width(), height = map_->height();
    if (!bilinear())
      return at(stored_index(cell_x(point), width, mode), stored_index(cell_y(point), height, mode));
    const Real u = point.x - Real{0.5}, v = point.y - Real{0.5};
    const int64_t i = floor_of(u), j = floor_of(v);
    const Real a = u - static_cast<Real>(i), b = v - static_cast<Real>(j);
    const int i0 = stored_index(i, width, mode), i1 = stored_index(i + 1, width, mode);
    const int j0 = stored_index(j, height, mode), j1 = stored_index(j + 1, height, mode);
    const Real h00 = at(i0, j0), h10 = at(i1, j0), h01 = at(i0, j1), h11 = at(i1, j1);
    const Real low = h00 + (h10 - h00) * a, high = h01 + (h11 - h01) * a;
    return low + (high - low) * b;
  }

  const SearchMap* map_;
  SearchFilter filter_;
};

}  // namespace cuesta
