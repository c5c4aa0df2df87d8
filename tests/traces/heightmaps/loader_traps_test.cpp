#include "tests/traces/heightmaps/loader_traps.h"
#include "models/heightmap/pyramid.h"

// What real files hold that a loader falls into; the table of traces/heightmaps/README.md names these tests.

namespace cuesta::test {
namespace {

TEST_F(LoaderTraps, HeightInTheAlphaOfANormalMapOrAnAlbedoIsTakenAndTheReasonSaid) {
  std::vector<uint8_t> rgba = {128, 127, 255, 10, 90, 140, 240, 20, 128, 128, 255, 30, 170, 100, 230, 40};
  for (const char* name : {"n.tga", "n.png", "n.tif"}) {
    LoadedHeights loaded =
        load_heights(source(write_image(name, 2, 2, {"R", "G", "B", "A"}, TypeDesc::UINT8, rgba)));
    EXPECT_EQ(loaded.grid.texels, (Heights{10, 20, 30, 40})) << name;
    EXPECT_EQ(loaded.statement.channel_reason, "R, G and B differ and alpha is not constant");
  }
}

TEST_F(LoaderTraps, ColoursWithoutAVaryingAlphaAreRefusedWithTheChannelsThereAre) {
  std::string normals = write_image("n.png", 2, 1, {"R", "G", "B"}, TypeDesc::UINT8,
                                    std::vector<uint8_t>{128, 127, 255, 90, 140, 240});
  EXPECT_NE(error_of(source(normals)).find("name one of its channels 0 (R), 1 (G), 2 (B)"),
            std::string::npos);
  EXPECT_EQ(load_heights(source(normals, "G")).grid.texels, (Heights{127, 140}));
}

TEST_F(LoaderTraps, DepthIsTurnedOverWhenItIsSaidAndAChannelCalledDepthIsRemarkedOn) {
  std::string file = write_image("d.exr", 3, 1, {"depth"}, TypeDesc::FLOAT, std::vector<float>{0, 0.25f, 1});
  LoadedHeights plain = load_heights(source(file));
  EXPECT_EQ(plain.grid.texels, (Heights{0, 16384, 65535}));
  EXPECT_TRUE(noted(plain, "values = \"depth\" turns it over"));
  HeightSource from = source(file);
  from.invert = true;
  LoadedHeights turned = load_heights(from);
  EXPECT_EQ(turned.grid.texels, (Heights{65535, 65535 - 16384, 0}));
  EXPECT_TRUE(noted(turned, "holds depth"));
}

TEST_F(LoaderTraps, TgaInRunsFromBelowWithAlphaComesOutUprightAndUnmultiplied) {
  Bytes file = tga_header(10, 3, 2, 32, false);
  append(file, {0x81, 50, 100, 200, 7, 0x00, 51, 101, 201, 8});             // the lower row: 7, 7, 8
  append(file, {0x02, 52, 102, 202, 1, 53, 103, 203, 2, 54, 104, 204, 3});  // the upper: 1, 2, 3
  EXPECT_EQ(load_heights(source(write("r.tga", file))).grid.texels, (Heights{1, 2, 3, 7, 7, 8}));
  EXPECT_EQ(load_heights(source(path("r.tga"), "R")).grid.texels, (Heights{202, 203, 204, 200, 200, 201}));
}

TEST_F(LoaderTraps, TgaFromTheRightIsNotReadMirroredInSilence) {
  Bytes file = tga_header(3, 3, 1, 8, true);
  file[17] |= 0x10;  // rows run from right to left
  append(file, {1, 2, 3});
  try {
    EXPECT_EQ(load_heights(source(write("r.tga", file))).grid.texels, (Heights{3, 2, 1}));
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("right"), std::string::npos) << error.what();
  }
}

TEST_F(LoaderTraps, PalettesAreReadAsTheGreysTheyStandFor) {
  Bytes palette = {10, 10, 10, 250, 250, 250, 99, 99, 99};
  LoadedHeights loaded = load_heights(source(write("p.png", png(3, 1, 3, 0, palette, {0, 2, 1, 0}))));
  EXPECT_EQ(loaded.grid.texels, (Heights{99, 250, 10}));
  EXPECT_TRUE(noted(loaded, "palette"));
  loaded = load_heights(source(write("p.tif", tiff(3, 1, {8, 1, 3, false, ""}, {2, 255, 0}))));
  EXPECT_EQ(loaded.grid.texels, (Heights{2, 255, 0}));
  EXPECT_TRUE(noted(loaded, "palette"));
}

TEST_F(LoaderTraps, PngOfFewBitsIsScaledToFullWhiteAndSixteenBitsStaySixteen) {
  // 4 x 1 of 2 bits in one byte: 0, 1, 2, 3 of 3.
  EXPECT_EQ(load_heights(source(write("two.png", png(4, 1, 0, 0, {}, {0, 0b00011011}, 2)))).grid.texels,
            (Heights{0, 85, 170, 255}));
  EXPECT_EQ(load_heights(source(write("one.png", png(3, 1, 0, 0, {}, {0, 0b10100000}, 1)))).grid.texels,
            (Heights{255, 0, 255}));
  LoadedHeights wide =
      load_heights(source(write("wide.png", png(2, 1, 0, 0, {}, {0, 0x12, 0x34, 0xFF, 0xFE}, 16))));
  EXPECT_EQ(wide.grid.texels, (Heights{0x1234, 0xFFFE}));
  EXPECT_EQ(wide.grid.bits, 16);
}

TEST_F(LoaderTraps, Rgb16WithEqualChannelsIsReadAtSixteenBits) {
  Bytes row = {0, 1, 2, 1, 2, 1, 2, 0xAB, 0xCD, 0xAB, 0xCD, 0xAB, 0xCD};
  LoadedHeights loaded = load_heights(source(write("c.png", png(2, 1, 2, 0, {}, row, 16))));
  EXPECT_EQ(loaded.grid.texels, (Heights{0x0102, 0xABCD}));
  EXPECT_EQ(loaded.statement.channel_reason, "R = G = B in every pixel");
  row[4] = 3;  // one low byte of G: the high bytes alone would not tell
  error_of(source(write("d.png", png(2, 1, 2, 0, {}, row, 16))));
}

TEST_F(LoaderTraps, InterlacedPngOfSixteenBitsIsPutTogether) {
  // 3 x 2 grey, Adam7: pass 1 holds (0, 0), pass 4 (2, 0), pass 6 (1, 0), pass 7 row 1.
  Bytes passes = {0, 1, 11, 0, 1, 33, 0, 1, 22, 0, 1, 44, 1, 55, 1, 66};
  EXPECT_EQ(load_heights(source(write("i.png", png(3, 2, 0, 1, {}, passes, 16)))).grid.texels,
            (Heights{256 + 11, 256 + 22, 256 + 33, 256 + 44, 256 + 55, 256 + 66}));
}

TEST_F(LoaderTraps, SixteenBitsOfOnly157LevelsAreKeptAndRemarkedOn) {
  Heights samples(80 * 60);
  for (size_t k = 0; k < samples.size(); ++k) samples[k] = static_cast<uint16_t>(k % 157 * 417);
  LoadedHeights loaded = load_heights(source(write_image("l.png", 80, 60, {"Y"}, TypeDesc::UINT16, samples)));
  EXPECT_EQ(loaded.grid.texels, samples);
  EXPECT_EQ(loaded.statement.distinct_levels, 157);
  EXPECT_TRUE(noted(loaded, "only 157 different values"));
}

TEST_F(LoaderTraps, NegativeHeightsOfFloatAndHalfAreStretchedByTheirOwnRange) {
  for (const char* name : {"f.tif", "f.exr"}) {
    std::string file = write_image(name, 3, 1, {"Y"}, TypeDesc::FLOAT, std::vector<float>{-4, 0, 12});
    EXPECT_EQ(load_heights(source(file)).grid.texels, (Heights{0, 16384, 65535})) << name;
  }
  std::string half =
      write_image("h.exr", 3, 1, {"Y"}, TypeDesc::FLOAT, std::vector<float>{-4, 0, 12}, TypeDesc::HALF);
  EXPECT_EQ(load_heights(source(half)).statement.type, "half");
  EXPECT_EQ(load_heights(source(half)).grid.texels, (Heights{0, 16384, 65535}));
  std::string real =
      write("d.tif", tiff(3, 2, {64, 3, 1, true, ""}, little_endian<double>({-1e9, 1e9, 0, 0, 0, 0}, true)));
  EXPECT_EQ(load_heights(source(real)).statement.type, "double");
  EXPECT_EQ(load_heights(source(real)).grid.texels, (Heights{0, 65535, 32768, 32768, 32768, 32768}));
}

TEST_F(LoaderTraps, NoRowOfATiffOfDoublesIsLost) {
  for (int height : {2, 65, 97, 129}) {
    std::vector<double> rows;
    Heights expected;
    for (int k = 0; k < 2 * height; ++k) {
      rows.push_back(k % 2 == 0 ? 0 : k);
      expected.push_back(static_cast<uint16_t>(rows.back() / (2 * height - 1) * 65535 + 0.5));
    }
    std::string file = write("d.tif", tiff(2, height, {64, 3, 1, false, ""}, little_endian(rows)));
    EXPECT_EQ(load_heights(source(file)).grid.texels, expected) << height << " rows in one strip";
    for (int strip : {1, 32}) {
      OIIO::ImageSpec spec(2, height, 1, TypeDesc::DOUBLE);
      spec.attribute("tiff:RowsPerStrip", strip);
      auto output = OIIO::ImageOutput::create("tif");
      ASSERT_TRUE(output->open(path("s.tif"), spec) && output->write_image(TypeDesc::DOUBLE, rows.data()) &&
                  output->close());
      EXPECT_EQ(load_heights(source(path("s.tif"))).grid.texels, expected)
          << height << " rows in strips of " << strip;
    }
  }
  std::string one = write("one.tif", tiff(2, 1, {64, 3, 1, false, ""}, little_endian<double>({1, 2})));
  EXPECT_NE(error_of(source(one)).find("TIFF of doubles of one row"), std::string::npos);
}

TEST_F(LoaderTraps, DdsBlocksAreDecodedAlphaAlone) {
  Bytes block = two_value_block(200, 40, 0b1000'0000'0000'0010);
  append(block,
         {0xFF, 0xFF, 0, 0, 0x54, 0x55, 0x55, 0x55});  // texel 0 white, the others black: R, G, B equal
  LoadedHeights grey = load_heights(source(write("bc3.dds", dds(4, 4, "DXT5", block))));
  EXPECT_EQ(grey.statement.format, "dds");
  EXPECT_EQ(grey.statement.channel, "R");
  Heights alpha = load_heights(source(path("bc3.dds"), "A")).grid.texels;
  Heights expected(16, 200);
  expected[1] = expected[15] = 40;
  EXPECT_EQ(alpha, expected);
  block[8] = 0x00, block[9] = 0xF8;  // texel 0 red: now the colours differ
  EXPECT_EQ(load_heights(source(write("red.dds", dds(4, 4, "DXT5", block)))).grid.texels, expected);
}

TEST_F(LoaderTraps, DdsOfOneAndTwoChannelsIsReadOrTheChannelAskedFor) {
  Bytes block = two_value_block(17, 230, 0b0000'0000'0001'0000);
  Heights expected(16, 17);
  expected[4] = 230;
  EXPECT_EQ(load_heights(source(write("bc4.dds", dds(4, 4, "ATI1", block)))).grid.texels, expected);
  append(block, two_value_block(90, 91, 1));
  std::string two = write("bc5.dds", dds(4, 4, "ATI2", block));
  EXPECT_NE(error_of(source(two)).find("name one of its channels"), std::string::npos);
  EXPECT_EQ(load_heights(source(two, "R")).grid.texels, expected);
}

TEST_F(LoaderTraps, WhiteIsZeroIsTurnedAsTheFormatHasIt) {
  std::string file = write("w.tif", tiff(3, 1, {8, 1, 0, false, ""}, {0, 100, 255}));
  EXPECT_EQ(load_heights(source(file)).grid.texels, (Heights{255, 155, 0}));
}

TEST_F(LoaderTraps, AnySizeIsReadAndItsPyramidNeedsNoCopy) {
  const std::pair<int, int> sizes[] = {{1, 1},    {1, 7},     {7, 1},     {5, 3},    {33, 33},
                                       {129, 65}, {16384, 1}, {1, 16384}, {16384, 2}};
  for (auto [width, height] : sizes) {
    Heights samples(static_cast<size_t>(width) * static_cast<size_t>(height));
    for (size_t k = 0; k < samples.size(); ++k) samples[k] = static_cast<uint16_t>(k * 7919);
    LoadedHeights loaded =
        load_heights(source(write_image("s.png", width, height, {"Y"}, TypeDesc::UINT16, samples)));
    ASSERT_EQ(loaded.grid.texels, samples) << width << " x " << height;
    const uint16_t* place = loaded.grid.texels.data();
    Pyramid pyramid = build_max_pyramid(std::move(loaded.grid));
    EXPECT_EQ(pyramid.level(0), place) << width << " x " << height;
    EXPECT_EQ(pyramid.at(pyramid.root_level(), 0, 0), *std::max_element(samples.begin(), samples.end()));
  }
}

TEST_F(LoaderTraps, ASideBeyond16384IsRefused) {
  error_of(source(write("wide.png", png(16385, 1, 0, 0, {}, Bytes(16386, 0)))));
  std::string text = "ncols 16385\nnrows 1\n1\n";
  error_of(source(write("wide.asc", Bytes(text.begin(), text.end()))));
}

TEST_F(LoaderTraps, FlatAndLowMapsStayAsTheyAreAndFlatOnesOfMetresAreTheFloor) {
  std::string grey = write_image("g.png", 2, 2, {"Y"}, TypeDesc::UINT8, std::vector<uint8_t>(4, 77));
  EXPECT_EQ(load_heights(source(grey)).grid.texels, Heights(4, 77));
  std::string low = write_image("l.exr", 2, 1, {"Y"}, TypeDesc::FLOAT, std::vector<float>{0, 0.5f});
  EXPECT_EQ(load_heights(source(low)).grid.texels, (Heights{0, 32768}));
  std::string sea = write_image("s.tif", 2, 1, {"Y"}, TypeDesc::FLOAT, std::vector<float>{-3, -3});
  LoadedHeights loaded = load_heights(source(sea));
  EXPECT_EQ(loaded.grid.texels, (Heights{0, 0}));
  EXPECT_TRUE(noted(loaded, "flat"));
}

}  // namespace
}  // namespace cuesta::test
