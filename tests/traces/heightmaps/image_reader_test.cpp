#include "traces/heightmaps/image_reader.h"

#include "models/heightmap/generator.h"
#include "tests/traces/heightmaps/image_test.h"
#include "traces/heightmaps/image_writer.h"

namespace cuesta::test {
namespace {

using OIIO::TypeDesc;

class ImageReader : public ImageTest {};

TEST_F(ImageReader, KeepsEightAndSixteenBitIntegersAsTheyAre) {
  Heights wide = {0, 1, 256, 65535, 40000, 7};
  for (const char* name : {"wide.png", "wide.tif"}) {
    LoadedHeights loaded = load_heights(source(write_image(name, 3, 2, {"Y"}, TypeDesc::UINT16, wide)));
    EXPECT_EQ(loaded.grid.texels, wide) << name;
    EXPECT_EQ(loaded.grid.bits, 16);
    EXPECT_EQ(loaded.grid.width, 3);
    EXPECT_EQ(loaded.statement.type, "uint16");
    EXPECT_EQ(loaded.statement.distinct_levels, 6);
    EXPECT_EQ(loaded.statement.normalisation, "0 .. 65535 becomes 0 .. 65535");
  }
  std::vector<uint8_t> narrow = {0, 1, 2, 255, 128, 128};
  for (const char* name : {"narrow.png", "narrow.tif", "narrow.bmp", "narrow.tga"}) {
    LoadedHeights loaded = load_heights(source(write_image(name, 2, 3, {"Y"}, TypeDesc::UINT8, narrow)));
    EXPECT_EQ(loaded.grid.texels, Heights(narrow.begin(), narrow.end())) << name;
    EXPECT_EQ(loaded.grid.bits, 8);
    EXPECT_EQ(loaded.statement.minimum, 0);
    EXPECT_EQ(loaded.statement.maximum, 255);
  }
}

TEST_F(ImageReader, ScalesToTheBitsAskedForHalvesUp) {
  HeightSource from =
      source(write_image("a.png", 4, 1, {"Y"}, TypeDesc::UINT8, std::vector<uint8_t>{0, 8, 9, 255}));
  from.bits = 4;  // 8 * 15 / 255 = 0.47, 9 * 15 / 255 = 0.53
  EXPECT_EQ(load_heights(from).grid.texels, (Heights{0, 0, 1, 15}));
  from.bits = 16;
  EXPECT_EQ(load_heights(from).grid.texels, (Heights{0, 8 * 257, 9 * 257, 65535}));
  from.invert = true;
  from.bits = 8;
  EXPECT_EQ(load_heights(from).grid.texels, (Heights{255, 247, 246, 0}));
}

TEST_F(ImageReader, ReadsAlphaWithoutMultiplyingColoursByIt) {
  std::vector<uint8_t> rgba = {200, 100, 50, 10, 201, 101, 51, 20};
  for (const char* name : {"a.png", "a.tga", "a.tif"}) {
    std::string file = write_image(name, 2, 1, {"R", "G", "B", "A"}, TypeDesc::UINT8, rgba);
    EXPECT_EQ(load_heights(source(file)).grid.texels, (Heights{10, 20})) << name;
    EXPECT_EQ(load_heights(source(file, "alpha")).grid.texels, (Heights{10, 20})) << name;
    EXPECT_EQ(load_heights(source(file, "r")).grid.texels, (Heights{200, 201})) << name;
    EXPECT_EQ(load_heights(source(file, "2")).grid.texels, (Heights{50, 51})) << name;
  }
}

TEST_F(ImageReader, DecidesOnAChannelOnlyWhereTheFileDoes) {
  using Samples = std::vector<uint8_t>;
  auto picture = [&](const Samples& rgba) {
    return write_image("c.png", 2, 1, {"R", "G", "B", "A"}, TypeDesc::UINT8, rgba);
  };
  EXPECT_EQ(load_heights(source(picture({5, 5, 5, 1, 6, 6, 6, 2}))).statement.channel, "R");
  EXPECT_EQ(load_heights(source(picture({5, 5, 5, 1, 6, 6, 7, 2}))).statement.channel, "A");
  std::string undecided = error_of(source(picture({5, 5, 5, 9, 6, 6, 7, 9})));
  EXPECT_NE(undecided.find("0 (R), 1 (G), 2 (B), 3 (A)"), std::string::npos) << undecided;
  std::string unknown = error_of(source(picture({5, 5, 5, 9, 6, 6, 7, 9}), "height"));
  EXPECT_NE(unknown.find("no channel height; there are 0 (R), 1 (G), 2 (B), 3 (A)"), std::string::npos)
      << unknown;
  error_of(source(picture({5, 5, 5, 9, 6, 6, 7, 9}), "4"));

  std::string layers = write_image("l.exr", 1, 1, {"albedo", "base.height", "light"}, TypeDesc::FLOAT,
                                   std::vector<float>{0.1f, 1.0f, 0.3f});
  EXPECT_EQ(load_heights(source(layers)).statement.channel, "base.height");
}

TEST_F(ImageReader, NormalisesFloatsByTheirOwnRangeOnlyWhereTheyLeaveZeroToOne) {
  std::string inside = write_image("i.exr", 3, 1, {"Y"}, TypeDesc::FLOAT, std::vector<float>{0, 0.25f, 0.5f});
  EXPECT_EQ(load_heights(source(inside)).grid.texels, (Heights{0, 16384, 32768}));  // 0.25 * 65535 = 16383.75
  EXPECT_EQ(load_heights(source(inside)).statement.type, "float");
  std::string metres = write_image("m.tif", 3, 1, {"Y"}, TypeDesc::FLOAT, std::vector<float>{-4, 0, 12});
  LoadedHeights terrain = load_heights(source(metres));
  EXPECT_EQ(terrain.grid.texels, (Heights{0, 16384, 65535}));
  EXPECT_EQ(terrain.statement.minimum, -4);
  EXPECT_EQ(terrain.statement.normalisation, "-4 .. 12 becomes 0 .. 65535");
  LoadedHeights clamped = load_heights(range(metres, 0, 10, 8));
  EXPECT_EQ(clamped.grid.texels, (Heights{0, 0, 255}));
  ASSERT_EQ(clamped.statement.notes.size(), 1u);
  EXPECT_EQ(clamped.statement.notes[0], "2 texels lie outside the range and are clamped.");
  HeightSource strict = source(metres);
  strict.normalisation = Normalisation::kNone;
  error_of(strict);
  std::string half =
      write_image("h.exr", 2, 1, {"Y"}, TypeDesc::FLOAT, std::vector<float>{0, 1}, TypeDesc::HALF);
  EXPECT_EQ(load_heights(source(half)).statement.type, "half");
  EXPECT_EQ(load_heights(source(half)).grid.texels, (Heights{0, 65535}));
}

TEST_F(ImageReader, ReadsSignedIntegersByTheirOwnRange) {
  std::string file = write_image("s.tif", 3, 1, {"Y"}, TypeDesc::INT16, std::vector<int16_t>{-10, 0, 30});
  LoadedHeights loaded = load_heights(source(file));
  EXPECT_EQ(loaded.grid.texels, (Heights{0, 16384, 65535}));
  EXPECT_EQ(loaded.statement.type, "int16");
}

TEST_F(ImageReader, MakesAFlatChannelZeroUnderItsOwnRangeAndKeepsItOtherwise) {
  std::string file = write_image("f.png", 2, 2, {"Y"}, TypeDesc::UINT8, std::vector<uint8_t>(4, 77));
  EXPECT_EQ(load_heights(source(file)).grid.texels, Heights(4, 77));
  HeightSource from = source(file);
  from.normalisation = Normalisation::kMinMax;
  EXPECT_EQ(load_heights(from).grid.texels, Heights(4, 0));
}

TEST_F(ImageReader, ReadsTgaFromBothEndsAndInRuns) {
  Bytes up = tga_header(3, 2, 2, 8, false), down = tga_header(3, 2, 2, 8, true),
        runs = tga_header(11, 3, 2, 8, true);
  append(up, {3, 4, 1, 2});
  append(down, {1, 2, 3, 4});
  append(runs, {0x82, 9, 0x02, 1, 2, 3});  // three times 9, then three as they are
  EXPECT_EQ(load_heights(source(write("up.tga", up))).grid.texels, (Heights{1, 2, 3, 4}));
  EXPECT_EQ(load_heights(source(write("down.tga", down))).grid.texels, (Heights{1, 2, 3, 4}));
  EXPECT_EQ(load_heights(source(write("runs.tga", runs))).grid.texels, (Heights{9, 9, 9, 1, 2, 3}));
}

TEST_F(ImageReader, SaysThatAPaletteWasExpanded) {
  Bytes palette = {10, 10, 10, 250, 250, 250, 99, 99, 99};
  std::string indexed = write("p.png", png(3, 1, 3, 0, palette, {0, 2, 1, 0}));
  LoadedHeights loaded = load_heights(source(indexed));
  EXPECT_EQ(loaded.grid.texels, (Heights{99, 250, 10}));
  ASSERT_EQ(loaded.statement.notes.size(), 1u);
  EXPECT_NE(loaded.statement.notes[0].find("palette"), std::string::npos);
  std::string bmp = write("p.bmp", bmp_with_palette(2, 2, {7, 8, 0, 0, 5, 6, 0, 0}));
  loaded = load_heights(source(bmp));
  EXPECT_EQ(loaded.grid.texels, (Heights{250, 249, 248, 247}));
  ASSERT_EQ(loaded.statement.notes.size(), 1u);
}

TEST_F(ImageReader, ReadsInterlacedPng) {
  // 3 x 2 grey, Adam7: pass 1 holds (0, 0), pass 4 (2, 0), pass 6 (1, 0), pass 7 row 1.
  std::string file = write("i.png", png(3, 2, 0, 1, {}, {0, 11, 0, 33, 0, 22, 0, 44, 55, 66}));
  EXPECT_EQ(load_heights(source(file)).grid.texels, (Heights{11, 22, 33, 44, 55, 66}));
}

TEST_F(ImageReader, ReadsJpegNearlyAndSaysThatItIsLossy) {
  std::vector<uint8_t> slope(64 * 64);
  for (size_t k = 0; k < slope.size(); ++k) slope[k] = static_cast<uint8_t>(2 * (k % 64) + k / 64);
  LoadedHeights loaded = load_heights(source(write_image("j.jpg", 64, 64, {"Y"}, TypeDesc::UINT8, slope)));
  for (size_t k = 0; k < slope.size(); ++k) ASSERT_NEAR(loaded.grid.texels[k], slope[k], 8);
  ASSERT_EQ(loaded.statement.notes.size(), 1u);
}

TEST_F(ImageReader, ReadsTiledAndOffsetPictures) {
  std::vector<float> samples(100 * 70);
  for (size_t k = 0; k < samples.size(); ++k) samples[k] = static_cast<float>(k) / 7000;
  OIIO::ImageSpec spec(100, 70, 1, TypeDesc::FLOAT);
  spec.tile_width = spec.tile_height = 32;
  spec.x = 5;
  spec.y = -3;
  auto output = OIIO::ImageOutput::create("exr");
  ASSERT_TRUE(output->open(path("t.exr"), spec) && output->write_image(TypeDesc::FLOAT, samples.data()) &&
              output->close());
  Heights texels = load_heights(source(path("t.exr"))).grid.texels;
  ASSERT_EQ(texels.size(), samples.size());
  for (size_t k = 0; k < samples.size(); ++k)
    ASSERT_EQ(texels[k], static_cast<uint16_t>(samples[k] * 65535.0 + 0.5));
}

TEST_F(ImageReader, GivesBackWhatTheWriterWroteAtEveryDepth) {
  for (int bits = 1; bits <= 16; ++bits) {
    HeightGrid grid = generate("fractal", 40, 30, bits);
    for (const char* name : {"w.png", "w.tif"}) {
      write_height_image(path(name), grid, true);
      HeightSource from = source(path(name));
      from.bits = bits;
      EXPECT_EQ(load_heights(from).grid.texels, grid.texels) << name << " " << bits << " bits";
    }
  }
}

TEST_F(ImageReader, WriterLeavesAFileThatIsThereAndNoPartOfOneThatFails) {
  HeightGrid grid = generate("flat", 4, 4);
  write("old.png", {1, 2, 3});
  EXPECT_THROW(write_height_image(path("old.png"), grid), Error);
  EXPECT_EQ(read_bytes(path("old.png")), (Bytes{1, 2, 3}));
  EXPECT_THROW(write_height_image(path("none/a.png"), grid), Error);
  EXPECT_THROW(write_height_image(path("a.jpg"), grid), Error);
  size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_)) ++files;
  EXPECT_EQ(files, 1u);
}

}  // namespace
}  // namespace cuesta::test
