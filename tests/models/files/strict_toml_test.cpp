#include "models/files/strict_toml.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace cuesta {
namespace {

enum class Mode { kBorder, kWrap };
constexpr Named<Mode> kModes[] = {{"border", Mode::kBorder}, {"wrap", Mode::kWrap}};
constexpr std::string_view kNames[] = {"shadow", "fog"};

/// The sentence with which `read` over this text is refused, "accepted" if it is not.
std::string refusal(const std::string& text, const std::function<void(const TomlTable&)>& read) {
  try {
    const TomlDocument document = TomlDocument::read_text(text, "f.toml");
    read(document.root());
    document.finish();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::kUsage);
    return error.what();
  }
  return "accepted";
}

TEST(StrictToml, GivesTypedValuesAndDefaults) {
  const TomlDocument document = TomlDocument::read_text(
      "i = 3\nr = 2.5\nw = 2\nb = true\nt = \"x\"\nm = \"wrap\"\nn = [\"fog\"]\nv = [1, 2.5]\n[s]\nk = "
      "1\n[[l]]\nx = "
      "1\n[[l]]\nx = 2\n",
      "f.toml");
  const TomlTable root = document.root();
  EXPECT_EQ(root.integer("i", {0, 3}), 3);
  EXPECT_EQ(root.integer("none", {0, 3}, 2), 2);
  EXPECT_EQ(root.real("r"), 2.5);
  EXPECT_EQ(root.real("w"), 2.0);
  EXPECT_TRUE(root.boolean("b"));
  EXPECT_EQ(root.text("t"), "x");
  EXPECT_EQ(root.text("no_text", "y"), "y");
  EXPECT_EQ(root.choice("m", kModes), Mode::kWrap);
  EXPECT_EQ(root.choice("no_mode", kModes, Mode::kBorder), Mode::kBorder);
  EXPECT_EQ(root.choices("n", kNames), std::vector<std::string>{"fog"});
  EXPECT_EQ(root.reals("v", {0, 3}, 2), (std::vector<double>{1, 2.5}));
  EXPECT_EQ(root.table("s").integer("k", {0, 9}), 1);
  EXPECT_EQ(root.table_or_empty("no_table").integer("k", {0, 9}, 7), 7);
  ASSERT_EQ(root.tables("l").size(), 2u);
  EXPECT_EQ(root.tables("l")[0].integer("x", {0, 9}), 1);
  EXPECT_EQ(root.tables("l")[1].integer("x", {0, 9}), 2);
  EXPECT_EQ(root.tables("l")[1].path(), "l[1]");
  document.finish();
}

TEST(StrictToml, RefusesEveryKeyThatNobodyAskedFor) {
  const auto read = [](const TomlTable& root) {
    root.integer("depth", {0, 9}, 0);
    root.table_or_empty("camera").integer("angle", {0, 90}, 0);
    for (const TomlTable& light : root.tables("light")) light.integer("power", {0, 9}, 0);
  };
  EXPECT_EQ(refusal("depth = 1\n[camera]\nangle = 2\n[[light]]\npower = 3\n", read), "accepted");
  EXPECT_EQ(refusal("dpeth = 1\n", read), "f.toml:1: unknown key `dpeth`; did you mean `depth`?");
  EXPECT_EQ(refusal("\n[camera]\nanlge = 1\n", read),
            "f.toml:3: unknown key `camera.anlge`; did you mean `angle`?");
  EXPECT_EQ(refusal("[[light]]\npower = 1\n[[light]]\npowr = 1\n", read),
            "f.toml:4: unknown key `light[1].powr`; did you mean `power`?");
  EXPECT_EQ(refusal("[other]\n", read),
            "f.toml:1: unknown key `other`; accepted here: depth, camera, light.");
}

TEST(StrictToml, NamesTheMisspeltKeyWhereARequiredOneIsMissing) {
  const auto read = [](const TomlTable& root) { root.text("file"); };
  EXPECT_EQ(refusal("\nfiel = \"x\"\n", read), "f.toml:2: unknown key `fiel`; did you mean `file`?");
  EXPECT_EQ(refusal("other = 1\n", read), "f.toml: `file` is missing; accepted is a text.");
}

TEST(StrictToml, RefusesOtherTypesAndRanges) {
  const auto integer = [](const TomlTable& root) { root.integer("k", {1, 64}); };
  const auto real = [](const TomlTable& root) { root.real("k", {0, 1}); };
  const auto reals = [](const TomlTable& root) { root.reals("k", kAnyReal, 3); };
  const auto mode = [](const TomlTable& root) { root.choice("k", kModes); };
  const auto table = [](const TomlTable& root) { root.table("k"); };
  const auto tables = [](const TomlTable& root) { root.tables("k"); };
  const auto names = [](const TomlTable& root) { root.choices("k", kNames); };
  const auto boolean = [](const TomlTable& root) { root.boolean("k"); };
  EXPECT_EQ(refusal("k = 0\n", integer), "f.toml:1: `k` is 0; accepted is a whole number from 1 to 64.");
  EXPECT_EQ(refusal("k = 4.0\n", integer), "f.toml:1: `k` is 4; accepted is a whole number from 1 to 64.");
  EXPECT_EQ(refusal("k = true\n", integer),
            "f.toml:1: `k` is true; accepted is a whole number from 1 to 64.");
  EXPECT_EQ(refusal("k = 1979-05-27\n", integer),
            "f.toml:1: `k` is a date or time; accepted is a whole number from 1 to 64.");
  EXPECT_EQ(refusal("k = nan\n", real), "f.toml:1: `k` is nan; accepted is a number from 0 to 1.");
  EXPECT_EQ(refusal("k = inf\n", real), "f.toml:1: `k` is inf; accepted is a number from 0 to 1.");
  EXPECT_EQ(refusal("k = \"1\"\n", real),
            "f.toml:1: `k` is the text \"1\"; accepted is a number from 0 to 1.");
  EXPECT_EQ(refusal("k = [1, 2]\n", reals),
            "f.toml:1: `k` is an array of 2; accepted is an array of 3 numbers.");
  EXPECT_EQ(refusal("k = [1, 2, inf]\n", reals), "f.toml:1: `k[2]` is inf; accepted is a finite number.");
  EXPECT_EQ(refusal("k = \"wrp\"\n", mode),
            "f.toml:1: `k` is the text \"wrp\"; accepted is one of border, wrap; did you mean `wrap`?");
  EXPECT_EQ(refusal("k = 1\n", table), "f.toml:1: `k` is 1; accepted is a table [k].");
  EXPECT_EQ(refusal("k = [1]\n", tables), "f.toml:1: `k[0]` is 1; accepted is tables [[k]].");
  EXPECT_EQ(refusal("k = [\"fog\", \"fog\"]\n", names), "f.toml:1: `k[1]` names \"fog\" a second time.");
  EXPECT_EQ(refusal("k = 1\n", boolean), "f.toml:1: `k` is 1; accepted is true or false.");
}

TEST(StrictToml, RefusesWhatIsNotTomlWithItsLine) {
  const auto nothing = [](const TomlTable&) {};
  for (const char* text :
       {"a = 1\nb\n", "a = 1\nb =\n", "a = 1\na = 2\n", "a = 1\n[\n", "a = 1\n[.]\n", "a = 1\n[\xc3\xa9]\n",
        "a = 1\nb = \"\n", "a = 1\nb = \"\xff\"\n", "a = 1\nb = 1__0\n"}) {
    const std::string sentence = refusal(text, nothing);
    EXPECT_EQ(sentence.find("f.toml:2: this is not TOML: "), 0u) << sentence;
  }
}

TEST(StrictToml, SettingReplacesOrAddsAndNamesItsOrigin) {
  const auto document = [] { return TomlDocument::read_text("[camera]\nangle = 2\n", "f.toml"); };
  const auto read = [](const TomlDocument& from) {
    const TomlTable camera = from.root().table("camera");
    const std::string found = std::to_string(camera.integer("angle", {0, 90})) + camera.text("name", "none");
    from.finish();
    return found;
  };
  TomlDocument changed = document();
  changed.set("camera.angle", "3", "--set");
  changed.set("camera.name", "bare text", "--set");
  EXPECT_EQ(read(changed), "3bare text");
  for (const auto& [path, value, sentence] :
       {std::tuple("camera.angle", "91",
                   "--set: `camera.angle` is 91; accepted is a whole number from 0 to 90."),
        std::tuple("camera.anlge", "9", "--set: unknown key `camera.anlge`; did you mean `angle`?"),
        std::tuple("camera.angle.x", "9",
                   "f.toml:2: `camera.angle` is 2; accepted is a table, to hold "
                   "`camera.angle.x`."),
        std::tuple("camera..x", "9",
                   "--set: `camera..x` is not a key; accepted are names joined by dots.")}) {
    TomlDocument faulty = document();
    try {
      faulty.set(path, value, "--set");
      read(faulty);
      ADD_FAILURE() << path << " was accepted";
    } catch (const Error& error) {
      EXPECT_STREQ(error.what(), sentence);
    }
  }
}

}  // namespace
}  // namespace cuesta
