#include "traces/camera.h"

#include <cmath>

#include "models/common/elementary.h"

namespace cuesta {
namespace {

/// Sine and cosine of an angle in degrees, exact at the multiples of 90.
struct Turn {
  explicit Turn(double degrees) {
    sine = elementary::sin(elementary::radians(degrees));
    cosine = elementary::cos(elementary::radians(degrees));
    if (degrees == 0 || degrees == 180 || degrees == -180) sine = 0;
    if (degrees == 90 || degrees == -90) cosine = 0;
  }
  double sine, cosine;
};

double length(const double (&v)[3]) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

void set(double (&v)[3], double x, double y, double z) {
  v[0] = x;
  v[1] = y;
  v[2] = z;
}

/// v points down the picture and z at the viewer: the axes are left-handed, hence forward x right.
void set_up(Camera& camera) {
  const auto& f = camera.forward;
  const auto& r = camera.right;
  set(camera.up, f[1] * r[2] - f[2] * r[1], f[2] * r[0] - f[0] * r[2], f[0] * r[1] - f[1] * r[0]);
}

}  // namespace

Camera make_camera(const Scene& scene, double tile_height) {
  const CameraSettings& settings = scene.camera;
  Camera camera;
  camera.half_width = elementary::tan(elementary::radians(settings.fov_degrees / 2));
  if (settings.by_angle) {
    const Turn angle(settings.angle_degrees), turn(settings.turn_degrees);
    set(camera.forward, angle.sine * turn.sine, -angle.sine * turn.cosine, -angle.cosine);
    set(camera.right, turn.cosine, turn.sine, 0);
    const double distance =
        settings.distance > 0 ? settings.distance : scene.tiles[0] / (2 * camera.half_width);
    set(camera.position, scene.tiles[0] * 0.5 - distance * camera.forward[0],
        scene.tiles[1] * tile_height * 0.5 - distance * camera.forward[1],
        scene.depth - distance * camera.forward[2]);
  } else {
    for (int axis = 0; axis < 3; ++axis) {
      camera.position[axis] = settings.position[axis];
      camera.forward[axis] = settings.look_at[axis] - settings.position[axis];
    }
    const double far = length(camera.forward);
    for (double& component : camera.forward) component /= far;
    const double level =
        std::sqrt(camera.forward[0] * camera.forward[0] + camera.forward[1] * camera.forward[1]);
    if (level > 1e-9) {
      set(camera.right, -camera.forward[1] / level, camera.forward[0] / level, 0);
    } else {
      set(camera.right, 1, 0, 0);  // straight down: u to the right, as at angle 0
    }
  }
  set_up(camera);
  return camera;
}

}  // namespace cuesta
