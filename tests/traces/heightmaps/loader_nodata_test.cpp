#include "tests/traces/heightmaps/loader_traps.h"

// Cells without data, and the files of numbers (grids of text, tiles, files without a header) that have them; named in
// the table of traces/heightmaps/README.md like those of loader_traps_test.cpp.

namespace cuesta::test {
namespace {

TEST_F(LoaderTraps, NanAndInfinityAreRefusedWithTheirCountOrTakenForEmptyWhenNamed) {
  std::vector<float> samples = {1, static_cast<float>(kNan), 3, static_cast<float>(kNan), 2, 1};
  for (const char* name : {"n.exr", "n.tif"}) {
    for (TypeDesc stored : {TypeDesc::FLOAT, TypeDesc::HALF}) {
      std::string file = write_image(name, 3, 2, {"Y"}, TypeDesc::FLOAT, samples, stored);
      EXPECT_NE(error_of(source(file)).find("NaN in channel Y at pixel (1, 0) and 1 more such numbers"),
                std::string::npos);
      LoadedHeights loaded = load_heights(with_nodata(file, kNan));
      EXPECT_EQ(loaded.grid.texels, (Heights{0, 0, 65535, 0, 32768, 0}));
      EXPECT_EQ(loaded.statement.nodata_cells, 2u);
    }
  }
  const float infinity = std::numeric_limits<float>::infinity();
  std::string file = write_image("i.exr", 3, 1, {"Y"}, TypeDesc::FLOAT, std::vector<float>{1, -infinity, 2});
  EXPECT_NE(error_of(source(file)).find("infinity in channel Y at pixel (1, 0);"), std::string::npos);
  EXPECT_EQ(load_heights(with_nodata(file, -infinity)).grid.texels, (Heights{0, 0, 65535}));
  error_of(with_nodata(file, infinity));
}

TEST_F(LoaderTraps, GdalNodataOfATiffIsFilledWithTheFloorInBothByteOrders) {
  for (bool big : {false, true}) {
    std::string reals = write(
        "f.tif", tiff(4, 1, {32, 3, 1, big, "-9999"}, little_endian<float>({100, -9999, 300, 200}, big)));
    LoadedHeights loaded = load_heights(source(reals));
    EXPECT_EQ(loaded.grid.texels, (Heights{0, 0, 65535, 32768}));
    EXPECT_EQ(loaded.statement.minimum, 100);
    EXPECT_EQ(loaded.statement.nodata_cells, 1u);
    EXPECT_EQ(loaded.statement.nodata, "-9999 (the file's GDAL_NODATA tag)");
    EXPECT_TRUE(noted(loaded, "1 cells hold no data and become height 0."));
    std::string metres =
        write("i.tif", tiff(3, 1, {16, 2, 1, big, "-32768"}, little_endian<int16_t>({-32768, 10, 30}, big)));
    EXPECT_EQ(load_heights(source(metres)).grid.texels, (Heights{0, 0, 65535}));
    std::string bytes = write("b.tif", tiff(3, 1, {8, 1, 1, big, "255"}, {7, 255, 9}));
    EXPECT_EQ(load_heights(source(bytes)).grid.texels, (Heights{7, 0, 9}));
  }
  const float least = std::numeric_limits<float>::lowest();
  std::string lowest = write(
      "l.tif", tiff(3, 1, {32, 3, 1, false, "-3.4028234663852886e+38"}, little_endian<float>({1, least, 2})));
  EXPECT_EQ(load_heights(source(lowest)).grid.texels, (Heights{0, 0, 65535}));
  std::string nans = write(
      "n.tif", tiff(3, 1, {32, 3, 1, false, "nan"}, little_endian<float>({1, static_cast<float>(kNan), 2})));
  EXPECT_EQ(load_heights(source(nans)).grid.texels, (Heights{0, 0, 65535}));
  std::string words = write("w.tif", tiff(2, 1, {8, 1, 1, false, "nothing"}, {7, 9}));
  EXPECT_EQ(load_heights(source(words)).statement.nodata, "");
}

TEST_F(LoaderTraps, CellsWithoutDataAreTheFloorAlsoUnderDepthAndWhateverTheNormalisation) {
  std::string file = write_image("d.png", 3, 1, {"Y"}, TypeDesc::UINT8, std::vector<uint8_t>{0, 255, 100});
  HeightSource from = with_nodata(file, 255);
  EXPECT_EQ(load_heights(from).grid.texels, (Heights{0, 0, 100}));
  from.invert = true;
  EXPECT_EQ(load_heights(from).grid.texels, (Heights{255, 0, 155}));
  from.normalisation = Normalisation::kMinMax;
  EXPECT_EQ(load_heights(from).grid.texels, (Heights{255, 0, 0}));
  EXPECT_TRUE(noted(load_heights(with_nodata(file, -9999)), "No cell holds -9999"));
}

TEST_F(LoaderTraps, CommonMarkersWithoutATagAreRefusedUntilTheyAreNamed) {
  for (float marker : {-9999.0f, -32768.0f, -3.4028235e38f}) {
    std::string file =
        write_image("m.tif", 3, 1, {"Y"}, TypeDesc::FLOAT, std::vector<float>{100, marker, 300});
    EXPECT_NE(error_of(source(file)).find("give nodata = "), std::string::npos);
    EXPECT_EQ(load_heights(with_nodata(file, marker)).grid.texels, (Heights{0, 0, 65535}));
  }
}

TEST_F(LoaderTraps, AMapWithoutAnyDataIsRefused) {
  std::string file =
      write("e.tif", tiff(2, 1, {16, 2, 1, false, "-32767"}, little_endian<int16_t>({-32767, -32767})));
  EXPECT_NE(error_of(source(file)).find("no data in any of its 2 cells"), std::string::npos);
}

TEST_F(LoaderTraps, RaggedDemWithMissingCornersHasItsCornersOnTheFloor) {
  const int16_t gone = -32767;
  std::vector<int16_t> metres = {gone, 200,  210, gone,  //
                                 190,  205,  230, 240,   //
                                 gone, 195,  220, 225,   //
                                 gone, gone, 205, gone};
  LoadedHeights loaded =
      load_heights(source(write("usgs.tif", tiff(4, 4, {16, 2, 1, false, "-32767"}, little_endian(metres)))));
  EXPECT_EQ(loaded.statement.nodata_cells, 6u);
  EXPECT_EQ(loaded.statement.minimum, 190);
  for (size_t k = 0; k < metres.size(); ++k) {
    const double share = metres[k] == gone ? 0 : (metres[k] - 190) / 50.0;
    EXPECT_EQ(loaded.grid.texels[k], static_cast<uint16_t>(share * 65535 + 0.5));
  }
}

std::string text_grid(const std::string& header, const std::string& rows) {
  return "ncols 3\r\nnrows 2\nxllcorner 440720.5\nyllcorner 3.75e6\ncellsize 30\n" + header + rows;
}

TEST_F(LoaderTraps, TextGridsAreReadWithTheirOwnMarkerAndRaggedOnesRefusedByTheirLine) {
  auto grid = [&](const std::string& text) {
    write("g.asc", Bytes(text.begin(), text.end()));
    return source(path("g.asc"));
  };
  LoadedHeights loaded = load_heights(grid(text_grid("NODATA_value -1\n", "10 20 -1\n 12.5\t+15 20\r\n")));
  EXPECT_EQ(loaded.statement.format, "esri ascii grid");
  EXPECT_EQ(loaded.grid.texels, (Heights{0, 65535, 0, 16384, 32768, 65535}));
  EXPECT_EQ(loaded.statement.nodata, "-1 (the file's NODATA_value)");
  EXPECT_EQ(load_heights(grid(text_grid("", "10 20 -9999 12.5 15\n20"))).grid.texels, loaded.grid.texels);
  std::string ragged = error_of(grid(text_grid("", "10 20 30\n40 50\n")));
  EXPECT_NE(ragged.find("holds 5 numbers, and 3 x 2 are 6; line 7 is the first that has not 3 but 2"),
            std::string::npos)
      << ragged;
  EXPECT_NE(error_of(grid(text_grid("", "1 2 3\n4 5 6\n7"))).find("holds 7 numbers"), std::string::npos);
  EXPECT_NE(error_of(grid(text_grid("", "1 2 3\n4 x 6\n"))).find("has \"x\" in line 7"), std::string::npos);
  EXPECT_NE(error_of(grid(text_grid("", "1 2,5 3\n4 5 6\n"))).find("\"2,5\""), std::string::npos);
  EXPECT_NE(error_of(grid("ncols 3\n1 2 3\n")).find("states no ncols and nrows"), std::string::npos);
  EXPECT_NE(error_of(grid("ncols 3\nnrows 99999\n1 2 3\n")).find("1 to 16384"), std::string::npos);
  EXPECT_NE(error_of(grid("ncols 3\nnrows 1\n")).find("no numbers"), std::string::npos);
  EXPECT_NE(error_of(grid("hello\n")).find("has \"hello\" as line 1"), std::string::npos);
}

TEST_F(LoaderTraps, HeaderlessFilesAreReadByTheirNameOrByWhatIsSaid) {
  Bytes words = little_endian<uint16_t>({1, 256, 65535, 4, 5, 6});
  Heights expected = {1, 256, 65535, 4, 5, 6};
  LoadedHeights named = load_heights(source(write("map_3x2.r16", words)));
  EXPECT_EQ(named.grid.texels, expected);
  EXPECT_EQ(named.grid.width, 3);
  EXPECT_TRUE(noted(named, "by its name it is taken as 3 x 2 numbers of uint16, little-endian."));
  EXPECT_EQ(load_heights(source(write("v2-3X2.raw", words))).grid.texels, expected);
  EXPECT_EQ(load_heights(source(write("b_2x3.RAW", {9, 8, 7, 6, 5, 4}))).grid.texels,
            (Heights{9, 8, 7, 6, 5, 4}));
  EXPECT_EQ(load_heights(source(write("b_2x3.r8", {9, 8, 7, 6, 5, 4}))).grid.bits, 8);
  HeightSource from = source(write("m.bin", little_endian<int16_t>({-5, 0, 15, -5, 0, 15}, true)));
  from.raw = parse_raw_shape("3x2:int16:big", "--raw");
  EXPECT_EQ(load_heights(from).grid.texels, (Heights{0, 16384, 65535, 0, 16384, 65535}));
  from = source(write("f.raw", little_endian<float>({0, 0.5f})));
  from.raw = parse_raw_shape("1x2:float", "--raw");
  EXPECT_EQ(load_heights(from).grid.texels, (Heights{0, 32768}));
}

TEST_F(LoaderTraps, HeaderlessFilesOfUnknownShapeAreRefusedWithWhatToGive) {
  std::string unknown = error_of(source(write("terrain.raw", Bytes(8192, 1))));
  EXPECT_NE(unknown.find("its 8192 bytes would be 64 x 64 numbers of uint16"), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("--raw"), std::string::npos);
  error_of(source(write("terrain.r16", Bytes(10, 1))));
  std::string wrong = error_of(source(write("map_4x4.r16", Bytes(31, 1))));
  EXPECT_NE(wrong.find("has 31 bytes; 4 x 4 numbers of uint16 are 32"), std::string::npos) << wrong;
  error_of(source(write("map_99999x1.r8", Bytes(31, 1))));
  for (const char* shape :
       {"", "4", "4x", "0x4", "4x16385", "4x4:uint12", "4x4:uint8:middle", "4x4:uint8:big:x"}) {
    EXPECT_THROW(parse_raw_shape(shape, "--raw"), Error) << shape;
  }
  HeightSource named = source(write("c_2x2.r8", Bytes(4, 1)), "A");
  error_of(named, ExitCode::kUsage);
}

TEST_F(LoaderTraps, SrtmTilesAreBigEndianAndTheirVoidsAreTheFloor) {
  std::vector<int16_t> metres(1201 * 1201, 100);
  metres[0] = -32768;
  metres[1] = 300;
  LoadedHeights loaded = load_heights(source(write("N46W122.hgt", little_endian(metres, true))));
  EXPECT_EQ(loaded.grid.width, 1201);
  EXPECT_EQ(loaded.grid.at(0, 0), 0);
  EXPECT_EQ(loaded.grid.at(1, 0), 65535);
  EXPECT_EQ(loaded.statement.minimum, 100);
  EXPECT_EQ(loaded.statement.nodata_cells, 1u);
  error_of(source(write("N46W123.hgt", Bytes(2000, 0))));
}

}  // namespace
}  // namespace cuesta::test
