#include "reports/image_write.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "models/common/error.h"
#include "reports/picture.h"

namespace cuesta {
namespace {

namespace fs = std::filesystem;

class ImageWrite : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "cuesta-image-XXXXXX").string();
    root_ = mkdtemp(name.data());
  }
  void TearDown() override { fs::remove_all(root_); }
  fs::path root_;
};

Measurements two_planes() {
  Measurements measurements;
  measurements.plane_width = 3;
  measurements.plane_height = 2;
  // 2049 is the first integer that half loses, 16777217 the first that float loses.
  measurements.planes = {{"plane.steps", {0, 2047, 2049, 65537, 16777217, 4294967295u}, 0, true},
                         {"plane.latency", {6, 5, 4, 3, 2, 1}, 0, false}};
  return measurements;
}

TEST_F(ImageWrite, ExrKeepsEveryBitOfACount) {
  const fs::path path = root_ / "planes.exr";
  write_planes_exr(path, two_planes());
  auto input = OIIO::ImageInput::open(path.string());
  ASSERT_TRUE(input);
  const OIIO::ImageSpec& spec = input->spec();
  ASSERT_EQ(spec.width, 3);
  ASSERT_EQ(spec.height, 2);
  ASSERT_EQ(spec.nchannels, 2);
  EXPECT_EQ(spec.format, OIIO::TypeDesc::UINT32);
  std::vector<uint32_t> values(12);
  ASSERT_TRUE(input->read_image(0, 0, 0, 2, OIIO::TypeDesc::UINT32, values.data()));
  for (const Plane& plane : two_planes().planes) {
    const int channel = spec.channelindex(plane.name.substr(6));
    ASSERT_GE(channel, 0) << plane.name;
    for (size_t i = 0; i < 6; ++i) EXPECT_EQ(values[2 * i + static_cast<size_t>(channel)], plane.values[i]);
  }
}

TEST_F(ImageWrite, ExrOfTheSamePlanesHasTheSameBytes) {
  write_planes_exr(root_ / "a.exr", two_planes());
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // no time of day inside
  write_planes_exr(root_ / "b.exr", two_planes());
  auto bytes = [&](const char* name) {
    std::ifstream stream(root_ / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  EXPECT_EQ(bytes("a.exr"), bytes("b.exr"));
}

TEST_F(ImageWrite, SaysWhereItCannotWrite) {
  try {
    write_planes_exr(root_ / "no/such/folder/planes.exr", two_planes());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::kResource);
    EXPECT_NE(std::string(error.what()).find("no/such/folder"), std::string::npos);
  }
}

TEST_F(ImageWrite, AnotherReaderSeesOurPng) {
  const Picture picture{3, 2, {{1, 2, 3}, {250, 128, 7}}, {0, 1, 0, 1, 1, 0}};
  const fs::path path = root_ / "picture.png";
  std::ofstream(path, std::ios::binary) << encode_png(picture);
  auto input = OIIO::ImageInput::open(path.string());
  ASSERT_TRUE(input);
  ASSERT_EQ(input->spec().width, 3);
  ASSERT_EQ(input->spec().height, 2);
  ASSERT_EQ(input->spec().nchannels, 3);
  std::vector<uint8_t> values(18);
  ASSERT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, values.data()));
  for (size_t i = 0; i < 6; ++i) {
    const Colour& colour = picture.palette[picture.pixels[i]];
    EXPECT_EQ((Colour{values[3 * i], values[3 * i + 1], values[3 * i + 2]}), colour);
  }
}

}  // namespace
}  // namespace cuesta
