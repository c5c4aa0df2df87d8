#include "models/algorithms/search.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "models/common/error.h"

namespace cuesta {
namespace {

TEST(Search, RowsStandInTheOrderOfTheKinds) {
  ASSERT_EQ(search_rows().size(), static_cast<size_t>(SearchKind::kDrobot2009Printed) + 1);
  std::set<std::string_view> ids;
  for (size_t k = 0; k < search_rows().size(); ++k) {
    EXPECT_EQ(static_cast<size_t>(search_rows()[k].search.kind), k) << search_rows()[k].id;
    EXPECT_TRUE(ids.insert(search_rows()[k].id).second);
    EXPECT_EQ(find_search(search_rows()[k].id), &search_rows()[k]);
  }
}

TEST(Search, HasTheParametersThatThePapersPrint) {
  EXPECT_EQ(parse_search("relief"), (Search{SearchKind::kRelief, 100, 0, 7}));
  EXPECT_EQ(parse_search("cone"), (Search{SearchKind::kCone, 100}));
  EXPECT_EQ(parse_search("relaxed-cone"), (Search{SearchKind::kRelaxedCone, 15, 0, 8}));
  EXPECT_EQ(parse_search("pom-tatarchuk"), (Search{SearchKind::kPomTatarchuk, 50, 8}));
}

TEST(Search, IsReadBackFromItsName) {
  std::set<std::string> names;
  for (const SearchRow& row : search_rows()) {
    if (is_printed(row.search.kind)) continue;
    for (const int steps : {8, row.search.steps, 512}) {
      for (const int refinements : {0, row.search.refinements}) {
        for (const SearchFilter filter : {SearchFilter::kTexel, SearchFilter::kBilinear}) {
          Search search = row.search;
          if (search.steps > 0) search.steps = steps;
          if (row.refines) search.refinements = refinements;
          search.filter = filter;
          names.insert(name_of(search));
          EXPECT_EQ(parse_search(name_of(search)), search) << name_of(search);
        }
      }
    }
  }
  // 3 kinds without steps, 6 with steps alone, 4 that refine as well; each twice for the filter.
  EXPECT_EQ(names.size(), 2u * (3 + 6 * 3 + 4 * 3 * 2));
}

TEST(Search, AsPrintedIsReadBackFromItsName) {
  std::set<std::string> names;
  for (const char* id : {"ki2007-printed", "drobot2009-printed"}) {
    for (const int delta : {0, 1, 5, 10, 500, 1000, 1250, kMostDelta}) {
      for (const bool slope : {false, true}) {
        for (const bool linear : {false, true}) {
          Search search = find_search(id)->search;
          search.delta = delta;
          search.slope = slope;
          search.linear = linear && search.kind == SearchKind::kKi2007Printed;
          names.insert(name_of(search));
          EXPECT_EQ(parse_search(name_of(search)), search) << name_of(search);
        }
      }
    }
  }
  EXPECT_EQ(names.size(), 8u * (4 + 2));
}

TEST(Search, NamesLeaveOutWhatTheRowSays) {
  const std::pair<std::string_view, std::string_view> cases[] = {
      {"relief:refine=7:steps=100", "relief"},
      {"relief:refine=0:steps=64", "relief:steps=64:refine=0"},
      {"pom:least=4", "pom:least=4"},
      {"cone:bilinear:steps=16", "cone:steps=16:bilinear"},
      {"ki2007-printed:delta=0.5", "ki2007-printed"},
      {"ki2007-printed:linear:delta=0.005:steps=64", "ki2007-printed:steps=64:delta=0.005:linear"},
      {"drobot2009-printed:slope:delta=00.0", "drobot2009-printed:delta=0:slope"},
  };
  for (const auto& [text, canonical] : cases) EXPECT_EQ(name_of(parse_search(text)), canonical) << text;
}

TEST(Search, AFaultNamesTheWordAndWhatIsAccepted) {
  const std::pair<std::string_view, std::string_view> cases[] = {
      {"relief:step=9",
       "`step=9` is not an ending of relief; accepted are steps=N (1 to 4096), refine=N (0 "
       "to 64), bilinear; did you mean `steps`?"},
      {"relief:steps=0", "`steps` is `0`; accepted is a whole number from 1 to 4096, as in steps=100."},
      {"relief:refine=65", "`refine` is `65`; accepted is a whole number from 0 to 64, as in refine=7."},
      {"cone:refine=3", "accepted are steps=N (1 to 4096), bilinear."},
      {"parallax:steps=3", "accepted are bilinear."},
      {"steep:steps", "`steps` has no value; accepted is a whole number from 1 to 4096"},
      {"steep:steps=4x", "`steps` is `4x`; accepted is a whole number"},
      {"steep:steps=4:steps=5", "`steps` is given twice"},
      {"pom:steps=4", "least=8 is above steps=4"},
      {"steep:", "`` is not an ending"},
      {"steep:slope", "`slope` is not an ending"},
      {"steep:delta=1", "`delta=1` is not an ending"},
      {"drobot2009-printed:linear",
       "`linear` is not an ending of drobot2009-printed; accepted are steps=N (1 to 4096), delta=TEXELS (0 "
       "to "
       "64, three places at most), slope."},
      {"ki2007-printed:bilinear", "`bilinear` is not an ending"},
      {"ki2007-printed:delta=0.0005",
       "`delta` is `0.0005`; accepted is a number of texels from 0 to 64 with a decimal point and three "
       "places "
       "at most, as in delta=0.5."},
      {"ki2007-printed:delta=0,5",
       "`delta` is `0,5`; accepted is a number of texels from 0 to 64 with a decimal"},
      {"ki2007-printed:delta=-1", "`delta` is `-1`"},
      {"ki2007-printed:delta=1.", "`delta` is `1.`"},
      {"ki2007-printed:delta=65", "`delta` is `65`"},
      {"ki2007-printed:delta", "`delta` has no value"},
      {"ki2007-printed:slope=1", "`slope=1` has a value, which `slope` does not take"},
      {"cone:bilinear=1", "accepted is `bilinear` alone"},
      {"ki2007-printed:slop", "did you mean `slope`?"},
      {"ki2007-printed:slope:slope", "`slope` is given twice"},
  };
  for (const auto& [text, part] : cases) {
    try {
      parse_search(text);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::kUsage);
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace cuesta
