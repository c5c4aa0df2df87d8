#include <limits>

#include "models/common/random.h"
#include "tests/traces/heightmaps/image_test.h"

namespace cuesta::test {
namespace {

using OIIO::TypeDesc;

class ImageDamage : public ImageTest {
 protected:
  /// A picture of 24 x 20 in each format that is promised.
  std::vector<std::string> pictures() const {
    std::vector<uint8_t> bytes(24 * 20);
    std::vector<float> reals(24 * 20);
    Random random(3);
    for (size_t k = 0; k < bytes.size(); ++k) {
      bytes[k] = static_cast<uint8_t>(random.below(256));
      reals[k] = static_cast<float>(random.unit());
    }
    std::vector<std::string> files;
    for (const char* name : {"d.png", "d.tif", "d.tga", "d.bmp", "d.jpg"}) {
      files.push_back(write_image(name, 24, 20, {"Y"}, TypeDesc::UINT8, bytes));
    }
    files.push_back(write_image("d.exr", 24, 20, {"Y"}, TypeDesc::FLOAT, reals));
    Bytes plain = tga_header(3, 24, 20, 8, true);
    append(plain, bytes);
    files.push_back(write("plain.tga", plain));
    return files;
  }
};

TEST_F(ImageDamage, MissingEmptyAndForeignFilesAreInputErrors) {
  error_of(source(path("none.png")));
  error_of(source(folder_.string()));
  std::string empty = error_of(source(write("empty.png", {})));
  EXPECT_NE(empty.find("is empty (0 bytes)"), std::string::npos) << empty;
  error_of(source(write("text.png", Bytes(200, 'x'))));
  error_of(source(write("text.txt", Bytes(200, 'x'))));
  error_of(source(write("raw.raw", Bytes(64, 0))));
}

TEST_F(ImageDamage, NanAndInfinityAreNamedWithTheirPixel) {
  float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  auto sentence = [&](const char* name, float bad) {
    std::vector<float> samples(12, 0.5f);
    samples[7] = bad;
    return error_of(range(write_image(name, 4, 3, {"Y"}, TypeDesc::FLOAT, samples), 0, 1));
  };
  EXPECT_NE(sentence("n.exr", nan).find("NaN in channel Y at pixel (3, 1)"), std::string::npos);
  EXPECT_NE(sentence("n.tif", -infinity).find("infinity in channel Y at pixel (3, 1)"), std::string::npos);
}

TEST_F(ImageDamage, CellsWithoutDataAreRefusedUntilARangeIsGiven) {
  for (float marker : {-9999.0f, -32768.0f, -3.4028235e38f}) {
    std::string file =
        write_image("nodata.tif", 3, 1, {"Y"}, TypeDesc::FLOAT, std::vector<float>{100, marker, 300});
    EXPECT_NE(error_of(source(file)).find("without data"), std::string::npos);
    EXPECT_EQ(load_heights(range(file, 100, 300)).grid.texels, (Heights{0, 0, 65535}));
  }
}

TEST_F(ImageDamage, BitsAndRangesThatMakeNoSenseAreUsageErrors) {
  std::string file = write_image("u.png", 1, 1, {"Y"}, TypeDesc::UINT8, std::vector<uint8_t>{1});
  HeightSource from = source(file);
  from.bits = 17;
  error_of(from, ExitCode::kUsage);
  error_of(range(file, 1, 1), ExitCode::kUsage);
  error_of(range(file, 0, std::numeric_limits<double>::infinity()), ExitCode::kUsage);
}

TEST_F(ImageDamage, HugeHeadersInTinyFilesAreRefusedUnread) {
  Bytes tga = tga_header(10, 65535, 65535, 32, true);
  append(tga, {0x80, 1, 2, 3, 4});
  EXPECT_NE(error_of(source(write("huge.tga", tga))).find("65535 x 65535"), std::string::npos);
  Bytes within = tga_header(10, 16384, 16384, 32, true);
  append(within, {0x80, 1, 2, 3, 4});
  EXPECT_NE(error_of(source(write("within.tga", within))).find("cannot hold"), std::string::npos);
  error_of(source(write("huge.png", png(2000000000, 2000000000, 0, 0, {}, {0, 1}))));
  error_of(source(write("wide.png", png(16385, 1, 0, 0, {}, Bytes(16386, 0)))));
  error_of(source(write("flat.png", png(16384, 16384, 6, 0, {}, {0, 1}))));
  EXPECT_EQ(load_heights(source(write("row.png", png(16384, 1, 0, 0, {}, Bytes(16385, 0))))).grid.width,
            16384);
}

TEST_F(ImageDamage, EveryTruncationIsAnInputErrorOrLosesNoHeight) {
  for (const std::string& file : pictures()) {
    Bytes whole = read_bytes(file);
    std::string extension = std::filesystem::path(file).extension().string();
    Heights heights = load_heights(source(file)).grid.texels;
    int refused = 0;
    for (size_t length = 1; length < whole.size(); length += 1 + whole.size() / 40) {
      std::string cut =
          write("cut" + extension, Bytes(whole.begin(), whole.begin() + static_cast<long>(length)));
      try {
        // What a format puts behind its pixels, such as the stamp of a TGA, may be missing.
        EXPECT_EQ(load_heights(source(cut)).grid.texels, heights) << file << " cut to " << length;
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::kInput) << error.what();
        ++refused;
      }
    }
    EXPECT_GE(refused, 15) << file;
  }
}

TEST_F(ImageDamage, AFlippedByteGivesHeightsOrAnInputErrorAndNeverACrash) {
  Random random(11);
  for (const std::string& file : pictures()) {
    Bytes whole = read_bytes(file);
    std::string extension = std::filesystem::path(file).extension().string();
    for (int k = 0; k < 60; ++k) {
      Bytes damaged = whole;
      size_t reach = k % 2 == 0 ? std::min<size_t>(damaged.size(), 160) : damaged.size();  // headers first
      damaged[random.below(reach)] ^= static_cast<uint8_t>(1 + random.below(255));
      try {
        load_heights(source(write("flipped" + extension, damaged)));
      } catch (const Error& error) {
        EXPECT_TRUE(error.code() == ExitCode::kInput || error.code() == ExitCode::kResource) << error.what();
      }
    }
  }
}

}  // namespace
}  // namespace cuesta::test
