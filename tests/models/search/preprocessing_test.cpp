#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "models/heightmap/generator.h"
#include "models/search/preprocessing.h"
#include "tests/models/search/brute_force.h"
#include "tests/models/search/search_cases.h"

// The maps that searches read, against brute force over the plane, and against rays counted out cell by cell.

namespace cuesta {
namespace {

template <class Check>
void for_random_texels(uint64_t seed, int maps, int max_side, Check&& check) {
  Random random(seed);
  for (int m = 0; m < maps; ++m) {
    const RandomMap map = random_map(random.next(), max_side);
    const SearchCase c(map);
    check(c, describe(map), random);
  }
}

void check_bytes(SearchKind kind, long double (*brute)(const HeightGrid&, AddressMode, int, int)) {
  int64_t texels = 0, whole = 0;
  for_random_texels(11, 250, 14, [&](const SearchCase& c, const std::string& where, Random&) {
    const SearchMap map({kind}, c.pyramid, c.shape.address_mode);
    for (int j = 0; j < c.shape.height; ++j) {
      for (int i = 0; i < c.shape.width; ++i) {
        const long double ratio = brute(c.grid, c.shape.address_mode, i, j);
        ++texels;
        whole += map.added_at(i, j) == 255;
        ASSERT_TRUE(is_rounded_down(map.added_at(i, j), ratio))
            << where << ": texel " << i << ", " << j << " has " << int{map.added_at(i, j)}
            << ", the ratio is " << static_cast<double>(ratio);
      }
    }
  });
  EXPECT_GT(texels, 5000);
  EXPECT_LT(whole, texels * 9 / 10);  // else nothing was compared
}

TEST(ConeMap, EqualsBruteForceRoundedDownInEveryMode) { check_bytes(SearchKind::kCone, brute_cone); }
TEST(RelaxedConeMap, EqualsBruteForceRoundedDownInEveryMode) {
  check_bytes(SearchKind::kRelaxedCone, brute_relaxed_cone);
}
TEST(SafetyRadii, EqualBruteForceRoundedDownInEveryMode) {
  check_bytes(SearchKind::kSafetyRadius, brute_radius);
}

TEST(ConeMap, IsWorkedByHandForOneTowerOnAPlain) {
  HeightGrid grid = flat_grid(16, 16, 8, 0);
  grid.at(8, 8) = 255;
  const SearchCase c(grid, AddressMode::kBorder, {});
  const SearchMap map({SearchKind::kCone}, c.pyramid, AddressMode::kBorder);
  // From the centre of (4, 8) the tower is 3.5 of 16 texels away, at full scale: 255 sqrt(3.5 / 16) = 119.27.
  EXPECT_EQ(map.added_at(4, 8), 119);
  EXPECT_EQ(map.added_at(8, 8), 255);  // nothing is higher
  EXPECT_EQ(map.added_at(7, 7), 53);   // sqrt(1/2) texels: 255 sqrt(.7071 / 16) = 53.6
  EXPECT_EQ(map.record_bytes(), 2);
  EXPECT_EQ(map.offset(3, 2), 2u * (2 * 16 + 3));
  const SearchMap relaxed({SearchKind::kRelaxedCone}, c.pyramid, AddressMode::kBorder);
  EXPECT_EQ(map.added_at(6, 8), 78);  // 1.5 texels: 78.08
  EXPECT_EQ(relaxed.added_at(6, 8),
            80);  // the tower's side edges before its far one, hypot(1.5, .5) texels: 80.16
  const SearchMap wrapped({SearchKind::kCone}, c.pyramid, AddressMode::kWrap);
  EXPECT_EQ(wrapped.added_at(0, 8), 174);  // 7.5 away on both sides: 174.6
  EXPECT_GT(wrapped.cost().texels_read, 0u);
  EXPECT_EQ(wrapped.cost().records_written, 256u);
  EXPECT_EQ(wrapped.cost().bytes, wrapped.cost().texels_read + 512);
}

/// Follows a ray that does not rise from (x, y, z) in the unwrapped plane and returns how far away it first comes out
/// of the surface again, and at what height; infinite if it does not within `reach` texels.
struct Emergence {
  double distance, z;
};
Emergence first_emergence(const HeightGrid& grid, AddressMode mode, double x, double y, double z, double ux,
                          double uy, double fall, double reach) {
  auto i = static_cast<int64_t>(std::floor(x)), j = static_cast<int64_t>(std::floor(y));
  bool inside = false;
  double at = 0;
  while (at < reach) {
    const double to_x =
        ux == 0 ? 1e300 : ((ux > 0 ? static_cast<double>(i + 1) : static_cast<double>(i)) - x) / ux;
    const double to_y =
        uy == 0 ? 1e300 : ((uy > 0 ? static_cast<double>(j + 1) : static_cast<double>(j)) - y) / uy;
    const double out = std::min(to_x, to_y);
    const int height = plane_height(grid, mode, i, j);
    if (z - fall * at > height && inside) return {at, z - fall * at};
    if (height < 0) break;
    inside = z - fall * out < height;
    at = out;
    if (to_x <= out) i += ux > 0 ? 1 : -1;
    if (to_y <= out) j += uy > 0 ? 1 : -1;
  }
  return {std::numeric_limits<double>::infinity(), 0};
}

/// Random rays from above a texel, many of them aimed at just below another texel's height.
struct RayAbove {
  double x, y, z, ux, uy, fall;
};
RayAbove ray_above(Random& random, const SearchCase& c, int i, int j, double off) {
  const auto full = static_cast<double>(c.grid.full_scale());
  RayAbove ray{i + 0.5 + off * (random.unit() - 0.5), j + 0.5 + off * (random.unit() - 0.5), 0, 0, 0, 0};
  const double base = c.grid.at(i, j);
  ray.z = base + (full - base) * random.unit() * (random.chance(0.3) ? 0.05 : 1) + 1e-6;
  const double to_x = i + static_cast<double>(random.between(-6, 6)) + random.unit() - ray.x;
  const double to_y = j + static_cast<double>(random.between(-6, 6)) + random.unit() - ray.y;
  const double far = std::max(1e-3, std::hypot(to_x, to_y));
  ray.ux = to_x / far;
  ray.uy = to_y / far;
  const int target =
      plane_height(c.grid, c.shape.address_mode, static_cast<int64_t>(std::floor(ray.x + to_x)),
                   static_cast<int64_t>(std::floor(ray.y + to_y)));
  ray.fall = std::max(0.0, (ray.z - (target - 0.02 * random.unit())) / far);
  return ray;
}

TEST(RelaxedConeMap, NoRayFromTheAxisComesOutOfTheSurfaceAgainInsideItsCone) {
  int64_t emergences = 0, inside = 0, inside_wider = 0;
  for_random_texels(21, 60, 10, [&](const SearchCase& c, const std::string& where, Random& random) {
    const SearchMap map({SearchKind::kRelaxedCone}, c.pyramid, c.shape.address_mode);
    const int side = std::max(c.shape.width, c.shape.height);
    for (int r = 0; r < 3000; ++r) {
      const auto i = static_cast<int>(random.below(static_cast<uint64_t>(c.shape.width)));
      const auto j = static_cast<int>(random.below(static_cast<uint64_t>(c.shape.height)));
      const RayAbove ray = ray_above(random, c, i, j, 0);
      const Emergence out =
          first_emergence(c.grid, c.shape.address_mode, ray.x, ray.y, ray.z, ray.ux, ray.uy, ray.fall, 12);
      if (!std::isfinite(out.distance)) continue;
      ++emergences;
      const auto within = [&](int byte) {
        const double ratio =
            static_cast<double>(byte) / 255 * (static_cast<double>(byte) / 255) * side / c.grid.full_scale();
        return out.distance < ratio * (out.z - c.grid.at(i, j)) * (1 - 1e-9);
      };
      const int byte = map.added_at(i, j);
      if (within(byte)) {
        ++inside;
        ADD_FAILURE() << where << ": texel " << i << ", " << j;
        return;
      }
      inside_wider += within(byte + 24);
    }
  });
  EXPECT_GT(emergences, 10000);
  EXPECT_GT(inside_wider, 100);  // cones a little wider would be too wide: the rays do find the edges
  std::printf("rays that come out again %lld, inside the cone %lld, inside one 24 bytes wider %lld\n",
              static_cast<long long>(emergences), static_cast<long long>(inside),
              static_cast<long long>(inside_wider));
}

TEST(SafetyRadii, NoRayFromAboveTheTexelComesOutOfTheSurfaceAgainInsideTheRadius) {
  int64_t emergences = 0, inside_wider = 0;
  for_random_texels(22, 60, 10, [&](const SearchCase& c, const std::string& where, Random& random) {
    const SearchMap map({SearchKind::kSafetyRadius}, c.pyramid, c.shape.address_mode);
    const int side = std::max(c.shape.width, c.shape.height);
    for (int r = 0; r < 3000; ++r) {
      const auto i = static_cast<int>(random.below(static_cast<uint64_t>(c.shape.width)));
      const auto j = static_cast<int>(random.below(static_cast<uint64_t>(c.shape.height)));
      const RayAbove ray = ray_above(random, c, i, j, 1);
      // Above the texel until it leaves it: the search asks the texel itself exactly.
      const double leaves = std::min(ray.ux == 0 ? 1e300 : ((ray.ux > 0 ? i + 1 : i) - ray.x) / ray.ux,
                                     ray.uy == 0 ? 1e300 : ((ray.uy > 0 ? j + 1 : j) - ray.y) / ray.uy);
      if (ray.z - ray.fall * leaves <= c.grid.at(i, j)) continue;
      const Emergence out =
          first_emergence(c.grid, c.shape.address_mode, ray.x, ray.y, ray.z, ray.ux, ray.uy, ray.fall, 12);
      if (!std::isfinite(out.distance)) continue;
      ++emergences;
      const double off = std::hypot(ray.x - (i + 0.5), ray.y - (j + 0.5));
      const auto within = [&](int byte) {
        return out.distance + off <
               static_cast<double>(byte) / 255 * (static_cast<double>(byte) / 255) * side * (1 - 1e-9);
      };
      ASSERT_FALSE(within(map.added_at(i, j))) << where << ": texel " << i << ", " << j;
      inside_wider += within(map.added_at(i, j) + 24);
    }
  });
  EXPECT_GT(emergences, 10000);
  EXPECT_GT(inside_wider, 100);
}

TEST(DistanceField, IsTheEuclideanDistanceRoundedDown) {
  int64_t voxels = 0, positive = 0;
  for_random_texels(31, 120, 20, [&](const SearchCase& c, const std::string& where, Random& random) {
    const SearchMap map({SearchKind::kDistance}, c.pyramid, c.shape.address_mode);
    EXPECT_EQ(map.size_bytes(), 16u * c.grid.texels.size());
    const long double slab = distance_slab_texels(c.shape.width, c.shape.height);
    for (int r = 0; r < 60; ++r) {
      const auto i = static_cast<int>(random.below(static_cast<uint64_t>(c.shape.width)));
      const auto j = static_cast<int>(random.below(static_cast<uint64_t>(c.shape.height)));
      const auto layer = static_cast<int>(random.below(16));
      const long double distance = brute_distance(c.grid, c.shape.address_mode, i, j, layer);
      const long double stored = map.distance_at(i, j, layer) / 255.0L * slab;
      ++voxels;
      positive += map.distance_at(i, j, layer) > 0;
      // Never more than the distance, less by at most the two roundings: 1/16 texel of height and a byte.
      EXPECT_LE(stored, distance + 1e-12L) << where << ": " << i << ", " << j << ", " << layer;
      EXPECT_GT(stored, distance - 1 / 16.0L - slab / 255 - 1e-12L)
          << where << ": " << i << ", " << j << ", " << layer;
    }
  });
  EXPECT_GT(positive, voxels / 10);
}

TEST(DistanceField, IsExactInIntegersOnALargerMap) {
  const SearchCase c(generate("spikes", 96, 64, 8, 3), AddressMode::kMirror, {});
  const SearchMap map({SearchKind::kDistance}, c.pyramid, AddressMode::kMirror);
  Random random(5);
  for (int r = 0; r < 300; ++r) {
    const auto i = static_cast<int>(random.below(96)), j = static_cast<int>(random.below(64));
    const auto layer = static_cast<int>(random.below(16));
    int64_t least = std::numeric_limits<int64_t>::max();
    for_plane_around(c.grid, AddressMode::kMirror, i, j, [&](int64_t di, int64_t dj, int height) {
      // 96 / 8 = 12 texels of slab are 192 parts of 1/16 texel; z_k = (2 layer + 1) / 32 of 255.
      const int64_t parts = std::max<int64_t>(0, (2 * layer + 1) * 255 - 32 * height) * 192 / (32 * 255);
      least = std::min(least, 256 * (di * di + dj * dj) + parts * parts);
    });
    const int byte = map.distance_at(i, j, layer);
    const auto square = [](int64_t b) { return b * b * 192 * 192; };
    EXPECT_LE(square(byte), least * 255 * 255);
    EXPECT_GT(square(byte + 1), least * 255 * 255);
  }
}

TEST(SearchMap, LinearSearchesReadTheHeightGridItself) {
  const SearchCase c(flat_grid(5, 3, 12, 7), AddressMode::kWrap, {});
  const SearchMap map({SearchKind::kSteep, 8}, c.pyramid, AddressMode::kWrap);
  EXPECT_EQ(map.record_bytes(), 2);
  EXPECT_EQ(map.size_bytes(), 30u);
  EXPECT_EQ(map.offset(4, 2), 28u);
  EXPECT_EQ(map.cost().texels_read, 0u);
  EXPECT_EQ(map.cost().bytes, 0u);
}

}  // namespace
}  // namespace cuesta
