#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace cuesta {

/// The built program, started in a fresh folder.
class CommandLine : public ::testing::Test {
 protected:
  using Words = std::vector<std::string>;

  ProgramResult cuesta(const Words& words, const Interrupt* interrupt = nullptr) const {
    return run_program(CUESTA_PROGRAM, words, folder_.path(""), interrupt);
  }

  std::string path(const std::string& name) const { return folder_.path(name); }

  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
  }

  std::string read(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }

  /// Every file below a folder, with its bytes.
  std::map<std::string, std::string> tree(const std::string& name) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path(name))) {
      if (!entry.is_regular_file()) continue;
      std::ifstream file(entry.path(), std::ios::binary);
      files[entry.path().string()] = std::string(std::istreambuf_iterator<char>(file), {});
    }
    return files;
  }

  /// Exit code, one sentence on stderr from the program itself, nothing on stdout.
  static void expect_refusal(const ProgramResult& result, int code, const std::string& part,
                             const std::string& what) {
    EXPECT_EQ(result.code, code) << what << "\n" << result.err;
    EXPECT_EQ(result.err.rfind("cuesta: ", 0), 0u) << what << "\n" << result.err;
    EXPECT_NE(result.err.find(part), std::string::npos) << what << "\n" << result.err;
    EXPECT_EQ(result.out, "") << what;
  }

  /// Words that are refused with exit code 2, and a part of the sentence that says why.
  struct Refusal {
    Words words;
    const char* part;
  };
  /// Each of `cases`, behind the words `before`.
  void expect_refusals(std::span<const Refusal> cases, const Words& before = {}) const {
    for (const auto& [words, part] : cases) {
      Words all = before;
      all.insert(all.end(), words.begin(), words.end());
      std::string line = "cuesta";
      for (const std::string& word : all) line += " " + word;
      expect_refusal(cuesta(all), 2, part, line);
    }
  }

  TemporaryFolder folder_;
};

/// A small scene over generated heights, and over an image.
inline const std::string kSmallScene =
    "[heightmap]\ngenerate = { kind = \"rocks\", width = 32, height = 32 }\n[surface]\ndepth = 0.1\n"
    "[camera]\nangle_degrees = 60\n[image]\nwidth = 16\nheight = 16\n";
inline const std::string kImageScene = "[heightmap]\nfile = \"map.png\"\n[image]\nwidth = 16\nheight = 16\n";

}  // namespace cuesta
