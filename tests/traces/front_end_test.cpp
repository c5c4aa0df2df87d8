#include "traces/front_end.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/traces/support.h"
#include "traces/rays_writer.h"

namespace cuesta {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A border scene of one tile, straight down from height 1 above the plane unless changed.
Scene scene_of(int width, int height) {
  Scene scene;
  scene.origin = "test.toml";
  scene.address_mode = AddressMode::kBorder;
  scene.depth = 0.25;
  scene.camera.angle_degrees = 0;
  scene.camera.fov_degrees = 90;
  scene.width = width;
  scene.height = height;
  return scene;
}

const TracedRay& ray_of(const RayTrace& trace, uint64_t id) {
  for (const TracedRay& ray : trace.rays) {
    if (ray.id == id) return ray;
  }
  throw input_error("The trace has no ray " + std::to_string(id) + ".");
}

/// Exit through the given tile-unit plane of the origin's ray: the point at parameter t.
double at(const TracedRay& ray, int axis, double t) { return ray.origin[axis] + t * ray.direction[axis]; }

TEST(FrontEnd, FrontViewWithoutDistanceShowsExactlyThePlanesWidth) {
  // Field of view 90 degrees, plane 1 wide: the camera stands 0.5 above it; pixel x of 4 looks at (x + 0.5) / 4.
  const RayTrace trace = make_rays(scene_of(4, 4), 64, 64);
  ASSERT_EQ(trace.rays.size(), 16u);
  for (const TracedRay& ray : trace.rays) {
    EXPECT_NEAR(ray.origin[0], (ray.pixel_x + 0.5) / 4, 1e-15);
    EXPECT_NEAR(ray.origin[1], (ray.pixel_y + 0.5) / 4, 1e-15);
    EXPECT_EQ(ray.origin[2], 1);
    EXPECT_EQ(ray.t_min, 0);
    EXPECT_EQ(ray.t_max, kInfinity);
    EXPECT_EQ(ray.id, ray.pixel_y * 4 + ray.pixel_x);
    // World slope: 0.5 down for (u - 0.5) sideways; the slab is 0.25 thick, so z falls four times as fast.
    EXPECT_NEAR(ray.direction[0] / ray.direction[2], (ray.origin[0] - 0.5) / -(0.5 * 4), 1e-15);
    EXPECT_NEAR(ray.direction[1] / ray.direction[2], (ray.origin[1] - 0.5) / -(0.5 * 4), 1e-15);
  }
}

TEST(FrontEnd, FrontViewMovesAQuarterTilePerPixelOfFour) {
  for (const TracedRay& ray : make_rays(scene_of(4, 4), 64, 64).rays) {
    EXPECT_NEAR(ray.gradient[0], 0.25, 1e-7);
    EXPECT_NEAR(ray.gradient[1], 0, 1e-7);
    EXPECT_NEAR(ray.gradient[2], 0, 1e-7);
    EXPECT_NEAR(ray.gradient[3], 0.25, 1e-7);
  }
}

TEST(FrontEnd, GradientIsTheDifferenceOfNeighbouringPixelsOnThePlane) {
  Scene scene = scene_of(400, 300);
  scene.camera.angle_degrees = 55;
  scene.camera.turn_degrees = 30;
  scene.camera.distance = 3;
  scene.camera.fov_degrees = 10;
  const RayTrace trace = make_rays(scene, 64, 32);
  const TracedRay& here = ray_of(trace, 150 * 400 + 200);
  const TracedRay& left = ray_of(trace, 150 * 400 + 199);
  const TracedRay& right = ray_of(trace, 150 * 400 + 201);
  const TracedRay& above = ray_of(trace, 149 * 400 + 200);
  const TracedRay& below = ray_of(trace, 151 * 400 + 200);
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_NEAR(here.gradient[axis] / ((right.origin[axis] - left.origin[axis]) / 2), 1, 1e-4);
    EXPECT_NEAR(here.gradient[2 + axis] / ((below.origin[axis] - above.origin[axis]) / 2), 1, 1e-4);
  }
}

TEST(FrontEnd, TheMiddleOfThePictureLooksAtTheMiddleOfThePlaneUnderTheAngle) {
  // One pixel: its middle is the camera's axis. At 60 degrees the view falls cos 60 = 1/2 and moves sin 60 to -v.
  Scene scene = scene_of(1, 1);
  scene.camera.angle_degrees = 60;
  scene.camera.distance = 2;
  const RayTrace trace = make_rays(scene, 64, 64);
  ASSERT_EQ(trace.rays.size(), 1u);
  const TracedRay& ray = trace.rays[0];
  EXPECT_NEAR(ray.origin[0], 0.5, 1e-15);
  EXPECT_NEAR(ray.origin[1], 0.5, 1e-15);
  EXPECT_NEAR(ray.direction[0], 0, 1e-15);
  EXPECT_NEAR(ray.direction[1], -std::sqrt(3.0) / 2, 1e-15);
  EXPECT_NEAR(ray.direction[2], -0.5 * 4, 1e-15);
}

TEST(FrontEnd, TurnMovesTheCameraAroundTheNormal) {
  Scene scene = scene_of(1, 1);
  scene.camera.angle_degrees = 45;
  scene.camera.distance = 2;
  scene.camera.turn_degrees = 90;  // from behind +v to behind -u: it looks along +u
  const TracedRay ray = make_rays(scene, 64, 64).rays.at(0);
  EXPECT_NEAR(ray.direction[0], std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(ray.direction[1], 0, 1e-15);
}

TEST(FrontEnd, CornerPixelsOfAThreeByTwoPictureFollowTheFieldOfView) {
  // Tangent of half the field is 1 over the width: pixel middles at -2/3, 0, 2/3 and, squares, at +1/3, -1/3 up.
  Scene scene = scene_of(3, 2);
  scene.tiles[0] = scene.tiles[1] = 1;
  scene.camera.by_angle = false;
  const double position[] = {0.5, 0.5, 0.5}, look_at[] = {0.5, 0.4, 0.5};  // level, to -v, above the slab
  std::copy(position, position + 3, scene.camera.position);
  std::copy(look_at, look_at + 3, scene.camera.look_at);
  const RayTrace trace = make_rays(scene, 64, 64);
  // The upper row looks up and is not traced; the lower falls 1/3 per unit and meets z = 0.25 world after 0.75 units:
  // 0.25 beyond the map's edge at v = 0. It then must be a miss of the plane, so nothing is left.
  EXPECT_EQ(trace.rays.size(), 0u);
  scene.camera.position[2] = scene.camera.look_at[2] = 0.35;  // meets it after 0.3 units, at v = 0.2
  const RayTrace lower = make_rays(scene, 64, 64);
  ASSERT_EQ(lower.rays.size(), 3u);
  for (int x = 0; x < 3; ++x) {
    const TracedRay& ray = ray_of(lower, static_cast<uint64_t>(3 + x));
    EXPECT_NEAR(ray.origin[0], 0.5 + 0.3 * (x - 1) * 2 / 3, 1e-12);
    EXPECT_NEAR(ray.origin[1], 0.2, 1e-12);
    EXPECT_EQ(ray.origin[2], 1);
  }
}

TEST(FrontEnd, RaysEnterThroughTheSideWhereTheyPassBelowTheTopPlane) {
  // Level with a slab of 0.25, at 0.125, looking to -v from v = 2: the middle ray enters the wall v = 1 at z = 0.5.
  Scene scene = scene_of(1, 1);
  scene.camera.by_angle = false;
  const double position[] = {0.5, 2, 0.125}, look_at[] = {0.5, 0, 0.125};
  std::copy(position, position + 3, scene.camera.position);
  std::copy(look_at, look_at + 3, scene.camera.look_at);
  const RayTrace trace = make_rays(scene, 64, 64);
  ASSERT_EQ(trace.rays.size(), 1u);
  EXPECT_NEAR(trace.rays[0].origin[0], 0.5, 1e-15);
  EXPECT_EQ(trace.rays[0].origin[1], 1);
  EXPECT_NEAR(trace.rays[0].origin[2], 0.5, 1e-15);
  EXPECT_EQ(trace.rays[0].direction[2], 0);
  EXPECT_EQ(trace.rays[0].gradient[0], 0);
}

TEST(FrontEnd, ACameraInsideTheSlabStartsItsRaysThere) {
  Scene scene = scene_of(5, 5);
  scene.camera.by_angle = false;
  const double position[] = {0.5, 0.75, 0.125}, look_at[] = {0.5, 0, 0.125};
  std::copy(position, position + 3, scene.camera.position);
  std::copy(look_at, look_at + 3, scene.camera.look_at);
  const RayTrace trace = make_rays(scene, 64, 64);
  ASSERT_EQ(trace.rays.size(), 25u);
  int rising = 0, descending = 0;
  for (const TracedRay& ray : trace.rays) {
    EXPECT_EQ(ray.origin[0], 0.5);
    EXPECT_EQ(ray.origin[1], 0.75);
    EXPECT_EQ(ray.origin[2], 0.5);
    rising += ray.direction[2] > 0;
    descending += ray.direction[2] < 0;
  }
  EXPECT_EQ(rising, 10);
  EXPECT_EQ(descending, 10);
}

TEST(FrontEnd, EveryRayStartsInOrOnTheSlabAndSomeAreNotTraced) {
  for (double angle : {0.0, 30.0, 60.0, 80.0, 88.0, 89.9}) {
    for (double distance : {0.3, 1.0, 20.0}) {
      Scene scene = scene_of(61, 47);
      scene.camera.angle_degrees = angle;
      scene.camera.distance = distance;
      scene.camera.turn_degrees = 17;
      const RayTrace trace = make_rays(scene, 100, 63);
      EXPECT_GT(trace.rays.size(), 0u) << angle << " " << distance;
      int on_top = 0, on_side = 0, inside = 0;
      for (const TracedRay& ray : trace.rays) {
        EXPECT_EQ(fault_of(ray, 61, 47), "");
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_GE(ray.origin[axis], 0);
          EXPECT_LE(ray.origin[axis], 1);
        }
        const bool side =
            ray.origin[0] == 0 || ray.origin[0] == 1 || ray.origin[1] == 0 || ray.origin[1] == 1;
        ++(ray.origin[2] == 1 ? on_top : side ? on_side : inside);
      }
      EXPECT_GT(on_top, 0);
      EXPECT_EQ(inside, 0);
      EXPECT_TRUE(distance < 20.0 || trace.rays.size() < 61u * 47u);
    }
  }
}

TEST(FrontEnd, TilesAreAsManyAsAskedForAndAsLongAsTheMapInV) {
  // Two by three tiles of a 64 x 32 map: the plane is 2 wide and 1.5 long; a front view has it all.
  Scene scene = scene_of(200, 200);
  scene.address_mode = AddressMode::kWrap;
  scene.tiles[0] = 2;
  scene.tiles[1] = 3;
  const RayTrace trace = make_rays(scene, 64, 32);
  double high_u = 0, high_v = 0;
  std::map<uint32_t, int> rows;
  for (const TracedRay& ray : trace.rays) {
    high_u = std::max(high_u, ray.origin[0]);
    high_v = std::max(high_v, ray.origin[1]);
    ++rows[ray.pixel_y];
  }
  EXPECT_NEAR(high_u, 2, 0.02);
  EXPECT_NEAR(high_v, 3, 0.03);
  EXPECT_EQ(rows.size(), 150u);  // 1.5 of 2 at 100 pixels per unit
}

TEST(FrontEnd, InWrapModeRaysEndJustBeforeThePlanesEdge) {
  Scene scene = scene_of(40, 40);
  scene.address_mode = AddressMode::kWrap;
  scene.tiles[0] = scene.tiles[1] = 2;
  scene.camera.angle_degrees = 75;
  scene.camera.turn_degrees = 40;
  const RayTrace trace = make_rays(scene, 64, 64);
  ASSERT_GT(trace.rays.size(), 0u);
  for (const TracedRay& ray : trace.rays) {
    const double u = at(ray, 0, ray.t_max), v = at(ray, 1, ray.t_max);
    const double to_edge = std::min({u, 2 - u, v, 2 - v});
    EXPECT_NEAR(to_edge * 64, 1.0 / 128, 1e-9);
  }
}

TEST(FrontEnd, ACropHasTheRaysOfTheWholeFrame) {
  Scene scene = scene_of(50, 40);
  scene.camera.angle_degrees = 70;
  const RayTrace whole = make_rays(scene, 64, 64);
  const RayTrace part = make_rays(scene, 64, 64, Crop{20, 10, 7, 30});
  EXPECT_EQ(part.width, 50);
  EXPECT_EQ(part.height, 40);
  RayTrace expected{50, 40, {}};
  for (const TracedRay& ray : whole.rays) {
    if (ray.pixel_x >= 20 && ray.pixel_x < 27 && ray.pixel_y >= 10) expected.rays.push_back(ray);
  }
  EXPECT_GT(expected.rays.size(), 0u);
  EXPECT_TRUE(identical(part, expected));

  ScratchFolder folder;
  scene.rays_file = folder.file("a.rays");
  write_rays(scene.rays_file, whole);
  EXPECT_TRUE(identical(make_rays(scene, 64, 64), whole));
  EXPECT_TRUE(identical(make_rays(scene, 64, 64, Crop{20, 10, 7, 30}), expected));
}

TEST(FrontEnd, CropsOutsideTheFrameAndOtherTextsAreUsageErrors) {
  const Scene scene = scene_of(50, 40);
  for (const Crop& crop : {Crop{0, 0, 51, 40}, Crop{49, 0, 2, 1}, Crop{0, 40, 1, 1},
                           Crop{2147483647, 0, 2147483647, 1}, Crop{0, 0, 0, 1}, Crop{-1, 0, 5, 5}}) {
    sentence_of(ExitCode::kUsage, [&] { make_rays(scene, 64, 64, crop); });
  }
  const Crop crop = parse_crop("1,2,3,4");
  EXPECT_EQ(crop.x, 1);
  EXPECT_EQ(crop.y, 2);
  EXPECT_EQ(crop.width, 3);
  EXPECT_EQ(crop.height, 4);
  for (const char* text : {"", "1", "1,2,3", "1,2,3,", "1,2,3,4,", "1,2,3,4,5", "a,2,3,4", "1,2,0,4",
                           "-1,2,3,4", "1, 2,3,4", "1,2,3,99999999999", ",,,"}) {
    sentence_of(ExitCode::kUsage, [&] { parse_crop(text); });
  }
}

TEST(FrontEnd, ACameraBelowTheFloorIsAUsageError) {
  Scene scene = scene_of(4, 4);
  scene.camera.by_angle = false;
  scene.camera.position[2] = -0.1;
  scene.camera.look_at[0] = 1;
  sentence_of(ExitCode::kUsage, [&] { make_rays(scene, 64, 64); });
}

}  // namespace
}  // namespace cuesta
