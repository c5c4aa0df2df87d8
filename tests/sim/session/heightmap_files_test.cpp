#include "sim/session/heightmap_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "models/common/error.h"
#include "models/heightmap/generator.h"
#include "traces/heightmaps/height_source_text.h"

namespace cuesta {
namespace {

class HeightmapFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("cuesta_heightmap_files_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string path(const char* name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

TEST_F(HeightmapFiles, WhatIsMadeReadsBackAsWhatWasGenerated) {
  for (const MapKind& kind : map_kinds()) {
    HeightmapMakeOptions options{std::string(kind.name), path("m.png"), 48, 20, 11, 6, true};
    heightmap_make(options);
    HeightSource source;
    source.path = options.output;
    source.bits = 11;
    EXPECT_EQ(load_heights(source).grid.texels, generate(kind.name, 48, 20, 11, 6).texels) << kind.name;
  }
}

TEST_F(HeightmapFiles, InfoNamesChannelRangeLevelsAndBytes) {
  heightmap_make({"flat", path("f.png"), 6, 3, 8, 1, false});
  HeightSource source;
  source.path = path("f.png");
  std::string text = heightmap_info(source);
  for (const char* part : {"png", "6 x 3 texels", "Y (the only channel)", "uint8, 128 to 128",
                           "128 to 128 of 255, 1 different", "4 levels, 27 nodes of 1 byte", "z = 0.5020"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
  }
}

TEST_F(HeightmapFiles, AFileThatIsThereIsReplacedOnlyWithForce) {
  HeightmapMakeOptions options{"flat", path("f.png"), 2, 2, 8, 1, false};
  heightmap_make(options);
  EXPECT_THROW(heightmap_make(options), Error);
  options.force = true;
  heightmap_make(options);
}

TEST_F(HeightmapFiles, AWatchThatSaysStopLeavesNoFile) {
  const HeightmapMakeOptions options{"noise", path("n.png"), 64, 64, 8, 1, false};
  const Watch stop = [](uint64_t done, uint64_t) { return done < 20; };
  for (bool while_making : {true, false}) {
    try {
      heightmap_make(options, while_making ? stop : Watch(), while_making ? Watch() : stop);
      ADD_FAILURE() << "was not stopped";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::kIncomplete) << error.what();
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder_));
  }
}

TEST_F(HeightmapFiles, AFolderThatIsNotThereIsRefusedBeforeTheWork) {
  const Watch never = [](uint64_t, uint64_t) {
    ADD_FAILURE() << "the map was made";
    return false;
  };
  EXPECT_THROW(heightmap_make({"flat", path("none/f.png"), 2, 2, 8, 1, false}, never, never), Error);
}

TEST_F(HeightmapFiles, InfoTellsOfCellsWithoutDataAndOddSizes) {
  heightmap_make({"steps", path("s.png"), 20, 5, 8, 1, false});
  HeightSource source;
  source.path = path("s.png");
  source.nodata = 255;
  const std::string text = heightmap_info(source);
  for (const char* part : {"no data     5 of 100 cells, marked by 255 (asked for)", "no square power of two",
                           "part of one of 32 x 32", "blocks_4x4", "ki2007_slices"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
  }
}

TEST_F(HeightmapFiles, HeightsOnACommandLineAreAFileAChannelAndKeys) {
  HeightSource plain = parse_height_source("a/b.tga");
  EXPECT_EQ(plain.path, "a/b.tga");
  EXPECT_EQ(plain.channel, "");
  HeightSource full = parse_height_source("dem, old.tif:A,values=depth,bits=12,range=-4.5..921,nodata=nan");
  EXPECT_EQ(full.path, "dem, old.tif");
  EXPECT_EQ(full.channel, "A");
  EXPECT_TRUE(full.invert);
  EXPECT_EQ(full.bits, 12);
  EXPECT_EQ(full.normalisation, Normalisation::kRange);
  EXPECT_EQ(full.low, -4.5);
  EXPECT_EQ(full.high, 921);
  EXPECT_TRUE(full.nodata && *full.nodata != *full.nodata);
  HeightSource raw = parse_height_source("m.raw,raw=64x32:int16:big,normalise=min_max");
  EXPECT_EQ(raw.raw.width, 64);
  EXPECT_EQ(raw.raw.height, 32);
  EXPECT_EQ(raw.raw.numbers, SampleKind::kInt16);
  EXPECT_TRUE(raw.raw.big_endian);
  heightmap_make({"flat", path("x,bits=3.png"), 2, 2, 8, 1, false});
  EXPECT_EQ(parse_height_source(path("x,bits=3.png")).path, path("x,bits=3.png"));
  for (const char* wrong :
       {"m.png,bits=0", "m.png,bits=17", "m.png,bits=", "m.png,bit=8", "m.png,values=up", "m.png,raw=4",
        "m.png,bits=8,bits=9", "m.png,range=0..1,normalise=none", "m.png,nodata=x"}) {
    EXPECT_THROW(parse_height_source(wrong), Error) << wrong;
  }
}

TEST_F(HeightmapFiles, RangesAreReadWholeOrRefused) {
  double low = 0, high = 0;
  parse_height_range("-4.5,900", "--range", low, high);
  EXPECT_EQ(low, -4.5);
  EXPECT_EQ(high, 900);
  parse_height_range("-9..-4.5", "--range", low, high);
  EXPECT_EQ(low, -9);
  EXPECT_EQ(high, -4.5);
  for (const char* wrong :
       {"", "1", "1,", ",1", "1,2,3", "a,b", "1;2", "2..1", "1..1", "0..inf", "nan..1", ".."}) {
    EXPECT_THROW(parse_height_range(wrong, "--range", low, high), Error) << wrong;
  }
}

}  // namespace
}  // namespace cuesta
