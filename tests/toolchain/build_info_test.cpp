#include "models/common/build_info.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

namespace cuesta {
namespace {

/// What a shell prints for `command`, without the last newline; the process is gone when this returns.
std::string output_of(const char* command) {
  std::string text;
  FILE* pipe = popen(command, "r");
  if (pipe == nullptr) return text;
  std::array<char, 256> part;
  while (fgets(part.data(), part.size(), pipe) != nullptr) text += part.data();
  pclose(pipe);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

TEST(BuildInfo, CommitIsOneOfThisClone) {
  // Tests start in the project's root. Not compared with HEAD: a commit may follow a build.
  std::string commit(build_info().commit);
  if (output_of("test -e .git && command -v git").empty()) {
    EXPECT_EQ(commit, "unknown");
    return;
  }
  if (commit.ends_with("-dirty")) commit.resize(commit.size() - 6);
  EXPECT_EQ(output_of(("git -c safe.directory=\"$PWD\" cat-file -t '" + commit + "'").c_str()), "commit");
}

TEST(BuildInfo, FlagsKeepEveryRounding) {
  EXPECT_NE(build_info().flags.find("-ffp-contract=off"), std::string_view::npos);
  EXPECT_EQ(build_info().flags.find("fast-math"), std::string_view::npos);
  EXPECT_EQ(build_info().flags.find("-march"), std::string_view::npos);
}

TEST(BuildInfo, LibrariesAreNamedOnceWithAVersion) {
  const auto libraries = build_info().libraries;
  EXPECT_GE(libraries.size(), 6u);
  EXPECT_TRUE(std::is_sorted(libraries.begin(), libraries.end(),
                             [](const auto& a, const auto& b) { return a.name < b.name; }));
  for (const LinkedLibrary& library : libraries) EXPECT_FALSE(library.version.empty()) << library.name;
}

}  // namespace
}  // namespace cuesta
