#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "models/common/error.h"
#include "models/common/words.h"
#include "models/units/statistics.h"
#include "sim/config/architecture_file.h"
#include "sim/config/parameters.h"
#include "tests/support/temporary_folder.h"

namespace cuesta {
namespace {

using Settings = std::vector<std::string>;

ResolvedArchitecture resolve(const std::string& name, const Settings& settings = {}, bool with_time = true) {
  return resolve_architecture(name, settings, with_time);
}

/// The sentence that a refusal ends with; "accepted" when nothing was refused.
std::string refusal(const std::string& name, const Settings& settings = {}, bool with_time = true) {
  try {
    resolve(name, settings, with_time);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::kUsage);
    return error.what();
  }
  return "accepted";
}

std::vector<int64_t> values(const Architecture& architecture) {
  std::vector<int64_t> all;
  for (const Parameter& parameter : parameters()) all.push_back(parameter.get(architecture));
  return all;
}

class ArchitectureFile : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    const std::string path = folder_.path(name);
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  std::string refusal_of(const std::string& text) const { return refusal(write("a.toml", text)); }
  TemporaryFolder folder_;
};

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(Parameters, EachIsBoundToAFieldOfItsOwn) {
  for (const Parameter& parameter : parameters()) {
    Architecture architecture;
    const std::vector<int64_t> before = values(architecture);
    const int64_t other = parameter.get(architecture) == parameter.low ? parameter.high : parameter.low;
    parameter.set(architecture, other);
    const std::vector<int64_t> after = values(architecture);
    int changed = 0;
    for (size_t k = 0; k < before.size(); ++k) changed += before[k] != after[k];
    EXPECT_EQ(changed, 1) << parameter.path;
    EXPECT_EQ(parameter.get(architecture), other) << parameter.path;
  }
}

TEST(Parameters, AreDistinctAndTheirDefaultsAreAccepted) {
  const Architecture standard;
  for (const Parameter& parameter : parameters()) {
    EXPECT_EQ(find_parameter(parameter.path), &parameter);
    EXPECT_GE(parameter.get(standard), parameter.low) << parameter.path;
    EXPECT_LE(parameter.get(standard), parameter.high) << parameter.path;
    EXPECT_TRUE(parameter.meaning.ends_with(".")) << parameter.path;
    EXPECT_FALSE(parameter.source.empty()) << parameter.path;
  }
  EXPECT_TRUE(contradictions(standard).empty());
}

/// Stands for a value of any field.
struct Any {
  template <class T>
  operator T() const;
};

/// The fields of a parameter struct: the table beside it has a row for each.
template <class Section>
consteval size_t fields() {
  constexpr auto count = []<size_t... k>(auto self, std::index_sequence<k...>)->size_t {
    if constexpr (requires { Section{((void)k, Any{})..., Any{}}; }) {
      return self(self, std::make_index_sequence<sizeof...(k) + 1>());
    } else {
      return sizeof...(k);
    }
  };
  return count(count, std::index_sequence<>());
}

TEST(Parameters, CoverEveryFieldOfTheMachine) {
  EXPECT_EQ(std::size(parameter::kMachineParameters), fields<MachineParameters>());
  EXPECT_EQ(std::size(parameter::kRayDispatchParameters), fields<RayDispatchParameters>());
  EXPECT_EQ(std::size(parameter::kRaySetupParameters), fields<RaySetupParameters>());
  EXPECT_EQ(std::size(parameter::kTraverseParameters), fields<TraverseParameters>());
  EXPECT_EQ(std::size(parameter::kHeightL1Parameters), fields<HeightL1Parameters>());
  EXPECT_EQ(std::size(parameter::kHitQueueParameters), fields<HitQueueParameters>());
  EXPECT_EQ(std::size(parameter::kResultWriterParameters), fields<ResultWriterParameters>());
  EXPECT_EQ(std::size(parameter::kDramParameters), fields<DramParameters>());
  EXPECT_EQ(std::size(parameter::kTexelParameters), fields<TexelParameters>());
  EXPECT_EQ(std::size(parameter::kUnitParameters), fields<UnitParameters>());
  EXPECT_EQ(parameter_sections().size(), fields<Architecture>() - 1);  // all but the name
}

TEST(Statistics, AreDistinctSentences) {
  const auto all = statistic_definitions();
  for (size_t k = 0; k < all.size(); ++k) {
    EXPECT_TRUE(all[k].sentence.ends_with(".")) << all[k].name;
    EXPECT_FALSE(all[k].unit.empty()) << all[k].name;
    if (k > 0) EXPECT_LT(all[k - 1].name, all[k].name);
  }
}

TEST(Presets, GiveEveryParameterThemselves) {
  for (const Preset& preset : presets()) {
    const ResolvedArchitecture resolved = resolve(std::string(preset.name));
    EXPECT_EQ(resolved.architecture.name, preset.name);
    for (size_t k = 0; k < parameters().size(); ++k) {
      EXPECT_EQ(resolved.origins[k], "preset " + std::string(preset.name)) << parameters()[k].path;
    }
  }
}

TEST(Presets, MobileIsTheDefaultOfEveryParameter) {
  EXPECT_EQ(values(resolve("mobile").architecture), values(Architecture{}));
}

TEST(Presets, DesktopHasEightPipelinesOverFourChannels) {
  const Architecture desktop = resolve("desktop").architecture;
  EXPECT_EQ(desktop.machine.pipelines, 8);
  EXPECT_EQ(desktop.dram.channels, 4);
  EXPECT_EQ(desktop.ray_dispatch.assign, DispatchAssign::kFirstFree);
  EXPECT_EQ(desktop.texels.layout, TexelLayoutKind::kMorton);
}

TEST(Presets, UnknownNameIsRefusedWithTheNearest) {
  EXPECT_SAYS(refusal("moblie"), "did you mean `mobile`?");
  EXPECT_SAYS(refusal("moblie"), "desktop, mobile, tiny");
}

TEST(SettingsByHand, ComeLastAndKeepTheRest) {
  std::vector<int64_t> expected = values(resolve("tiny").architecture);
  const ResolvedArchitecture resolved = resolve("tiny", {"height_l1.ways=4", "ray_dispatch.order=hilbert"});
  EXPECT_EQ(resolved.architecture.height_l1.ways, 4);
  EXPECT_EQ(resolved.architecture.ray_dispatch.order, DispatchOrder::kHilbert);
  const std::vector<int64_t> found = values(resolved.architecture);
  for (size_t k = 0; k < expected.size(); ++k) {
    const bool set = resolved.origins[k] == "--set";
    EXPECT_EQ(set, parameters()[k].path == "height_l1.ways" || parameters()[k].path == "ray_dispatch.order");
    if (!set) EXPECT_EQ(found[k], expected[k]) << parameters()[k].path;
  }
}

TEST(SettingsByHand, FaultsAreRefusedWithWhatIsAccepted) {
  EXPECT_SAYS(refusal("tiny", {"height_l1.way=4"}), "did you mean `height_l1.ways`?");
  EXPECT_SAYS(refusal("tiny", {"ways=4"}), "did you mean `height_l1.ways`?");
  EXPECT_SAYS(refusal("tiny", {"height_l1.ways=many"}), "a whole number from 1 to 64");
  EXPECT_SAYS(refusal("tiny", {"height_l1.ways=4.0"}), "a whole number from 1 to 64");
  EXPECT_SAYS(refusal("tiny", {"height_l1.ways=nan"}), "a whole number from 1 to 64");
  EXPECT_SAYS(refusal("tiny", {"height_l1.ways=99999999999999999999"}), "a whole number from 1 to 64");
  EXPECT_SAYS(refusal("tiny", {"height_l1.ways=65"}), "a whole number from 1 to 64");
  EXPECT_SAYS(refusal("tiny", {"height_l1.line_bytes=48"}), "a power of two from 16 to 1024");
  EXPECT_SAYS(refusal("tiny", {"ray_dispatch.order=hilbrt"}), "did you mean `hilbert`?");
  EXPECT_SAYS(refusal("tiny", {"height_l1.ways"}), "key=value");
  EXPECT_SAYS(refusal("tiny", {"height_l1.ways="}), "key=value");
  EXPECT_SAYS(refusal("tiny", {"=4"}), "key=value");
  EXPECT_SAYS(refusal("tiny", {"height_l1.ways=1", "height_l1.ways=2"}), "twice");
  EXPECT_SAYS(refusal("tiny", {"height_l1.ways=2\nheight_l1.mshrs=7"}), "a whole number from 1 to 64");
}

TEST(SettingsByHand, AreRefusedWhereTheRunDoesNotUseThem) {
  EXPECT_SAYS(refusal("tiny", {"height_l1.ways=4"}, false), "functional fidelity has no time");
  EXPECT_EQ(refusal("tiny", {"traverse.fraction_bits=6"}, false), "accepted");
  EXPECT_SAYS(refusal("tiny", {"ray_dispatch.tile_size=8"}), "does not use it");
  EXPECT_EQ(refusal("tiny", {"ray_dispatch.tile_size=8", "ray_dispatch.order=tile"}), "accepted");
}

TEST(Contradictions, AreNamedWithBothKeys) {
  const struct {
    const char* setting;
    const char* other;
  } cases[] = {
      {"traverse.contexts=4", "traverse.stages"},
      {"height_l1.ways=3", "height_l1.size_bytes"},
      {"height_l1.size_bytes=32", "height_l1.ways"},
      {"dram.bus_bytes=64", "height_l1.line_bytes"},
      {"dram.tRAS=1", "dram.tRCD"},
      {"traverse.mantissa_bits=1", "traverse.mantissa_bits"},
      {"result_writer.burst_bytes=1024", "accepted"},  // a row of 1024 bytes holds it
  };
  for (const auto& [setting, other] : cases) EXPECT_SAYS(refusal("tiny", {setting}), other);
  EXPECT_SAYS(refusal("tiny", {"dram.row_bytes=256", "result_writer.burst_bytes=512"}), "dram.row_bytes");
}

TEST_F(ArchitectureFile, StartsFromItsBase) {
  const std::string path = write("fast.toml", "base = \"desktop\"\n[machine]\nclock_mhz = 1500\n");
  const ResolvedArchitecture resolved = resolve(path);
  EXPECT_EQ(resolved.architecture.name, "fast");
  EXPECT_EQ(resolved.architecture.machine.clock_mhz, 1500);
  EXPECT_EQ(resolved.architecture.machine.pipelines, 8);
  EXPECT_EQ(resolved.files, std::vector<std::string>{path});
  write("faster.toml", "base = \"fast.toml\"\n[machine]\npipelines = 16\n");
  const ResolvedArchitecture again = resolve(folder_.path("faster.toml"));
  EXPECT_EQ(again.architecture.machine.clock_mhz, 1500);
  EXPECT_EQ(again.architecture.machine.pipelines, 16);
  EXPECT_EQ(again.files.size(), 2u);
}

TEST_F(ArchitectureFile, ACircleOfBasesIsRefused) {
  EXPECT_SAYS(refusal(write("loop.toml", "base = \"./loop.toml\"\n")), "no circles");
}

TEST_F(ArchitectureFile, FaultsAreRefusedWithLineAndKey) {
  EXPECT_SAYS(refusal_of("[height_l1]\nway = 4\n"),
              "a.toml:2: unknown key `height_l1.way`; did you mean `ways`?");
  EXPECT_SAYS(refusal_of("\n[heigth_l1]\nways = 4\n"),
              "a.toml:2: unknown key `heigth_l1`; did you mean `height_l1`?");
  EXPECT_SAYS(refusal_of("[height_l1]\nways = \"4\"\n"),
              "a.toml:2: `height_l1.ways` is the text \"4\"; accepted is");
  EXPECT_SAYS(refusal_of("[height_l1]\nways = 1e400\n"), "a.toml:2: ");
  EXPECT_SAYS(refusal_of("[height_l1]\nways = nan\n"), "is nan; accepted is a whole number from 1 to 64");
  EXPECT_SAYS(refusal_of("[height_l1]\nways = -1\n"), "is -1; accepted is a whole number from 1 to 64");
  EXPECT_SAYS(refusal_of("height_l1 = 4\n"), "a.toml:1: `height_l1` is 4; accepted is a table");
  EXPECT_SAYS(refusal_of("[height_l1]\nways = 4\nways = 4\n"), "a.toml:3: this is not TOML");
  EXPECT_SAYS(refusal_of("[height_l1\n"), "a.toml:1: this is not TOML");
  EXPECT_SAYS(refusal_of("base = \"mobil\"\n"), "did you mean `mobile`?");
  EXPECT_SAYS(refusal_of("base = 3\n"), "`base` is 3; accepted is a text");
  EXPECT_SAYS(refusal_of(""), "the file is empty");
  EXPECT_SAYS(refusal_of("# nothing\n"), "holds no keys");
  EXPECT_SAYS(refusal_of(std::string("\0\xff\xfe", 3)), "this is not TOML");
  EXPECT_SAYS(refusal_of(std::string(300'000, '#')), "larger than");
  EXPECT_SAYS(refusal(folder_.path("none.toml")), "there is no such file");
  EXPECT_SAYS(refusal(folder_.path("")), "this is a folder");
}

TEST_F(ArchitectureFile, DeepNestingIsRefusedAndDoesNotExhaustTheStack) {
  std::string dots = "a", brackets = "a = ";
  for (int k = 0; k < 100'000; ++k) dots += ".a";
  EXPECT_SAYS(refusal_of(dots + " = 1\n"), "dots");
  EXPECT_SAYS(refusal_of(brackets + std::string(100'000, '[') + "\n"), "not TOML");
}

TEST_F(ArchitectureFile, AFlippedByteIsRefusedOrGivesAnAcceptedMachine) {
  const std::string text(presets()[0].toml);
  for (size_t k = 0; k < text.size(); k += 3) {
    std::string damaged = text;
    damaged[k] = static_cast<char>(damaged[k] ^ (1 << (k % 8)));
    const std::string sentence = refusal_of(damaged);
    EXPECT_TRUE(sentence == "accepted" || sentence.find("a.toml:") != std::string::npos ||
                sentence.find("Architecture a: ") == 0)
        << sentence;
  }
}

TEST_F(ArchitectureFile, UnusedSectionsAreListed) {
  const std::string path =
      write("a.toml", "[height_l1]\nways = 8\n[traverse]\nstages = 4\nfraction_bits = 6\n");
  EXPECT_EQ(resolve(path, {}, false).unused, (std::vector<std::string>{"traverse.stages", "[height_l1]"}));
  EXPECT_TRUE(resolve(path, {}, true).unused.empty());
  EXPECT_TRUE(resolve("mobile", {}, false).unused.empty());
}

TEST_F(ArchitectureFile, ResolvedTextReadsBackAsTheSameMachine) {
  for (const Preset& preset : presets()) {
    for (bool with_time : {false, true}) {
      const ResolvedArchitecture resolved =
          resolve(std::string(preset.name), {"traverse.tile_bits=7"}, with_time);
      const std::string path = write("config.resolved.toml", resolved.toml(with_time));
      EXPECT_EQ(values(resolve(path).architecture), values(resolved.architecture)) << preset.name;
    }
  }
}

TEST(ScheduleParameters, LeaveTheScheduleToTheAlgorithmUnlessSet) {
  const TraverseParameters mobile = resolve("mobile").architecture.traverse;
  EXPECT_FALSE(mobile.start || mobile.down || mobile.up || mobile.stop_level || mobile.fetch);
  const TraverseParameters set =
      resolve("mobile",
              {"traverse.start=\"span\"", "traverse.down=2", "traverse.up=\"both-even\"",
               "traverse.stop_level=3", "traverse.fetch=\"quad\""},
              false)
          .architecture.traverse;
  EXPECT_EQ(set.start, StartRule::kSpan);
  EXPECT_EQ(set.down, 2);
  EXPECT_EQ(set.up, UpRule::kBothEven);
  EXPECT_EQ(set.stop_level, 3);
  EXPECT_EQ(set.fetch, FetchRule::kQuad);
  EXPECT_EQ(resolve("mobile", {"traverse.down=\"common\""}).architecture.traverse.down, kDownCommon);
  EXPECT_EQ(resolve("mobile", {"traverse.down=\"3\""}).architecture.traverse.down, 3);
  EXPECT_SAYS(refusal("mobile", {"traverse.down=4"}), "accepted is one of algorithm, 1, 2, 3, common");
  EXPECT_SAYS(refusal("mobile", {"traverse.stop_level=15"}), "accepted is one of algorithm, 0, 1");
  EXPECT_SAYS(refusal("mobile", {"traverse.up=\"selectiv\""}), "did you mean `selective`?");
}

TEST(Words, EditDistanceCountsInsertDeleteChangeAndSwap) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("ways", ""), 4u);
  EXPECT_EQ(edit_distance("ways", "way"), 1u);
  EXPECT_EQ(edit_distance("ways", "wyas"), 1u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
}

}  // namespace
}  // namespace cuesta
