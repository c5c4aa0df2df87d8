#include <algorithm>
#include <memory>
#include <vector>

#include "models/common/random.h"
#include "models/heightmap/noise.h"
#include "models/heightmap/reliefs.h"

// Maps made of plain shapes: each is the hard case of some part of a traversal.
namespace cuesta {
namespace {

/// Whole cells along both sides, about `cells` along the shorter one.
Torus torus_of(int width, int height, int cells) {
  int64_t side = std::min(width, height);
  return {std::max<int64_t>(1, (static_cast<int64_t>(cells) * width + side / 2) / side),
          std::max<int64_t>(1, (static_cast<int64_t>(cells) * height + side / 2) / side)};
}

}  // namespace

ReliefRows make_flat(int width, int, uint64_t) {
  return [width](int, double* row) { std::fill_n(row, width, 0.5); };
}

ReliefRows make_spikes(int width, int height, uint64_t seed) {
  struct Needle {
    int i, j;
    double height;
  };
  auto random = std::make_shared<Random>(seed);
  auto needles = std::make_shared<std::vector<Needle>>();  // of the row of blocks at hand
  return [=](int j, double* row) {
    if (j % 8 == 0) {
      needles->clear();
      for (int left = 0; left < width; left += 8) {
        auto i = left + static_cast<int>(random->below(static_cast<uint64_t>(std::min(8, width - left))));
        auto in_row = j + static_cast<int>(random->below(static_cast<uint64_t>(std::min(8, height - j))));
        double needle = 0.5 + 0.5 * random->unit();
        needles->push_back({i, in_row, j == 0 && left == 0 ? 1.0 : needle});
      }
    }
    std::fill_n(row, width, 0.0);
    for (const Needle& needle : *needles) {
      if (needle.j == j) row[needle.i] = needle.height;
    }
  };
}

ReliefRows make_noise(int width, int, uint64_t seed) {
  const uint64_t key = Random::mix(seed + 0x9E3779B97F4A7C15ull);
  return [=](int j, double* row) {
    Random random(Random::mix(key + static_cast<uint64_t>(j)));
    for (int i = 0; i < width; ++i) row[i] = random.unit();
  };
}

/// Bricks three times as long as a course is high, about 12 courses to a square map and always an even number, so
/// that the half bricks of each second course meet over the seam.
ReliefRows make_bricks(int width, int height, uint64_t seed) {
  int64_t side = std::min(width, height);
  auto courses = 2 * std::max<int64_t>(1, (6 * static_cast<int64_t>(height) + side / 2) / side);
  auto bricks = std::max<int64_t>(1, (4 * static_cast<int64_t>(width) + side / 2) / side);
  double course_texels = static_cast<double>(height) / static_cast<double>(courses);
  double brick_texels = static_cast<double>(width) / static_cast<double>(bricks);
  double joint = 0.06 * course_texels;                 // half of a joint, texels
  double bevel = std::max(0.12 * course_texels, 1.0);  // at least a texel
  return [=](int j, double* row) {
    double v = (j + 0.5) / course_texels;
    auto course = floor_integer(v);
    double in_course = (v - static_cast<double>(course)) * course_texels;
    double shift = course % 2 == 0 ? 0 : 0.5;
    for (int i = 0; i < width; ++i) {
      double u = (i + 0.5) / brick_texels + shift;
      auto brick = floor_integer(u);
      double in_brick = (u - static_cast<double>(brick)) * brick_texels;
      double edge = std::min(std::min(in_course, course_texels - in_course),
                             std::min(in_brick, brick_texels - in_brick));
      uint64_t id = Random::mix(seed + 1 + static_cast<uint64_t>(course * bricks + brick % bricks));
      double top = 0.8 + 0.2 * share_of(id, 0);
      row[i] = top * clamp_unit((edge - joint) / bevel);
    }
  };
}

ReliefRows make_steps(int width, int, uint64_t) {
  const int treads = std::min(16, width);
  return [=](int, double* row) {
    for (int i = 0; i < width; ++i) {
      auto tread = static_cast<int>(static_cast<int64_t>(i) * treads / width);
      row[i] = static_cast<double>(tread + 1) / treads;
    }
  };
}

ReliefRows make_checker(int width, int, uint64_t) {
  return [=](int j, double* row) {
    for (int i = 0; i < width; ++i) row[i] = (i / 8 + j / 8) % 2 == 0 ? 1 : 0;
  };
}

ReliefRows make_hole(int width, int height, uint64_t) {
  const bool room = width > 1 || height > 1;
  return [=](int j, double* row) {
    std::fill_n(row, width, 1.0);
    if (room && j == height / 2) row[width / 2] = 0;
  };
}

ReliefRows make_cliffs(int width, int height, uint64_t seed) {
  Torus torus = torus_of(width, height, 6);
  return [=](int j, double* row) {
    double v = (j + 0.5) / height * static_cast<double>(torus.rows);
    for (int i = 0; i < width; ++i) {
      double u = (i + 0.5) / width * static_cast<double>(torus.columns);
      row[i] = share_of(nearest_cell(torus, u, v, 1.0, seed).id, 0) < 0.5 ? 1 : 0;
    }
  };
}

ReliefRows make_terraces(int width, int height, uint64_t seed) {
  constexpr int kTerraces = 8;
  Torus torus = torus_of(width, height, 3);
  return [=](int j, double* row) {
    double v = (j + 0.5) / height * static_cast<double>(torus.rows);
    for (int i = 0; i < width; ++i) {
      double u = (i + 0.5) / width * static_cast<double>(torus.columns);
      double land = clamp_unit(0.5 + 0.7 * fractal_noise(torus, u, v, 0.1, seed));
      row[i] = static_cast<double>(std::min<int64_t>(kTerraces - 1, floor_integer(land * kTerraces))) /
               (kTerraces - 1);
    }
  };
}

}  // namespace cuesta
