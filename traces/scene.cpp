#include "traces/scene.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "models/common/error.h"
#include "models/common/words.h"
#include "models/files/strict_toml.h"
#include "models/heightmap/generator.h"
#include "traces/ray_trace.h"

namespace cuesta {
namespace {

constexpr int kMostTiles = 1024;
constexpr int kLongestMapSide = 16384;

std::string resolved(const std::string& folder, const std::string& path) {
  const std::filesystem::path given(path);
  return given.is_absolute() || folder.empty() ? path : (std::filesystem::path(folder) / given).string();
}

/// Keys of which at most one group may stand in a table.
void refuse_together(const TomlTable& table, std::string_view key, std::string_view other) {
  if (table.has(key) && table.has(other)) {
    throw table.error(
        key, "contradicts `" + std::string(other) + "`, which stands beside it; accepted: one of the two.");
  }
}

void read_nodata_and_raw(const TomlTable& table, HeightSource& image) {
  if (table.has("nodata")) {
    static constexpr double kInfinity = std::numeric_limits<double>::infinity();
    static constexpr Named<double> kWords[] = {
        {"nan", std::numeric_limits<double>::quiet_NaN()}, {"inf", kInfinity}, {"-inf", -kInfinity}};
    image.nodata = table.is_text("nodata") ? table.choice("nodata", kWords) : table.real("nodata");
  }
  const std::optional<TomlTable> raw = table.optional_table("raw");
  if (!raw) return;
  image.raw.width = static_cast<int>(raw->integer("width", {1, kLongestMapSide}));
  image.raw.height = static_cast<int>(raw->integer("height", {1, kLongestMapSide}));
  static constexpr Named<SampleKind> kNumbers[] = {
      {"uint8", SampleKind::kUint8},  {"uint16", SampleKind::kUint16}, {"uint32", SampleKind::kUint32},
      {"int16", SampleKind::kInt16},  {"int32", SampleKind::kInt32},   {"float", SampleKind::kFloat},
      {"double", SampleKind::kDouble}};
  image.raw.numbers = raw->choice("numbers", kNumbers, SampleKind::kUint16);
  static constexpr Named<bool> kEndian[] = {{"little", false}, {"big", true}};
  image.raw.big_endian = raw->choice("endian", kEndian, false);
}

void read_image(const TomlTable& table, const std::string& folder, HeightSource& image) {
  image.path = resolved(folder, table.text("file"));
  if (table.has("channel") && !table.is_text("channel")) {
    image.channel = std::to_string(table.integer("channel", {0, 1023}));
  } else {
    image.channel = table.text("channel", "");
  }
  static constexpr Named<bool> kValues[] = {{"height", false}, {"depth", true}};
  image.invert = table.choice("values", kValues, false);
  image.bits = static_cast<int>(table.integer("bits", {1, 16}, 0));
  static constexpr Named<Normalisation> kNormalisations[] = {{"auto", Normalisation::kAuto},
                                                             {"none", Normalisation::kNone},
                                                             {"min_max", Normalisation::kMinMax},
                                                             {"range", Normalisation::kRange}};
  image.normalisation = table.choice("normalise", kNormalisations, Normalisation::kAuto);
  const bool with_range = image.normalisation == Normalisation::kRange;
  if (table.has("range") != with_range) {
    throw table.error(
        with_range ? "normalise" : "range",
        "and `range` belong together; accepted: normalise = \"range\" with range = [low, high], or "
        "neither.");
  }
  read_nodata_and_raw(table, image);
  if (!with_range) return;
  const std::vector<double> range = table.reals("range", kAnyReal, 2);
  if (!(range[0] < range[1]))
    throw table.error("range", "does not rise; accepted: [low, high] with low < high.");
  image.low = range[0];
  image.high = range[1];
}

void read_generated(const TomlTable& table, GeneratedHeights& generated) {
  std::vector<std::string_view> kinds;
  for (const MapKind& kind : map_kinds()) kinds.push_back(kind.name);
  generated.kind = kinds[table.choice("kind", kinds)];
  for (std::string_view key : {"width", "height"}) refuse_together(table, key, "size");
  const int size = static_cast<int>(table.integer("size", {1, kLongestMapSide}, 0));
  generated.width = static_cast<int>(table.integer("width", {1, kLongestMapSide}, size));
  generated.height = static_cast<int>(table.integer("height", {1, kLongestMapSide}, size));
  generated.bits = static_cast<int>(table.integer("bits", {1, 16}, 0));
  generated.seed = static_cast<uint64_t>(table.integer("seed", {0, INT64_MAX}, 1));
}

void read_heightmap(const TomlTable& table, const std::string& folder, Scene& scene) {
  refuse_together(table, "file", "generate");
  if (table.has("generate")) {
    for (std::string_view key : {"channel", "values", "bits", "normalise", "range", "nodata", "raw"}) {
      if (table.has(key)) throw table.error(key, "belongs to `file`, and the heights are generated here.");
    }
    read_generated(table.table("generate"), scene.generated);
  } else if (table.has("file")) {
    read_image(table, folder, scene.image);
  } else {
    static constexpr std::string_view kSources[] = {"file", "generate"};
    for (const std::string& key : table.keys()) {
      const std::string near = did_you_mean(key, kSources);
      if (!near.empty()) throw table.error(key, "is no key of a scene" + near);
    }
    throw table.error("", "holds neither `file` nor `generate`; accepted: one of the two.");
  }
  static constexpr Named<AddressMode> kModes[] = {{"wrap", AddressMode::kWrap},
                                                  {"border", AddressMode::kBorder},
                                                  {"mirror", AddressMode::kMirror},
                                                  {"clamp", AddressMode::kClamp}};
  scene.address_mode = table.choice("address_mode", kModes, AddressMode::kWrap);
}

void read_surface(const TomlTable& table, Scene& scene) {
  scene.depth = table.real("depth", {1e-4, 10}, scene.depth);
  static constexpr Named<Surface> kSurfaces[] = {{"texel", Surface::kTexel},
                                                 {"bilinear", Surface::kBilinear}};
  scene.surface = table.choice("kind", kSurfaces, scene.surface);
  if (table.has("kind")) scene.surface_place = table.where("kind") + "`surface.kind` ";
  if (!table.has("tiles")) return;
  const std::vector<int64_t> tiles = table.integers("tiles", {1, kMostTiles}, 2);
  for (int axis = 0; axis < 2; ++axis) scene.tiles[axis] = static_cast<int>(tiles[static_cast<size_t>(axis)]);
  if (scene.address_mode == AddressMode::kBorder && (scene.tiles[0] != 1 || scene.tiles[1] != 1)) {
    throw table.error("tiles",
                      "asks for more than one tile, and `heightmap.address_mode` is border, which has one; "
                      "accepted: [1, 1], or address_mode = \"wrap\", \"mirror\" or \"clamp\".");
  }
}

void read_camera(const TomlTable& table, CameraSettings& camera) {
  camera.fov_degrees = table.real("fov_degrees", {0.1, 150}, camera.fov_degrees);
  if (!table.has("position") && !table.has("look_at")) {
    camera.angle_degrees = table.real("angle_degrees", {0, 89.9}, camera.angle_degrees);
    camera.turn_degrees = table.real("turn_degrees", {-360, 360}, camera.turn_degrees);
    if (table.has("distance")) camera.distance = table.real("distance", {1e-3, 1e4});
    return;
  }
  for (std::string_view key : {"angle_degrees", "turn_degrees", "distance"})
    refuse_together(table, key, "position");
  for (std::string_view key : {"angle_degrees", "turn_degrees", "distance"})
    refuse_together(table, key, "look_at");
  camera.by_angle = false;
  const std::vector<double> position = table.reals("position", {-1e4, 1e4}, 3);
  const std::vector<double> look_at = table.reals("look_at", {-1e4, 1e4}, 3);
  std::copy(position.begin(), position.end(), camera.position);
  std::copy(look_at.begin(), look_at.end(), camera.look_at);
  if (position == look_at)
    throw table.error("look_at", "is the camera's own position; accepted: any other point.");
  if (position[2] < 0)
    throw table.error("position", "lies below the slab's floor; accepted: a third number >= 0.");
}

void read_image_size(const TomlTable& table, Scene& scene) {
  scene.width = static_cast<int>(table.integer("width", {1, kLongestSide}, scene.width));
  scene.height = static_cast<int>(table.integer("height", {1, kLongestSide}, scene.height));
  const std::string fault =
      fault_of_grid(static_cast<uint64_t>(scene.width), static_cast<uint64_t>(scene.height));
  if (!fault.empty()) throw table.error("height", "makes " + fault + ".");
}

void read_rays(const TomlTable& table, const std::string& folder, Scene& scene) {
  refuse_together(table, "file", "set");
  if (!table.has("set")) {
    scene.rays_file = resolved(folder, table.text("file"));
    return;
  }
  std::vector<std::string_view> kinds;
  for (const RaySetKind& kind : ray_set_kinds()) kinds.push_back(kind.name);
  RaySet& set = scene.ray_set;
  set.kind = kinds[table.choice("set", kinds)];
  set.count =
      static_cast<uint64_t>(table.integer("count", {1, kMostPixels}, static_cast<int64_t>(set.count)));
  set.seed = static_cast<uint64_t>(table.integer("seed", {0, INT64_MAX}, static_cast<int64_t>(set.seed)));
  set.tile_bits = static_cast<int>(table.integer("tile_bits", {0, 20}, set.tile_bits));
}

Scene read_scene(const TomlDocument& document, const std::string& folder) {
  const TomlTable root = document.root();
  Scene scene;
  scene.origin = document.name();
  scene.name = root.text("name", std::filesystem::path(document.name()).stem().string());
  scene.description = root.text("description", "");
  if (const std::vector<std::string> effects = root.texts("effects", false); !effects.empty()) {
    throw root.error(
        "effects", "asks for \"" + printable(effects[0]) + "\"; accepted: [], since there is no effect yet.");
  }
  read_heightmap(root.table("heightmap"), folder, scene);
  read_surface(root.table_or_empty("surface"), scene);
  const std::optional<TomlTable> rays = root.optional_table("rays");
  if (rays) {
    for (std::string_view key : {"camera", "image"}) refuse_together(root, "rays", key);
    read_rays(*rays, folder, scene);
  } else {
    read_camera(root.table_or_empty("camera"), scene.camera);
    read_image_size(root.table_or_empty("image"), scene);
  }
  document.finish();
  return scene;
}

}  // namespace

void check_surface_kind(const Scene& scene) {
  if (scene.surface != Surface::kBilinear || scene.address_mode != AddressMode::kMirror) return;
  throw usage_error(
      scene.surface_place +
      "is bilinear, and `heightmap.address_mode` is mirror, for whose turned tiles there are no patches; "
      "accepted with bilinear: address_mode = \"wrap\", \"border\" or \"clamp\".");
}

Scene load_scene(const std::string& path) {
  Scene scene = read_scene(TomlDocument::read_file(path), std::filesystem::path(path).parent_path().string());
  std::ifstream file(path, std::ios::binary);
  scene.text.assign(std::istreambuf_iterator<char>(file), {});
  return scene;
}

Scene parse_scene(const std::string& text, const std::string& origin, const std::string& folder) {
  Scene scene = read_scene(TomlDocument::read_text(text, origin), folder);
  scene.text = text;
  return scene;
}

}  // namespace cuesta
