#include "traces/scene.h"
#include "models/common/error.h"
#include "tests/fuzz/scratch_file.h"
#include "traces/front_end.h"

void cuesta::fuzz::scene(Bytes bytes) {
  try {
    const Scene scene = parse_scene(text_of(bytes), "scene.toml", "");
    if (!scene.rays_file.empty()) return;  // the file would be one of this host
    make_rays(scene, 64, 48, Crop{scene.width / 2, scene.height / 2, 1, 1});
  } catch (const Error&) {
  }
}
