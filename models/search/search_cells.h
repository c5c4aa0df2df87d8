#pragma once

#include <algorithm>
#include <cstdint>

#include "models/search/search_map.h"
#include "models/search/search_ray.h"

namespace cuesta {

/// The ray among constant texels: which cell it is in at a time, when it leaves the cell, whether it hits it. All by
/// RealArithmetic's plane and height times and the leaf's answer of the exact walk, in the mirrored frame, so that a
/// search that only leaves cells out ends with the bits of the exact walk in the same arithmetic.
template <class Real>
class SearchCells {
 public:
  using A = RealArithmetic<Real>;

  struct Leaf {
    Real t_in, t_out;
    Real t_hit;  ///< when the ray is first under the cell's top; meaningful if that is before t_out
    bool hit;
    HitFace face;
  };

  SearchCells(const SearchRay<Real>& ray, const MapShape& shape, const typename A::Format& format)
      : ray_(&ray),
        format_(&format),
        x_(ray.time_x, ray.x, shape.width),
        y_(ray.time_y, ray.y, shape.height),
        shape_(&shape) {
    go_to(ray.t_start);
  }

  void go_to(Real t) {
    x_.cell = A::cell_at(*x_.line, x_.axis->origin, x_.axis->speed, t, *format_);
    y_.cell = A::cell_at(*y_.line, y_.axis->origin, y_.axis->speed, t, *format_);
  }
  /// Across every plane that lies at `t_out`.
  void cross(Real t_out) {
    const bool cross_x = x_.exit() == t_out, cross_y = y_.exit() == t_out;
    x_.cell += cross_x;
    y_.cell += cross_y;
  }

  /// In the map's own frame, unwrapped.
  int64_t i() const { return x_.real(); }
  int64_t j() const { return y_.real(); }
  bool inside_map() const { return x_.inside() && y_.inside(); }
  int stored_i() const { return stored_index(i(), x_.size, shape_->address_mode); }
  int stored_j() const { return stored_index(j(), y_.size, shape_->address_mode); }

  Leaf ask(int64_t height) const {
    const Real in_x = A::at(*x_.line, x_.cell), in_y = A::at(*y_.line, y_.cell);
    const Real later = std::max(in_x, in_y), t_z = A::at(ray_->time_z, height);
    Leaf leaf;
    leaf.t_in = std::max(ray_->t_start, later);
    leaf.t_out = std::min(x_.exit(), y_.exit());
    const bool rising = ray_->dz > 0;
    leaf.t_hit = rising ? leaf.t_in : std::max(leaf.t_in, t_z);
    leaf.hit = leaf.t_hit < std::min(leaf.t_out, ray_->t_max) && (!rising || leaf.t_in < t_z);
    leaf.face = !rising && t_z >= leaf.t_in ? HitFace::kTop
                : later < ray_->t_start     ? HitFace::kInside
                : in_x >= in_y              ? HitFace::kWallX
                                            : HitFace::kWallY;
    return leaf;
  }

 private:
  struct Axis {
    const typename A::PlaneTime* line;
    const typename SearchRay<Real>::Axis* axis;
    int size;
    int64_t cell = 0;

    Axis(const typename A::PlaneTime& of, const typename SearchRay<Real>::Axis& ray_axis, int texels)
        : line(&of), axis(&ray_axis), size(texels) {}
    Real exit() const { return A::at(*line, cell + 1); }
    int64_t real() const { return axis->back ? size - 1 - cell : cell; }
    bool inside() const { return cell >= 0 && cell < size; }
  };

  const SearchRay<Real>* ray_;
  const typename A::Format* format_;
  Axis x_, y_;
  const MapShape* shape_;
};

}  // namespace cuesta
