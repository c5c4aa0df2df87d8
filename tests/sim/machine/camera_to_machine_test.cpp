#include <gtest/gtest.h>

#include <bit>

#include "models/work/functional_run.h"
#include "sim/config/on_architecture.h"
#include "sim/machine/machine.h"
#include "tests/traces/support.h"
#include "traces/front_end.h"

namespace cuesta {
namespace {

/// Heights that change from texel to texel over the whole range, the last row and column among them.
HeightGrid rough_grid(int width, int height) {
  HeightGrid grid{width, height, 8, {}};
  Random random(5);
  for (int k = 0; k < width * height; ++k) grid.texels.push_back(static_cast<uint16_t>(random.below(256)));
  grid.texels[0] = 255;
  return grid;
}

Outcome trace(const Scene& scene, const HeightGrid& grid, RayTrace& rays) {
  const Pyramid pyramid = build_max_pyramid(grid);
  Workload work;
  work.pyramid = &pyramid;
  work.map = {grid.width, grid.height, pyramid.root_level(), grid.bits, scene.address_mode};
  rays = make_rays(scene, grid.width, grid.height);
  std::vector<MachineRay> machine_rays;
  std::vector<uint32_t> pixels;
  set_numbers(work, Architecture{});
  for (const TracedRay& ray : rays.rays) {
    machine_rays.push_back(quantise(ray, work.map, work.format));
    pixels.push_back(ray.pixel_y * static_cast<uint32_t>(rays.width) + ray.pixel_x);
  }
  work.rays = machine_rays;
  work.pixel_of_ray = pixels;
  work.width = rays.width;
  work.height = rays.height;
  work.schedule = find_algorithm("dda")->schedule;
  return run_functional(work);
}

TEST(CameraToMachine, NoHitLiesBeyondThePlane) {
  int hits = 0;
  for (int n = 0; n < 40; ++n) {
    Random random(static_cast<uint64_t>(n));
    Scene scene;
    scene.width = scene.height = 64;
    scene.address_mode = static_cast<AddressMode>(n % 4);
    if (n % 4 != 0) scene.tiles[0] = scene.tiles[1] = 1 + n % 3;
    scene.depth = n % 2 ? 0.1 : 0.5;
    scene.camera.angle_degrees = 89 * random.unit();
    scene.camera.turn_degrees = n % 5 == 0 ? 90 * (n % 4) : 360 * random.unit();
    const HeightGrid grid = n % 2 ? rough_grid(32, 32) : rough_grid(37, 21);
    RayTrace rays;
    for (const HitRecord& hit : trace(scene, grid, rays).hits) {
      if (hit.status != HitStatus::kHit) continue;
      ++hits;
      ASSERT_GE(hit.i, 0) << "scene " << n << ", ray " << hit.ray_id;
      ASSERT_GE(hit.j, 0) << "scene " << n << ", ray " << hit.ray_id;
      ASSERT_LT(hit.i, grid.width * scene.tiles[0]) << "scene " << n << ", ray " << hit.ray_id;
      ASSERT_LT(hit.j, grid.height * scene.tiles[1]) << "scene " << n << ", ray " << hit.ray_id;
    }
  }
  EXPECT_GT(hits, 20000);
}

TEST(CameraToMachine, AFrontViewHitsTheTexelUnderEachPixel) {
  // A camera far above looks straight down with one pixel per texel: pixel (x, y) shows texel (x, y), from the top.
  Scene scene;
  scene.width = scene.height = 32;
  scene.address_mode = AddressMode::kBorder;
  scene.depth = 1e-4;
  scene.camera.angle_degrees = 0;
  scene.camera.fov_degrees = 1;
  RayTrace rays;
  const HeightGrid grid = rough_grid(32, 32);
  const Outcome outcome = trace(scene, grid, rays);
  ASSERT_EQ(outcome.hits.size(), 1024u);
  for (const HitRecord& hit : outcome.hits) {
    EXPECT_EQ(hit.status, HitStatus::kHit);
    EXPECT_EQ(hit.face, HitFace::kTop);
    EXPECT_EQ(hit.i, static_cast<int>(hit.ray_id % 32));
    EXPECT_EQ(hit.j, static_cast<int>(hit.ray_id / 32));
  }
}

}  // namespace
}  // namespace cuesta
