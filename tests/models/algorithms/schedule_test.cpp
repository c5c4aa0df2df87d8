#include "models/algorithms/schedule.h"

#include <gtest/gtest.h>

#include <set>

#include "models/common/error.h"

namespace cuesta {
namespace {

std::vector<Schedule> every_schedule() {
  std::vector<Schedule> list;
  for (int start = 0; start < 3; ++start) {
    for (const int down : {1, 2, 3, kDownCommon}) {
      for (int up = 0; up < 8; ++up) {
        for (const int stop : {0, 1, 7, 14}) {
          for (int fetch = 0; fetch < 2; ++fetch) {
            list.push_back({static_cast<StartRule>(start), down, static_cast<UpRule>(up), stop,
                            static_cast<FetchRule>(fetch)});
          }
        }
      }
    }
  }
  return list;
}

TEST(Schedule, EveryCombinationIsReadBackFromItsNameAndNamesDiffer) {
  std::set<std::string> names;
  for (const Schedule& schedule : every_schedule()) {
    const std::string name = name_of(schedule);
    EXPECT_TRUE(names.insert(name).second) << name;
    const Algorithm read = parse_algorithm(name);
    Schedule expected = schedule;
    if (expected.start == StartRule::kLeaf) expected.down = 1;  // never matters
    EXPECT_EQ(read.schedule, expected) << name;
    EXPECT_EQ(read.id, name_of(expected));
  }
  EXPECT_EQ(names.size(), 3u * 4 * 8 * 4 * 2);
}

TEST(Schedule, NamesAreCanonical) {
  const std::pair<std::string_view, std::string_view> cases[] = {
      {"span:2:selective-even", "yun2013"},
      {"span:2:selective-even:texel:stop=0", "yun2013"},
      {"root:1:never:quad", "oh2006:quad"},
      {"dda:quad:stop=3", "dda:stop=3:quad"},
      {"root:common:never:stop=2:quad", "root:common:never:stop=2:quad"},
      {"root:2:never", "yun2013-down"},
      {"leaf:1:never", "dda"},
      {"leaf:3:never:quad", "dda:quad"},
  };
  for (const auto& [text, canonical] : cases) EXPECT_EQ(parse_algorithm(text).id, canonical) << text;
  EXPECT_EQ(parse_algorithm("span:2:selective-even").kind, AlgorithmKind::kPublished);
  EXPECT_EQ(parse_algorithm("root:2:never").kind, AlgorithmKind::kPart);
  EXPECT_EQ(parse_algorithm("oh2006:quad").kind, AlgorithmKind::kComposed);
}

TEST(Schedule, AFaultNamesTheWordWhatIsAcceptedAndTheNearest) {
  const std::pair<std::string_view, std::string_view> cases[] = {
      {"tevs208", "did you mean `tevs2008`?"},
      {"", "accepted are dda"},
      {"rot:1:never", "did you mean `root`?"},
      {"releif:steps=4", "did you mean `relief`?"},
      {"root:4:never", "accepted are 1, 2, 3, common"},
      {"root:comon:never", "did you mean `common`?"},
      {"root:1:sometimes", "accepted are never, always"},
      {"root:1:selectiv-even", "did you mean `selective-even`?"},
      {"root:1", "has no up rule"},
      {"root:1:never:stop", "stop=N"},
      {"root:1:never:stop=", "from 0 to 14"},
      {"root:1:never:stop=15", "from 0 to 14"},
      {"root:1:never:stop=2x", "from 0 to 14"},
      {"root:1:never:stop=-1", "from 0 to 14"},
      {"root:1:never:quat", "did you mean `quad`?"},
      {"root:1:never:quad:texel", "given twice"},
      {"root:1:never:stop=1:stop=1", "given twice"},
      {"yun2013:2", "`2` is not an ending"},
      {"root:1:never:", "`` is not an ending"},
  };
  for (const auto& [text, part] : cases) {
    try {
      parse_algorithm(text);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::kUsage);
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
}

TEST(Schedule, EachPartIsOh2006WithOneThingChanged) {
  const Schedule oh = find_algorithm("oh2006")->schedule;
  EXPECT_EQ(algorithms().size(), 8u);
  EXPECT_EQ(algorithm_parts().size(), 5u);
  for (const Algorithm& part : algorithm_parts()) {
    const Schedule& s = part.schedule;
    EXPECT_EQ((s.start != oh.start) + (s.down != oh.down) + (s.up != oh.up), 1) << part.id;
    EXPECT_EQ(part.kind, AlgorithmKind::kPart);
  }
}

}  // namespace
}  // namespace cuesta
