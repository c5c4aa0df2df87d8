#include <gtest/gtest.h>

#include <cmath>

#include "tests/models/search/search_cases.h"

// What holds for every kind, filter, address mode and size. The sink throws at a read beyond the map.

namespace cuesta {
namespace {

template <class Real>
void expect_sound(const SearchCase& c, const Search& search, const SearchMap& map, const MachineRay& ray) {
  const SearchAnswer answer = run_search<Real>(c, search, map, ray);
  const std::string where = name_of(search) + " " + std::to_string(c.shape.width) + " x " +
                            std::to_string(c.shape.height) + " " +
                            std::string(name_of(c.shape.address_mode)) + ": " + describe(ray);
  EXPECT_EQ(answer.hit.steps, answer.sink.steps.size()) << where;
  EXPECT_LE(answer.hit.steps, static_cast<uint32_t>(1 + search.steps + 1 + search.refinements)) << where;
  if (answer.hit.status != HitStatus::kHit) {
    HitRecord miss;
    miss.ray_id = ray.id;
    miss.steps = answer.hit.steps;
    EXPECT_EQ(answer.hit, miss) << where;
    return;
  }
  const auto segment = make_search_ray<Real>(ray, c.shape, RealArithmetic<Real>::format(c.shape, c.format));
  const double unit = RealArithmetic<Real>::format(c.shape, c.format).unit_of_time;
  const auto t = static_cast<Real>(answer.t * static_cast<long double>(unit));
  EXPECT_TRUE(std::isfinite(t)) << where;
  EXPECT_GE(t, segment.t_start) << where;
  EXPECT_LE(t, segment.t_end * static_cast<Real>(1.0001)) << where;
  EXPECT_NE(answer.hit.face, HitFace::kNone) << where;
  if (c.shape.address_mode == AddressMode::kBorder) {
    EXPECT_TRUE(answer.hit.i >= 0 && answer.hit.i < c.shape.width && answer.hit.j >= 0 &&
                answer.hit.j < c.shape.height)
        << where;
  }
  // The three units of time say the same.
  RecordingSink sink;
  sink.size_bytes = map.size_bytes();
  sink.most_reads = 4;
  const Searcher<Real> searcher(search, map, c.shape, c.format, 0.1);
  HitRecord fixed = searcher.trace(ray, Arithmetic::kFixed, sink);
  const auto t_end = (int64_t{1} << time_bits(c.shape, c.format)) - 1;
  EXPECT_GE(fixed.t, 0) << where;
  EXPECT_LE(fixed.t, t_end) << where;
  if (fixed.t < t_end)
    EXPECT_LE(std::abs(static_cast<double>(fixed.t) - static_cast<double>(answer.t)), 0.501) << where;
  fixed.t = answer.hit.t;
  EXPECT_EQ(fixed, answer.hit) << where;
}

void check_all_kinds(const SearchCase& c, const std::vector<MachineRay>& rays) {
  for (const SearchRow& row : search_rows()) {
    if (is_printed(row.search.kind)) continue;  // printed_search_test.cpp
    for (const SearchFilter filter : {SearchFilter::kTexel, SearchFilter::kBilinear}) {
      Search search = row.search;
      search.filter = filter;
      const SearchMap map(search, c.pyramid, c.shape.address_mode);
      EXPECT_EQ(map.size_bytes(), static_cast<uint64_t>(c.shape.width) *
                                      static_cast<uint64_t>(c.shape.height) *
                                      static_cast<uint64_t>(map.record_bytes() * map.layers()));
      for (const MachineRay& ray : rays) {
        expect_sound<float>(c, search, map, ray);
        expect_sound<double>(c, search, map, ray);
      }
    }
  }
}

TEST(EverySearch, EndsInsideItsSegmentOnRandomMapsAndRays) {
  Random random(1234);
  for (int m = 0; m < 60; ++m) {
    const RandomMap map = random_map(random.next(), m % 3 == 0 ? 3 : 20);
    const SearchCase c(map);
    std::vector<MachineRay> rays;
    for (int r = 0; r < 12; ++r) {
      if (const auto ray = random_machine_ray(random, map, static_cast<uint64_t>(r))) rays.push_back(*ray);
    }
    check_all_kinds(c, rays);
  }
}

TEST(EverySearch, EndsOnFlatMapsOfEverySizeInEveryModeForEveryDirection) {
  for (const AddressMode mode :
       {AddressMode::kBorder, AddressMode::kWrap, AddressMode::kMirror, AddressMode::kClamp}) {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 7}, {5, 1}, {4, 4}}) {
      for (const int bits : {1, 8, 16}) {
        for (const uint32_t level : {0u, (1u << bits) - 1}) {
          const SearchCase c(flat_grid(width, height, bits, static_cast<uint16_t>(level)), mode,
                             {.mantissa_bits = bits + 4});
          std::vector<MachineRay> rays;
          for (const double du : {0.0, 1.0, -1.0, 1e-9}) {
            for (const double dv : {0.0, -0.3}) {
              for (const double dz : {-1.0, 0.0, 1.0, -1e-7, 1e-7}) {
                if (du == 0 && dv == 0 && dz == 0) continue;
                for (const double z : {0.0, 0.5, 1.0}) rays.push_back(ray_from(c, 0.5, 0.25, z, du, dv, dz));
              }
            }
          }
          check_all_kinds(c, rays);
        }
      }
    }
  }
}

}  // namespace
}  // namespace cuesta
