#include "reports/table.h"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/support/example_result.h"

namespace cuesta {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(Table, HasARowForEachRunAndOneRuleAsWideAsAll) {
  const Result result = tests::example_result();
  const std::vector<std::string> lines = lines_of(print_table(result));
  ASSERT_GE(lines.size(), 7u);
  const std::string& rule = lines[3];
  EXPECT_EQ(rule.find_first_not_of("- "), std::string::npos);
  for (size_t k = 0; k < result.runs.size(); ++k) {
    EXPECT_TRUE(lines[4 + k].starts_with(result.runs[k].algorithm)) << lines[4 + k];
    EXPECT_LE(lines[4 + k].size(), rule.size());
  }
  for (const std::string& line : lines) {
    for (char c : line) EXPECT_TRUE(c >= 32 && c < 127) << line;
  }
}

TEST(Table, LeavesOutTimeWhereNoneWasCounted) {
  tests::ExampleShape shape;
  shape.timed = false;
  const std::string table = print_table(tests::example_result(shape));
  EXPECT_NE(table.find("steps"), std::string::npos);
  EXPECT_EQ(table.find("cycles"), std::string::npos);
  EXPECT_EQ(table.find("DRAM"), std::string::npos);
}

TEST(Table, SaysWhenNothingRan) { EXPECT_EQ(print_table({}), "Nothing ran.\n"); }

}  // namespace
}  // namespace cuesta
