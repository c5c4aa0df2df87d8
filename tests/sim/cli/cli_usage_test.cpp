#include <algorithm>
#include <sstream>

#include "tests/sim/cli/cli_fixture.h"

// What words the command line takes, and what it says to others.

namespace cuesta {
namespace {

TEST_F(CommandLine, WrongUsageEndsWithTwoAndTheNearestName) {
  const Refusal cases[] = {
      {{}, "No verb is given"},
      {{"-q"}, "No verb is given"},
      {{"-q", "rn"}, "did you mean `run`?"},
      {{"rn"}, "did you mean `run`?"},
      {{"rays"}, "accepted are make, info, convert, check"},
      {{"rays", "inof"}, "did you mean `info`?"},
      {{"verify", "rlt"}, "did you mean `rtl`?"},
      {{"list"}, "is required"},
      {{"list", "paramters"}, "did you mean `parameters`?"},
      {{"run", "default", "--algoritm", "dda"}, "did you mean `--algorithm`?"},
      {{"run", "--algoritm", "dda"}, "did you mean `--algorithm`?"},
      {{"run", "default", "--arch", "tiny", "--arch", "mobile"},
       "`cuesta run`: --arch is given 2 times (tiny, mobile); accepted is one."},
      {{"run", "default", "--size", "8", "--size", "9"}, "--size is given 2 times (8, 9); accepted is one."},
      {{"run", "--", "-x"}, "`-x`"},
      {{"run", "default", "extra"}, "does not know what to do with `extra`"},
      {{"run"}, "No scene is given"},
      {{"run", ""}, "No scene is given"},
      {{"run", "defalt"}, "did you mean `default`?"},
      {{"run", "default", "--algorithm", "tevs208"}, "did you mean `tevs2008`?"},
      {{"run", "default", "--algorithm", "dda,oh2006"}, "`cuesta compare` takes several"},
      {{"compare", "default", "--algorithm", "dda,dda"}, "given twice"},
      {{"compare", "default", "--algorithm", "relief:steps=64,refine=5"}, "relief:steps=64:refine=5"},
      {{"run", "default", "--algorithm", "ki2007-printed,slope"},
       "`slope` stands after a comma, where the next algorithm begins; accepted is ki2007-printed:slope for"},
      {{"compare", "default", "--algorithm", "dda,yun2013,quad"}, "accepted is yun2013:quad for"},
      {{"run", "default", "--algorithm", "ki2007-printed:delta=0,5"},
       "accepted is a decimal point, as in ki2007-printed:delta=0.5."},
      {{"compare", "default", "--algorithm", "ki2007-printed:delta=0,5:slope,dda"},
       "as in ki2007-printed:delta=0.5:slope."},
      {{"compare", "default", "--algorithm", "prnted"}, "did you mean `printed`?"},
      {{"compare", "default", "--algorithm", "all+prnted"}, "did you mean `printed`?"},
      {{"compare", "default", "--algorithm", "all+dda"}, "Single algorithms are joined by commas."},
      {{"compare", "default", "--algorithm", "printed:slope"},
       "accepted are ki2007-printed, drobot2009-printed,"},
      {{"compare", "default", "--algorithm", "dda,tevs208"}, "did you mean `tevs2008`?"},
      {{"compare", "default", "default"}, "Two scenes are named default"},
      {{"compare", "default", "--arch", "tiny,tiny"}, "Two architectures are named tiny"},
      {{"run", "default", "--fidelity", "exact"}, "accepted are functional, transaction, cycle, rtl"},
      {{"run", "default", "--fidelity", "cylce"}, "did you mean `cycle`?"},
      {{"run", "default", "--host", "sysetmc"}, "accepted are direct, systemc"},
      {{"run", "default", "--host", "systemc", "--fidelity", "functional"},
       "accepted with it are --fidelity cycle, rtl"},
      {{"run", "default", "--host", "systemc", "--fidelity", "transaction"},
       "runs ahead of it; accepted with it are --fidelity cycle, rtl"},
      {{"run", "default", "--fidelity", "transaction", "--set", "units.traverse=rtl"},
       "accepted with it is \"model\", or --fidelity cycle"},
      {{"run", "default", "--vcd", "waves.vcd"}, "accepted with --host systemc"},
      {{"run", "default", "--arch", "moblie"}, "did you mean `mobile`?"},
      {{"run", "default", "--set", "height_l1.way=4"}, "did you mean `height_l1.ways`?"},
      {{"run", "default", "--set", "height_l1.ways=4", "--fidelity", "functional"}, "does not use it"},
      {{"run", "default", "--set", "traverse.contexts=2"}, "`traverse.stages` = 8"},
      {{"run", "default", "--size", "0"}, "accepted is one number of pixels"},
      {{"run", "default", "--size", "16x"}, "accepted is one number of pixels"},
      {{"run", "default", "--size", "99999999999999999999"}, "accepted is one number of pixels"},
      {{"run", "default", "--angle", "nan"}, "from 0 to 89.9"},
      {{"run", "default", "--angle", "90"}, "from 0 to 89.9"},
      {{"run", "default", "--depth", "inf"}, "is inf; accepted is a number from"},
      {{"run", "default", "--angle"}, "--angle"},
      {{"run", "default", "--surface", "bilinar"}, "did you mean `bilinear`?"},
      {{"run", "default", "--size", "8", "--surface", "bilinear"}, "accepted with it are float, double"},
      {{"run", "default", "--size", "8", "--surface", "bilinear", "--fidelity", "rtl"},
       "accepted with it are float, double"},
      {{"run", "default", "--size", "8", "--surface", "bilinear", "--set", "traverse.arithmetic=float",
        "--algorithm", "oh2006:stop=1"},
       "accepted with it is stop level 0"},
      {{"run", "default", "--size", "8", "--surface", "bilinear", "--set", "traverse.arithmetic=float",
        "--set", "traverse.fraction_bits=0"},
       "cannot hold the half texel"},
      {{"run", "default", "--crop", "0,0,9"}, "x,y,width,height"},
      {{"run", "default", "--crop", "510,0,9,9"}, "does not lie inside the frame"},
      {{"run", "default", "--angle", "5", "--rays", "x.rays"}, "accepted is one of the two"},
  };
  expect_refusals(cases);
  if (std::filesystem::exists(path("results"))) EXPECT_TRUE(std::filesystem::is_empty(path("results")));
}

TEST_F(CommandLine, TheSurfaceIsJudgedAsItIsAfterTheCommandLine) {
  const auto scene = [](const std::string& mode, const std::string& surface) {
    return "[heightmap]\ngenerate = { kind = \"rocks\", width = 32, height = 32 }\naddress_mode = \"" + mode +
           "\"\n[surface]\n" + surface + "[image]\nwidth = 8\nheight = 8\n";
  };
  write("contradiction.toml", scene("mirror", "kind = \"bilinear\"\n"));
  write("mirror.toml", scene("mirror", ""));
  const auto run = [&](const std::string& file, const Words& more) {
    Words words = {"run", file,  "--fidelity", "functional", "--set", "traverse.arithmetic=float",
                   "-o",  "out", "--force"};
    words.insert(words.end(), more.begin(), more.end());
    return cuesta(words);
  };
  expect_refusal(run("contradiction.toml", {}), 2, "contradiction.toml:5: `surface.kind` is bilinear",
                 "file");
  expect_refusal(cuesta({"trace", "contradiction.toml", "-o", "a.csv"}), 2, "contradiction.toml:5", "trace");
  expect_refusal(run("mirror.toml", {"--surface", "bilinear"}), 2, "--surface is bilinear", "option");
  const ProgramResult saved = run("contradiction.toml", {"--surface", "texel"});
  EXPECT_EQ(saved.code, 0) << saved.err;
}

TEST_F(CommandLine, SeedsAreWholeNumbersOf64BitsInEveryVerb) {
  const Words verbs[] = {{"adversary", "-o", "worst"},
                         {"verify", "oracle"},
                         {"verify", "rtl"},
                         {"heightmap", "make", "rocks", "-o", "map.png"},
                         {"rays", "make", "random", "-o", "rays.csv"}};
  for (const Words& verb : verbs) {
    for (const char* seed :
         {"-1", "-18446744073709551615", "18446744073709551616", "1e3", "0x10", "7 ", "x"}) {
      Words words = verb;
      words.insert(words.end(), {"--seed", seed});
      const std::string found =
          "--seed " + std::string(seed) + " is not accepted; accepted is a whole number ";
      expect_refusal(cuesta(words), 2, found + "from 0 to 18446744073709551615.", verb[0] + " " + seed);
    }
  }
  EXPECT_FALSE(std::filesystem::exists(path("map.png")));
  // the largest is taken as it is
  const ProgramResult last = cuesta(
      {"heightmap", "make", "rocks", "-o", "map.png", "--size", "4", "--seed", "18446744073709551615"});
  EXPECT_EQ(last.code, 0) << last.err;
  EXPECT_NE(last.err.find("seed 18446744073709551615."), std::string::npos) << last.err;
}

TEST_F(CommandLine, EveryVerbHasHelpWithAnExample) {
  const Words verbs[] = {{"run"},
                         {"compare"},
                         {"trace"},
                         {"rays", "make"},
                         {"rays", "info"},
                         {"rays", "convert"},
                         {"rays", "check"},
                         {"heightmap", "make"},
                         {"heightmap", "info"},
                         {"list"},
                         {"verify", "oracle"},
                         {"verify", "laws"},
                         {"verify", "rtl"},
                         {"study"},
                         {"adversary"}};
  for (Words words : verbs) {
    words.push_back("--help");
    const ProgramResult result = cuesta(words);
    EXPECT_EQ(result.code, 0) << words[0];
    EXPECT_NE(result.out.find("Example:\n  cuesta " + words[0]), std::string::npos) << result.out;
  }
  EXPECT_EQ(cuesta({"--help"}).code, 0);
  EXPECT_EQ(cuesta({"--version"}).out.rfind("cuesta ", 0), 0u);
}

TEST_F(CommandLine, TwoDashesEndTheOptionsAndQuietStandsAnywhere) {
  write("small.toml", kSmallScene);
  for (const Words& words : {Words{"trace", "-q", "-o", "a.csv", "--", "small.toml"},
                             Words{"rays", "-q", "info", "a.csv"}, Words{"-q", "rays", "info", "a.csv"}}) {
    const ProgramResult result = cuesta(words);
    EXPECT_EQ(result.code, 0) << words[0] << ": " << result.err;
    EXPECT_EQ(result.err, "") << words[0];
  }
}

TEST_F(CommandLine, TheLastWordsOfAHelpNameVerbsThatThereAre) {
  const struct {
    Words group;
    const char* verb;
  } cases[] = {{{}, "run"}, {{"verify"}, "oracle"}, {{"rays"}, "make"}, {{"heightmap"}, "info"}};
  for (const auto& [group, verb] : cases) {
    Words words = group;
    words.push_back("--help");
    const std::string help = cuesta(words).out;
    const size_t end = help.rfind(" --help` says more");
    ASSERT_NE(end, std::string::npos) << help;
    const size_t begin = help.rfind('`', end - 1);
    std::istringstream named(help.substr(begin + 1, end - begin - 1));
    Words line{std::istream_iterator<std::string>(named), {}};
    ASSERT_FALSE(line.empty()) << help;
    EXPECT_EQ(line[0], "cuesta");
    line.erase(line.begin());
    EXPECT_TRUE(std::equal(group.begin(), group.end(), line.begin(), line.end() - 1)) << help;
    for (std::string& word : line) {
      if (word == "VERB") word = verb;
    }
    line.push_back("--help");
    const ProgramResult more = cuesta(line);
    EXPECT_EQ(more.code, 0) << more.err;
    EXPECT_NE(more.out.find("Example:"), std::string::npos) << help;
  }
}

}  // namespace
}  // namespace cuesta
