#include "reports/result_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>

#include "models/common/error.h"

namespace cuesta {
namespace {

namespace fs = std::filesystem;

class ResultFolderTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "cuesta-folder-XXXXXX").string();
    root_ = mkdtemp(name.data());
  }
  void TearDown() override { fs::remove_all(root_); }

  static std::string text_of(const fs::path& path) {
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  size_t entries() const { return static_cast<size_t>(std::distance(fs::directory_iterator(root_), {})); }

  void write_result(const std::string& name, const std::string& text, bool overwrite) {
    ResultFolder folder = ResultFolder::create(root_ / name, overwrite);
    folder.write("result.json", text);
    folder.write("manifest.json", "{}");
    folder.commit();
  }

  static ExitCode code_of(const std::function<void()>& act) {
    try {
      act();
    } catch (const Error& error) {
      return error.code();
    }
    return ExitCode::kOk;
  }

  fs::path root_;
};

TEST_F(ResultFolderTest, AppearsUnderItsNameOnlyWhenWhole) {
  ResultFolder folder = ResultFolder::create(root_ / "a/b/out", false);
  folder.write("planes/x.txt", "one");
  EXPECT_FALSE(fs::exists(root_ / "a/b/out"));
  folder.commit();
  EXPECT_EQ(text_of(root_ / "a/b/out/planes/x.txt"), "one");
  EXPECT_EQ(std::distance(fs::directory_iterator(root_ / "a/b"), {}), 1);
}

TEST_F(ResultFolderTest, LeavesNothingBehindWithoutCommit) {
  { ResultFolder::create(root_ / "out", false).write("result.json", "half"); }
  EXPECT_EQ(entries(), 0u);
}

TEST_F(ResultFolderTest, RefusesAnOldResultUnlessAsked) {
  write_result("out", "old", false);
  EXPECT_EQ(code_of([&] { ResultFolder::create(root_ / "out", false); }), ExitCode::kUsage);
  EXPECT_EQ(code_of([&] { ResultFolder::create(root_ / "out/", false); }), ExitCode::kUsage);
  EXPECT_EQ(text_of(root_ / "out/result.json"), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(ResultFolderTest, ReplacesAnOldResultWholeWhenAsked) {
  write_result("out", "old", false);
  fs::create_directory(root_ / "out/planes");
  std::ofstream(root_ / "out/planes/left-over.exr") << "x";
  write_result("out", "new", true);
  EXPECT_EQ(text_of(root_ / "out/result.json"), "new");
  EXPECT_FALSE(fs::exists(root_ / "out/planes"));
  EXPECT_EQ(entries(), 1u);
}

TEST_F(ResultFolderTest, KeepsTheOldResultWhenTheNewOneIsGivenUp) {
  write_result("out", "old", false);
  { ResultFolder::create(root_ / "out", true).write("result.json", "half"); }
  EXPECT_EQ(text_of(root_ / "out/result.json"), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(ResultFolderTest, NeverReplacesWhatIsNotAResult) {
  fs::create_directory(root_ / "photos");
  std::ofstream(root_ / "photos/cat.png") << "x";
  std::ofstream(root_ / "file") << "y";
  fs::create_directory_symlink(root_ / "photos", root_ / "link");
  for (const char* name : {"photos", "file", "link"}) {
    EXPECT_EQ(code_of([&] { ResultFolder::create(root_ / name, true); }), ExitCode::kUsage) << name;
  }
  EXPECT_EQ(text_of(root_ / "photos/cat.png"), "x");
  EXPECT_EQ(text_of(root_ / "file"), "y");
}

TEST_F(ResultFolderTest, GoesBesideANameThatWasTakenMeanwhile) {
  ResultFolder folder = ResultFolder::create(root_ / "out", false);
  folder.write("result.json", "late");
  write_result("out", "early", false);
  folder.commit();
  EXPECT_EQ(text_of(root_ / "out/result.json"), "early");
  EXPECT_EQ(folder.final_path(), root_ / "out-2");
  EXPECT_EQ(text_of(root_ / "out-2/result.json"), "late");
}

TEST_F(ResultFolderTest, APartialResultDoesNotReplaceAnOldOne) {
  write_result("out", "whole", false);
  ResultFolder folder = ResultFolder::create(root_ / "out", true);
  folder.write("result.json", "partial");
  folder.commit(false);
  EXPECT_EQ(text_of(root_ / "out/result.json"), "whole");
  EXPECT_EQ(text_of(root_ / "out-2/result.json"), "partial");
}

TEST_F(ResultFolderTest, NeverReplacesAResultThatSomebodyAddedTo) {
  write_result("out", "old", false);
  std::ofstream(root_ / "out/thesis.txt") << "mine";
  EXPECT_EQ(code_of([&] { ResultFolder::create(root_ / "out", true); }), ExitCode::kUsage);
  EXPECT_EQ(text_of(root_ / "out/thesis.txt"), "mine");
}

TEST_F(ResultFolderTest, AStudyWithTimesAndPicturesIsReplacedAndOneWithMoreIsNot) {
  const auto study = [&](bool overwrite) {
    ResultFolder folder = ResultFolder::create(root_ / "study", overwrite);
    for (const char* name : {"data.json", "manifest.json", "README.md", "times.json", "pictures/one.png"})
      folder.write(name, "x");
    folder.commit();
  };
  study(false);
  study(true);
  std::ofstream(root_ / "study/mine.png") << "x";
  EXPECT_THROW(study(true), Error);
}

TEST_F(ResultFolderTest, RefusesNamesThatNoFolderCanHave) {
  EXPECT_EQ(code_of([&] { ResultFolder::create("", false); }), ExitCode::kUsage);
  EXPECT_EQ(code_of([&] { ResultFolder::create("/", true); }), ExitCode::kUsage);
  std::ofstream(root_ / "file") << "y";
  EXPECT_EQ(code_of([&] { ResultFolder::create(root_ / "file/out", false); }), ExitCode::kResource);
}

}  // namespace
}  // namespace cuesta
