#pragma once

#include <array>
#include <limits>
#include <vector>

#include "models/common/random.h"
#include "tests/hard_cases/hard_cases.h"

namespace cuesta {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kSmallest = 5e-324;  ///< above 0, denormal

/// Adds rays given in texels and height LSBs, so that what is whole stays whole on the machine's grid.
class Rays {
 public:
  Rays(Random& random, const HardPlace& place, std::vector<TracedRay>& rays)
      : random_(random), place_(place), rays_(rays) {}

  double width() const { return place_.grid.width; }
  double height() const { return place_.grid.height; }
  double full() const { return static_cast<double>(place_.grid.full_scale()); }
  /// The smallest step of an origin.
  double grid_step() const { return 1.0 / static_cast<double>(int64_t{1} << place_.format.fraction_bits); }

  /// A texel to stand on, another with every call.
  void pick() {
    i_ = static_cast<int>(random_.below(static_cast<uint64_t>(place_.grid.width)));
    j_ = static_cast<int>(random_.below(static_cast<uint64_t>(place_.grid.height)));
  }
  double i() const { return i_; }
  double j() const { return j_; }
  double top() const { return place_.grid.at(i_, j_); }
  /// Of the texel `di`, `dj` further, the map repeated.
  double top_beside(int di, int dj) const {
    const auto at = [](int k, int size) { return ((k % size) + size) % size; };
    return place_.grid.at(at(i_ + di, place_.grid.width), at(j_ + dj, place_.grid.height));
  }

  void add(std::array<double, 3> origin, std::array<double, 3> direction, double t_max = kInfinity) {
    const double size[3] = {width(), height(), full()};
    TracedRay ray;
    ray.id = rays_.size();
    for (size_t a = 0; a < 3; ++a) {
      ray.origin[a] = origin[a] / size[a];
      ray.direction[a] = direction[a] / size[a];
    }
    ray.t_max = t_max;
    rays_.push_back(ray);
  }
  /// In tile units, as traced.
  TracedRay& add_traced(std::array<double, 3> origin, std::array<double, 3> direction) {
    TracedRay ray;
    ray.id = rays_.size();
    for (size_t a = 0; a < 3; ++a) {
      ray.origin[a] = origin[a];
      ray.direction[a] = direction[a];
    }
    rays_.push_back(ray);
    return rays_.back();
  }
  /// A point inside the tile's slab, in tile units.
  std::array<double, 3> anywhere() { return {random_.unit(), random_.unit(), random_.unit()}; }
  Random& random() { return random_; }
  const HardPlace& place() const { return place_; }

 private:
  Random& random_;
  const HardPlace& place_;
  std::vector<TracedRay>& rays_;
  int i_ = 0, j_ = 0;
};

}  // namespace cuesta
