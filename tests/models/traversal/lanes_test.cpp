#include "models/traversal/lanes.h"

#include <gtest/gtest.h>

#include <bit>
#include <numeric>

#include "models/common/error.h"
#include "models/oracle/random_cases.h"

// Many rays at a time must give the records, and read the lines, of one ray at a time.

namespace cuesta {
namespace {

using FixedWalk = Walk<FixedArithmetic, PlainAxis>;

struct Bench {
  RandomMap map;
  Pyramid pyramid;
  std::vector<MachineRay> rays;
};

/// A square power of two with rays that cross up to 2^w2 tiles: some walks are thousands of steps long.
Bench bench(int side, int bits, AddressMode mode, int rays) {
  Bench bench;
  RandomMap& map = bench.map;
  map.grid = {side, side, bits, {}};
  Random random(static_cast<uint64_t>(side * 64 + bits));
  for (int k = 0; k < side * side; ++k) {
    const uint64_t height = random.below(map.grid.full_scale() + 1);
    map.grid.texels.push_back(static_cast<uint16_t>(height >> random.below(static_cast<uint64_t>(bits) + 1)));
  }
  map.shape = {side, side, std::countr_zero(static_cast<unsigned>(side)), bits, mode};
  map.format.mantissa_bits = bits + 4;
  bench.pyramid = build_max_pyramid(map.grid);
  while (bench.rays.size() < static_cast<size_t>(rays)) {
    try {
      bench.rays.push_back(quantise(random_ray(random, map, bench.rays.size()), map.shape, map.format));
    } catch (const Error&) {  // beyond the format's tiles
    }
  }
  return bench;
}

HitRecord alone(const FixedWalk& walk, const Bench& bench, const MachineRay& ray, const TexelLayout& layout,
                int line_shift, std::vector<uint32_t>& lines) {
  return traverse_ray(walk, ray, [&](int level, int64_t i, int64_t j) {
    const int x = static_cast<int>(i), y = static_cast<int>(j);
    lines.push_back(static_cast<uint32_t>(layout.offset(level, x, y) >> line_shift));
    return static_cast<int64_t>(bench.pyramid.at(level, x, y));
  });
}

void expect_equal(const Bench& bench, TexelLayoutKind kind) {
  constexpr int kLineShift = 5;
  const TexelLayout layout(kind, bench.pyramid);
  std::vector<uint32_t> order(bench.rays.size() - 3);  // some rays are not asked for
  for (size_t k = 0; k < order.size(); ++k) order[k] = static_cast<uint32_t>(order.size() - k);
  int64_t compared = 0, longest = 0;
  for (const Algorithm& algorithm : algorithms()) {
    for (int stop = 0; stop <= std::min(2, bench.map.shape.root_level); ++stop) {
      Schedule schedule = algorithm.schedule;
      schedule.stop_level = stop;
      const FixedWalk walk(bench.map.shape, bench.map.format, schedule,
                           bench.pyramid.at(bench.pyramid.root_level(), 0, 0));
      if (!lanes_can(walk)) GTEST_SKIP() << "this processor has no AVX-512";
      std::vector<HitRecord> hits(order.size());
      std::vector<uint32_t> lines;
      std::vector<LineSpan> spans(order.size());
      const LineRecorder recorder{&layout, kLineShift, &lines, spans.data()};
      traverse_lanes(walk, bench.pyramid, bench.rays, order, hits, &recorder);
      for (size_t k = 0; k < order.size(); ++k) {
        std::vector<uint32_t> expected;
        const HitRecord record = alone(walk, bench, bench.rays[order[k]], layout, kLineShift, expected);
        ASSERT_EQ(hits[k], record) << algorithm.id << ", stop " << stop << ", "
                                   << describe(bench.rays[order[k]]);
        ASSERT_EQ(spans[k].count, expected.size());
        ASSERT_LE(spans[k].first + spans[k].count, lines.size());
        ASSERT_TRUE(std::equal(expected.begin(), expected.end(),
                               lines.begin() + static_cast<int64_t>(spans[k].first)))
            << algorithm.id << ", stop " << stop << ", " << describe(bench.rays[order[k]]);
        ++compared;
        longest = std::max<int64_t>(longest, record.steps);
      }
    }
  }
  EXPECT_GT(compared, 1000);
  std::printf("%lld rays, longest walk %lld steps\n", static_cast<long long>(compared),
              static_cast<long long>(longest));
}

TEST(TraverseLanes, GiveTheRecordsAndLinesOfOneRayAtATimeOverTiles) {
  expect_equal(bench(64, 8, AddressMode::kWrap, 1000), TexelLayoutKind::kRowMajor);
  expect_equal(bench(64, 16, AddressMode::kWrap, 1000), TexelLayoutKind::kMipAtlas);
  expect_equal(bench(64, 8, AddressMode::kWrap, 1000), TexelLayoutKind::kBlocks4x4);
  expect_equal(bench(64, 16, AddressMode::kWrap, 1000), TexelLayoutKind::kKi2007Slices);
}

TEST(TraverseLanes, GiveTheRecordsAndLinesOfOneRayAtATimeInABorderedMap) {
  expect_equal(bench(256, 8, AddressMode::kBorder, 400), TexelLayoutKind::kMipAtlas);
  expect_equal(bench(128, 16, AddressMode::kBorder, 400), TexelLayoutKind::kRowMajor);
  expect_equal(bench(128, 16, AddressMode::kBorder, 400), TexelLayoutKind::kBlocks4x4);
  expect_equal(bench(256, 8, AddressMode::kBorder, 400), TexelLayoutKind::kKi2007Slices);
}

TEST(TraverseLanes, HandleMapsOfOneAndFourTexels) {
  expect_equal(bench(1, 8, AddressMode::kWrap, 300), TexelLayoutKind::kRowMajor);
  expect_equal(bench(2, 16, AddressMode::kBorder, 300), TexelLayoutKind::kMipAtlas);
  for (int side : {1, 2, 4}) {
    expect_equal(bench(side, 8, AddressMode::kWrap, 300), TexelLayoutKind::kBlocks4x4);
    expect_equal(bench(side, 8, AddressMode::kWrap, 300), TexelLayoutKind::kKi2007Slices);
  }
}

TEST(TraverseLanes, TakeAnyNumberOfRays) {
  const Bench all = bench(16, 8, AddressMode::kWrap, 40);
  const FixedWalk walk(all.map.shape, all.map.format, find_algorithm("yun2013")->schedule,
                       all.pyramid.at(all.pyramid.root_level(), 0, 0));
  if (!lanes_can(walk)) GTEST_SKIP() << "this processor has no AVX-512";
  const TexelLayout layout(TexelLayoutKind::kRowMajor, all.pyramid);
  for (size_t count = 0; count <= all.rays.size(); ++count) {
    std::vector<HitRecord> hits(count);
    traverse_lanes(walk, all.pyramid, std::span(all.rays).first(count), {}, hits, nullptr);
    for (size_t k = 0; k < count; ++k) {
      std::vector<uint32_t> lines;
      ASSERT_EQ(hits[k], alone(walk, all, all.rays[k], layout, 5, lines)) << count << " rays, ray " << k;
    }
  }
}

}  // namespace
}  // namespace cuesta
