#include "traces/scene.h"

#include <gtest/gtest.h>

#include "tests/traces/support.h"
#include "traces/front_end.h"
#include "traces/scene_library.h"

namespace cuesta {
namespace {

const std::string kHeightmap = "[heightmap]\nfile = \"a.png\"\n";

TEST(Scene, EveryKeyArrivesInItsField) {
  const Scene scene = parse_scene(R"(
name = "mine"
description = "what it shows"
effects = []
[heightmap]
file = "maps/a.png"
channel = "A"
values = "depth"
bits = 12
normalise = "range"
range = [-4.5, 921]
address_mode = "wrap"
[surface]
kind = "bilinear"
depth = 0.35
tiles = [3, 2]
[camera]
angle_degrees = 88
turn_degrees = -20
distance = 4
fov_degrees = 30
[image]
width = 640
height = 480
)",
                                  "folder/a.toml", "folder");
  EXPECT_EQ(scene.name, "mine");
  EXPECT_EQ(scene.description, "what it shows");
  EXPECT_EQ(scene.image.path, "folder/maps/a.png");
  EXPECT_EQ(scene.image.channel, "A");
  EXPECT_TRUE(scene.image.invert);
  EXPECT_EQ(scene.image.bits, 12);
  EXPECT_EQ(scene.image.normalisation, Normalisation::kRange);
  EXPECT_EQ(scene.image.low, -4.5);
  EXPECT_EQ(scene.image.high, 921);
  EXPECT_EQ(scene.address_mode, AddressMode::kWrap);
  EXPECT_EQ(scene.surface, Surface::kBilinear);
  EXPECT_EQ(scene.depth, 0.35);
  EXPECT_EQ(scene.tiles[0], 3);
  EXPECT_EQ(scene.tiles[1], 2);
  EXPECT_TRUE(scene.camera.by_angle);
  EXPECT_EQ(scene.camera.angle_degrees, 88);
  EXPECT_EQ(scene.camera.turn_degrees, -20);
  EXPECT_EQ(scene.camera.distance, 4);
  EXPECT_EQ(scene.camera.fov_degrees, 30);
  EXPECT_EQ(scene.width, 640);
  EXPECT_EQ(scene.height, 480);
}

TEST(Scene, OtherFormsArrive) {
  const Scene scene = parse_scene(
      "[heightmap]\ngenerate = { kind = \"rocks\", size = 64, bits = 6, seed = 9 }\naddress_mode = "
      "\"border\"\n"
      "[camera]\nposition = [0.5, 2, 1]\nlook_at = [0.5, 0.5, 0]\n",
      "a.toml", "");
  EXPECT_EQ(scene.name, "a");
  EXPECT_EQ(scene.surface, Surface::kTexel);
  EXPECT_EQ(scene.generated.kind, "rocks");
  EXPECT_EQ(scene.generated.width, 64);
  EXPECT_EQ(scene.generated.height, 64);
  EXPECT_EQ(scene.generated.bits, 6);
  EXPECT_EQ(scene.generated.seed, 9u);
  EXPECT_EQ(scene.address_mode, AddressMode::kBorder);
  for (const AddressMode mode : {AddressMode::kWrap, AddressMode::kMirror, AddressMode::kClamp}) {
    const std::string text =
        kHeightmap + "address_mode = \"" + std::string(name_of(mode)) + "\"\n[surface]\ntiles = [3, 2]\n";
    EXPECT_EQ(parse_scene(text, "a.toml", "").address_mode, mode);
  }
  EXPECT_FALSE(scene.camera.by_angle);
  EXPECT_EQ(scene.camera.position[1], 2);
  EXPECT_EQ(scene.camera.look_at[2], 0);
  EXPECT_EQ(parse_scene(kHeightmap + "channel = 3\n", "a.toml", "").image.channel, "3");
  EXPECT_EQ(parse_scene("[heightmap]\nfile = \"/x/a.png\"\n", "a.toml", "folder").image.path, "/x/a.png");
  EXPECT_EQ(parse_scene(kHeightmap + "[rays]\nfile = \"r.csv\"\n", "a.toml", "f").rays_file, "f/r.csv");
}

TEST(Scene, MistakesNameFileLineKeyAndWhatIsAccepted) {
  const auto expect = [](const std::string& text, const std::vector<std::string>& parts) {
    const std::string sentence =
        sentence_of(ExitCode::kUsage, [&] { check_surface_kind(parse_scene(text, "a.toml", "")); });
    for (const std::string& part : parts) EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
  };
  expect("", {"a.toml"});
  expect("[surface]\ndepth = 0.1\n", {"heightmap"});
  expect("[heightmap\n", {"a.toml:1"});
  expect("[heightmap]\naddress_mode = \"wrap\"\n", {"a.toml:1", "generate"});
  expect("[heightmap]\nfle = \"a.png\"\n", {"a.toml:2", "heightmap.fle", "did you mean `file`"});
  expect(kHeightmap + "generate = { kind = \"rocks\" }\n", {"a.toml:2", "file", "generate"});
  expect("[heightmap]\ngenerate = { kind = \"rocks\" }\nbits = 8\n", {"a.toml:3", "heightmap.bits"});
  expect("[heightmap]\ngenerate = { kind = \"rock\" }\n", {"a.toml:2", "kind", "did you mean `rocks`"});
  expect("[heightmap]\ngenerate = { kind = \"rocks\", size = 0 }\n", {"a.toml:2", "heightmap.generate.size"});
  expect("[heightmap]\ngenerate = { kind = \"rocks\", size = 8, width = 8 }\n",
         {"a.toml:2", "width", "size"});
  expect(kHeightmap + "adress_mode = \"wrap\"\n", {"a.toml:3", "address_mode"});
  expect(kHeightmap + "address_mode = \"mirrors\"\n", {"a.toml:3", "wrap, border, mirror, clamp"});
  expect(kHeightmap + "bits = 17\n", {"a.toml:3", "16"});
  expect(kHeightmap + "bits = \"8\"\n", {"a.toml:3"});
  expect(kHeightmap + "normalise = \"range\"\n", {"a.toml:3", "range"});
  expect(kHeightmap + "range = [0, 1]\n", {"a.toml:3", "range"});
  expect(kHeightmap + "normalise = \"range\"\nrange = [1, 1]\n", {"a.toml:4", "low < high"});
  expect(kHeightmap + "nodata = \"none\"\n", {"a.toml:3", "nan, inf, -inf"});
  expect(kHeightmap + "raw = { width = 4 }\n", {"a.toml:3", "height"});
  expect(kHeightmap + "raw = { width = 4, height = 16385 }\n", {"a.toml:3", "16384"});
  expect(kHeightmap + "raw = { width = 4, height = 4, numbers = \"uint12\" }\n",
         {"a.toml:3", "numbers", "uint16"});
  expect(kHeightmap + "raw = { width = 4, height = 4, bits = 8 }\n", {"a.toml:3", "bits"});
  expect("[heightmap]\ngenerate = { kind = \"rocks\" }\nnodata = 1\n", {"a.toml:3", "heightmap.nodata"});
  expect(kHeightmap + "[surface]\ndepth = 0\n", {"a.toml:4", "surface.depth"});
  expect(kHeightmap + "[surface]\ndepth = nan\n", {"a.toml:4", "surface.depth"});
  expect(kHeightmap + "[surface]\ntiles = [1, 2, 3]\n", {"a.toml:4"});
  expect(kHeightmap + "[surface]\nkind = \"bilinar\"\n", {"a.toml:4", "surface.kind", "`bilinear`"});
  expect(kHeightmap + "address_mode = \"mirror\"\n[surface]\nkind = \"bilinear\"\n",
         {"a.toml:5", "surface.kind", "\"wrap\", \"border\" or \"clamp\""});
  expect(kHeightmap + "[surface]\ntiles = [0, 1]\n", {"a.toml:4"});
  expect(kHeightmap + "address_mode = \"border\"\n[surface]\ntiles = [2, 1]\n", {"a.toml:5", "border"});
  expect(kHeightmap + "[camera]\nangle_degrees = 90\n", {"a.toml:4", "89.9"});
  expect(kHeightmap + "[camera]\nangle_degrees = 0\nposition = [0, 0, 1]\nlook_at = [0, 0, 0]\n",
         {"a.toml:4", "angle_degrees", "position"});
  expect(kHeightmap + "[camera]\nposition = [0, 0, 1]\n", {"look_at"});
  expect(kHeightmap + "[camera]\nlook_at = [0, 0, 1]\n", {"position"});
  expect(kHeightmap + "[camera]\nlook_at = [0, 0, 1]\nposition = [0, 0, 1]\n", {"a.toml:4", "look_at"});
  expect(kHeightmap + "[camera]\nlook_at = [0, 0, 1]\nposition = [0, 0, -1]\n", {"a.toml:5", "floor"});
  expect(kHeightmap + "[image]\nwidth = 0\n", {"a.toml:4", "65536"});
  expect(kHeightmap + "[image]\nwidth = 65536\nheight = 65536\n", {"a.toml:5", "2^28"});
  expect(kHeightmap + "[rays]\nfile = \"a.rays\"\n[camera]\nangle_degrees = 3\n", {"rays", "camera"});
  expect("effects = [\"shadows\"]\n" + kHeightmap, {"a.toml:1", "shadows", "no effect"});
  expect("effects = \"shadows\"\n" + kHeightmap, {"a.toml:1"});
  expect(kHeightmap + "[lights]\n", {"a.toml:3", "lights"});
}

TEST(Scene, RandomDamageToASceneFileIsNeverMoreThanAUsageError) {
  const std::string good(built_in_scenes()[0].text);
  Random random(7);
  for (int n = 0; n < 3000; ++n) {
    std::string bad = good;
    for (uint64_t k = random.below(4) + 1; k > 0; --k) {
      const size_t at = random.below(bad.size());
      if (random.chance(0.5)) {
        bad[at] = static_cast<char>(random.next());
      } else if (random.chance(0.5)) {
        bad.erase(at, random.below(20));
      } else {
        bad.insert(at, bad.substr(random.below(bad.size()), random.below(20)));
      }
      if (bad.empty()) bad = good;
    }
    try {
      parse_scene(bad, "a.toml", "");
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::kUsage) << error.what();
    }
  }
}

TEST(SceneLibrary, EveryBuiltInSceneLoadsAndHasRaysAndADescription) {
  EXPECT_GE(built_in_scenes().size(), 3u);
  for (const BuiltInScene& built_in : built_in_scenes()) {
    Scene scene = find_scene(std::string(built_in.name));
    EXPECT_EQ(scene.name, built_in.name);
    EXPECT_GT(scene.description.size(), 10u) << built_in.name;
    EXPECT_EQ(scene.description.find('\n'), std::string::npos);
    EXPECT_GT(make_rays(scene, 256, 256, Crop{scene.width / 2, scene.height / 2, 8, 8}).rays.size(), 0u)
        << built_in.name;
  }
}

TEST(SceneLibrary, AnUnknownNameIsAnErrorThatNamesTheNearest) {
  EXPECT_EQ(find_scene("default").origin, "built-in scene default");
  EXPECT_NE(sentence_of(ExitCode::kUsage, [] { find_scene("defualt"); }).find("`default`"),
            std::string::npos);
  sentence_of(ExitCode::kUsage, [] { find_scene("nowhere/scene.toml"); });
  sentence_of(ExitCode::kUsage, [] { find_scene(""); });
  ScratchFolder folder;
  sentence_of(ExitCode::kUsage, [&] { find_scene(folder.file("")); });
  write_bytes(folder.file("mine.toml"), kHeightmap);
  const Scene scene = find_scene(folder.file("mine.toml"));
  EXPECT_EQ(scene.name, "mine");
  EXPECT_EQ(scene.text, kHeightmap);
  EXPECT_EQ(scene.image.path, folder.file("a.png"));
}

}  // namespace
}  // namespace cuesta
