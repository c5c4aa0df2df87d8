#include "traces/scene.h"
#include "models/common/error.h"
#include "tests/fuzz/scratch_file.h"
#include "traces/front_end.h"

void cuesta::fuzz::scene(Bytes bytes) {
  try {
    const Scene scene = parse_scene(text_of(bytes), "scene.toml", "");
    if (!scene.rays_file.empty()) return;  // the file would be one of this host
    if (scene.ray_set.count > 1000000 && !scene.ray_set.kind.empty()) return;
    MapShape map{64, 48, 6, 8, scene.address_mode};
    make_rays(scene, map, Crop{scene.width / 2, scene.height / 2, 1, 1});
  } catch (const Error&) {
  }
}
