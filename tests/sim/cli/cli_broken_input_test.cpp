#include <bit>
#include <limits>

#include "models/common/random.h"
#include "tests/sim/cli/cli_fixture.h"

namespace cuesta {
namespace {

/// Broken files of each kind, through the whole program: the documented exit code, a sentence, no crash.
class BrokenInput : public CommandLine {
 protected:
  ProgramResult run_scene(const std::string& text) const {
    write("scene.toml", text);
    return cuesta({"run", "scene.toml", "--fidelity", "functional", "-q", "-o", "out", "--force"});
  }

  ProgramResult run_image(const std::string& bytes, const std::string& name = "map.png") const {
    write(name, bytes);
    return run_scene("[heightmap]\nfile = \"" + name + "\"\n[image]\nwidth = 8\nheight = 8\n");
  }

  ProgramResult run_rays(const std::string& bytes, const std::string& name = "in.rays") const {
    write(name, bytes);
    write("small.toml", kSmallScene);
    return cuesta(
        {"run", "small.toml", "--rays", name, "--fidelity", "functional", "-q", "-o", "out", "--force"});
  }

  /// Accepted, or refused with `code` and a sentence; never anything else.
  static void expect_accepted_or_refused(const ProgramResult& result, int code, const std::string& what) {
    if (result.code != 0) expect_refusal(result, code, "", what);
  }
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

void put(std::string& bytes, uint64_t value, int size) {
  for (int k = 0; k < size; ++k) bytes += static_cast<char>(value >> (8 * k));
}

/// A little-endian TIFF of one row of float32 texels.
std::string float_tiff(const std::vector<float>& texels) {
  std::string bytes("II*\0", 4);
  put(bytes, 8, 4);
  const uint32_t entries[][4] = {{256, 4, 1, static_cast<uint32_t>(texels.size())},
                                 {257, 4, 1, 1},
                                 {258, 3, 1, 32},
                                 {259, 3, 1, 1},
                                 {262, 3, 1, 1},
                                 {273, 4, 1, 134},
                                 {277, 3, 1, 1},
                                 {278, 4, 1, 1},
                                 {279, 4, 1, static_cast<uint32_t>(4 * texels.size())},
                                 {339, 3, 1, 3}};
  put(bytes, std::size(entries), 2);
  for (const auto& [tag, type, count, value] : entries) {
    put(bytes, tag, 2);
    put(bytes, type, 2);
    put(bytes, count, 4);
    put(bytes, value, 4);
  }
  put(bytes, 0, 4);
  for (float texel : texels) put(bytes, std::bit_cast<uint32_t>(texel), 4);
  return bytes;
}

TEST_F(BrokenInput, ScenesEndWithTwo) {
  ASSERT_EQ(run_scene(kSmallScene).code, 0);
  const std::string good = kSmallScene;
  const struct {
    const char* what;
    std::string text;
    const char* part;
  } cases[] = {
      {"empty", "", "the file is empty"},
      {"only a comment", "# x\n", "holds no keys"},
      {"truncated", good.substr(0, good.size() / 2 - 3), "scene.toml"},
      {"unknown key", replaced(good, "depth", "detph"), "did you mean `depth`?"},
      {"unknown table", replaced(good, "[camera]", "[camra]"), "did you mean `camera`?"},
      {"wrong type", replaced(good, "angle_degrees = 60", "angle_degrees = \"60\""), "scene.toml:6"},
      {"table for a number", replaced(good, "angle_degrees = 60", "angle_degrees = {}"), "is a table"},
      {"NaN", replaced(good, "angle_degrees = 60", "angle_degrees = nan"), "is nan"},
      {"infinity", replaced(good, "depth = 0.1", "depth = inf"), "is inf"},
      {"huge number", replaced(good, "depth = 0.1", "depth = 1e300"), "scene.toml:4"},
      {"huge integer", replaced(good, "\nwidth = 16", "\nwidth = 99999999999999999999"), "scene.toml:8"},
      {"huge frame",
       replaced(replaced(good, "\nwidth = 16", "\nwidth = 65536"), "\nheight = 16", "\nheight = 65536"),
       "scene.toml"},
      {"below range", replaced(good, "\nwidth = 16", "\nwidth = 0"), "is 0"},
      {"twice", good + "width = 3\n", "not TOML"},
      {"unknown kind", replaced(good, "rocks", "rokcs"), "rocks"},
      {"not text", std::string("\x00\x01\xff\xfe\x80", 5), "not TOML"},
      {"huge file", std::string(1'000'000, '#'), "accepted"},
  };
  for (const auto& [what, text, part] : cases) expect_refusal(run_scene(text), 2, part, what);
  expect_refusal(cuesta({"run", "none.toml"}), 2, "none.toml", "missing");
  std::filesystem::create_directory(path("folder.toml"));
  expect_refusal(cuesta({"run", "folder.toml"}), 2, "folder", "a folder");
}

TEST_F(BrokenInput, FlippedBytesInASceneNeverCrash) {
  Random random(1);
  for (int k = 0; k < 24; ++k) {
    std::string text = kSmallScene;
    text[random.below(text.size())] ^= static_cast<char>(1 << random.below(8));
    write("scene.toml", text);
    const ProgramResult result = cuesta(
        {"run", "scene.toml", "--fidelity", "functional", "-q", "-o", "out", "--force", "--size", "8"});
    expect_accepted_or_refused(result, 2, text);
  }
}

TEST_F(BrokenInput, ArchitecturesEndWithTwo) {
  write("small.toml", kSmallScene);
  const struct {
    const char* what;
    const char* text;
    const char* part;
  } cases[] = {
      {"empty", "", "the file is empty"},
      {"truncated", "[height_l1]\nways = ", "a.toml:2"},
      {"wrong type", "[height_l1]\nways = \"4\"\n", "accepted is a whole number from 1 to 64"},
      {"NaN", "[height_l1]\nways = nan\n", "is nan"},
      {"huge", "[height_l1]\nways = 9223372036854775807\n", "accepted is a whole number from 1 to 64"},
      {"contradiction", "[height_l1]\nways = 3\n", "height_l1.size_bytes"},
      {"unknown key", "[height_l1]\nwasy = 3\n", "did you mean `ways`?"},
      {"unknown base", "base = \"mobil\"\n", "did you mean `mobile`?"},
  };
  for (const auto& [what, text, part] : cases) {
    write("a.toml", text);
    expect_refusal(cuesta({"run", "small.toml", "--arch", "a.toml", "-q"}), 2, part, what);
  }
  expect_refusal(cuesta({"run", "small.toml", "--arch", "none.toml"}), 2, "there is no such file", "missing");
}

TEST_F(BrokenInput, ImagesEndWithThree) {
  ASSERT_EQ(cuesta({"heightmap", "make", "rocks", "-o", "good.png"}).code, 0);
  const std::string good = read("good.png");
  ASSERT_EQ(run_image(good).code, 0);
  expect_refusal(run_image(""), 3, "map.png", "empty");
  expect_refusal(run_image("no image at all"), 3, "map.png", "text");
  for (size_t part : {1u, 2u, 3u, 7u}) {
    expect_refusal(run_image(good.substr(0, good.size() * part / 8)), 3, "map.png", "truncated");
  }
  std::string huge = good.substr(0, 16);  // a PNG header that declares 2^31 - 1 texels on a side
  huge += std::string("\x7f\xff\xff\xff\x7f\xff\xff\xff", 8) + good.substr(24);
  expect_refusal(run_image(huge), 3, "map.png", "huge");
  std::string tga("\0\0\x03\0\0\0\0\0\0\0\0\0\xff\xff\xff\xff\x08\0", 18);
  expect_refusal(run_image(tga, "map.tga"), 3, "map.tga", "huge TGA");

  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinity = std::numeric_limits<float>::infinity();
  ASSERT_EQ(run_image(float_tiff({0, 0.5f, 1, 0.25f}), "map.tif").code, 0);
  expect_refusal(run_image(float_tiff({0, nan, 1, 0.25f}), "map.tif"), 3, "map.tif", "NaN");
  expect_refusal(run_image(float_tiff({0, infinity, 1, 0.25f}), "map.tif"), 3, "map.tif", "infinity");
  std::filesystem::remove(path("map.png"));
  expect_refusal(run_scene(kImageScene), 3, "map.png", "missing");
  std::filesystem::create_directory(path("map.png"));
  expect_refusal(run_scene(kImageScene), 3, "map.png", "a folder");
}

TEST_F(BrokenInput, FlippedBytesInAnImageNeverCrash) {
  ASSERT_EQ(cuesta({"heightmap", "make", "rocks", "-o", "good.png"}).code, 0);
  const std::string good = read("good.png");
  Random random(2);
  for (int k = 0; k < 20; ++k) {
    std::string bytes = good;
    const size_t at = k < 10 ? random.below(64) : random.below(bytes.size());
    bytes[at] ^= static_cast<char>(1 << random.below(8));
    expect_accepted_or_refused(run_image(bytes), 3, "byte " + std::to_string(at));
  }
}

TEST_F(BrokenInput, RayTracesEndWithThree) {
  write("small.toml", kSmallScene);
  ASSERT_EQ(cuesta({"trace", "small.toml", "-o", "good.rays"}).code, 0);
  const std::string good = read("good.rays");
  ASSERT_EQ(run_rays(good).code, 0);
  expect_refusal(run_rays(""), 3, "in.rays", "empty");
  expect_refusal(run_rays("no rays at all"), 3, "in.rays", "text");
  expect_refusal(run_rays(good + "x"), 3, "in.rays", "one byte too many");
  for (size_t cut : {size_t{1}, size_t{8}, good.size() / 2, good.size() - 20}) {
    expect_refusal(run_rays(good.substr(0, good.size() - cut)), 3, "in.rays", "truncated");
  }
  expect_refusal(cuesta({"run", "small.toml", "--rays", "none.rays"}), 3, "none.rays", "missing");
  Random random(3);
  for (int k = 0; k < 20; ++k) {
    std::string bytes = good;
    const size_t at = random.below(bytes.size());
    bytes[at] ^= static_cast<char>(1 << random.below(8));
    expect_refusal(run_rays(bytes), 3, "in.rays", "flipped bit in byte " + std::to_string(at));
  }
}

TEST_F(BrokenInput, RaysThatAreNoNumbersEndWithThree) {
  write("small.toml", kSmallScene);
  ASSERT_EQ(cuesta({"trace", "small.toml", "-o", "good.csv"}).code, 0);
  const std::string good = read("good.csv");
  ASSERT_EQ(run_rays(good, "in.csv").code, 0);
  // Each value of the first row, one after the other.
  const size_t head = good.find('\n', good.find("id,")) + 1;
  const size_t end = good.find('\n', head);
  int columns = 0;
  for (size_t at = head; at < end; ++columns) {
    const size_t stop = std::min(good.find(',', at), end);
    std::string text = good;
    expect_refusal(run_rays(text.replace(at, stop - at, "nan"), "in.csv"), 3, "in.csv",
                   "column " + std::to_string(columns));
    at = stop + 1;
  }
  EXPECT_GE(columns, 10);
  size_t direction = head;
  for (int k = 0; k < 4; ++k) direction = good.find(',', direction) + 1;
  size_t after = direction;
  for (int k = 0; k < 3; ++k) after = good.find(',', after) + 1;
  std::string text = good;
  expect_refusal(run_rays(text.replace(direction, after - direction, "0,0,0,"), "in.csv"), 3,
                 "direction is zero", "zero");
  text = good;
  expect_refusal(run_rays(text.replace(direction, 1, "1e999"), "in.csv"), 3, "in.csv", "huge");
}

TEST_F(BrokenInput, WordsThatContradictOrSayNothingEndWithTwoBeforeTheWork) {
  write("there.fst", "mine");
  const Refusal cases[] = {
      {{"run", "default", "--algorithm=", "--fidelity", "functional"}, "`--algorithm=` has no value"},
      {{"verify", "oracle", "--seed=", "--rays", "10"}, "`--seed=` has no value"},
      {{"run", "default", "--json="}, "`--json=` has no value; accepted is `--json` alone."},
      {{"trace", "default", "-o=a.rays"}, "write `-o a.rays`."},
      {{"trace", "default", "-o=", "a.rays"}, "write `-o VALUE`."},
      {{"trace", "default", "-q=1", "-o", "a.rays"}, "write `-q`."},
      {{"run", "default", "--algoritm=", "dda"}, "did you mean `--algorithm`?"},
      {{"heightmap", "make", "rocks", "-o", "a.png", "--bits", "0"}, "--bits 0 is not accepted; 1 to 16"},
      {{"heightmap", "make", "rocks", "-o", "a.png", "--bits", "17"}, "--bits 17 is not accepted; 1 to 16"},
      {{"heightmap", "make", "rocks", "-o", "a.png", "--bits", "-1"}, "--bits -1 is not accepted; 1 to 16"},
      {{"rays", "convert", "a.rays", "b.csv", "-o", "c.csv"},
       "Two files to write are given, b.csv and -o c.csv;"},
      {{"rays", "convert", "a.rays"}, "No file to write is given;"},
      {{"run", "default", "--waves", "there.fst"}, "--waves there.fst exists and stays as it is;"},
      {{"run", "default", "--waves", std::string(300, 'n') + ".fst"},
       "cannot be written: File name too long;"},
      {{"run", "default", "--waves", "a.fst", "--waves-pixel", "3,3", "--waves-pipeline", "0"},
       "--waves-pixel and --waves-pipeline: accepted is one of the two"},
      {{"run", "default", "--waves-pipeline", "0"}, "need --waves FILE.fst"},
      {{"verify", "oracle", "--rays", "0", "--precision-rays", "0", "--bilinear-rays", "0",
        "--bilinear-exact-rays", "0"},
       "nothing to check"},
      {{"run", "default", "--algorithm", "dda,"}, "--algorithm dda, names nothing before or behind a comma"},
      {{"compare", "default", "--algorithm", ",dda"}, "--algorithm ,dda names nothing"},
      {{"compare", "default", "--arch", "tiny,,mobile"}, "--arch tiny,,mobile names nothing"},
      {{"verify", "laws", "--scene", "default,"}, "--scene default, names nothing"},
      {{"verify", "laws", "--arch", ","}, "--arch , names nothing"},
      {{"run", "default", "--algorithm", "root,common,never"}, "accepted is root:common:never."},
      {{"run", "default", "--algorithm", "root:common,never,quad"}, "accepted is root:common:never:quad."},
      {{"compare", "default", "--algorithm", "dda,root,2,never,yun2013"},
       "`root,2,never`: at a comma the next algorithm begins"},
      {{"run", "--heightmap", "r.png:bits=12"}, "did you mean r.png,bits=12?"},
      {{"run", "--heightmap", "r.png:A:range=0..3,bits=12"}, "did you mean r.png:A,range=0..3,bits=12?"},
  };
  expect_refusals(cases);
  EXPECT_EQ(read("there.fst"), "mine");
  EXPECT_EQ(tree("").size(), 1u);  // nothing was written beside it
}

TEST_F(BrokenInput, EqualsSignsThatAreAcceptedStayAccepted) {
  const ProgramResult made =
      cuesta({"heightmap", "make", "rocks", "-o", "a=b.png", "--size=8", "--bits=16", "-q"});
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_TRUE(std::filesystem::exists(path("a=b.png")));
  EXPECT_EQ(cuesta({"run", "default", "--fidelity=cycle", "--arch=tiny", "--set", "height_l1.ways=4",
                    "--size=8", "-o", "out", "-q"})
                .code,
            0);
}

}  // namespace
}  // namespace cuesta
