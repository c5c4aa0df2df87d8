#include "reports/result_csv.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "tests/support/example_result.h"

namespace cuesta {
namespace {

TEST(ResultCsv, HasARowForEveryCounterOfEveryRun) {
  const Result result = tests::example_result();
  const std::string csv = result_csv(result);
  size_t counters = 0;
  for (const RunEntry& run : result.runs) counters += run.measurements.counters.all().size();
  size_t rows = 0;
  std::istringstream stream(csv);
  for (std::string line; std::getline(stream, line);) rows += line.find(",counter,") != std::string::npos;
  EXPECT_EQ(rows, counters);
  EXPECT_NE(csv.find("rocks-front,dda,mobile,cycle,counter,machine.rays,384,rays\n"), std::string::npos);
}

TEST(ResultCsv, QuotesWhatWouldSplitACell) {
  Result result = tests::example_result();
  result.runs.resize(1);
  result.runs[0].scene = "a \"b\", c";
  EXPECT_NE(result_csv(result).find("\n\"a \"\"b\"\", c\",dda,"), std::string::npos);
}

TEST(ResultCsv, EveryRowOfTheSummaryHasAsManyCellsAsItsHead) {
  tests::ExampleShape shape;
  Result result = tests::example_result(shape);
  shape.timed = false;
  const Result functional = tests::example_result(shape);
  result.runs.insert(result.runs.end(), functional.runs.begin(), functional.runs.end());
  std::istringstream stream(summary_csv(result));
  std::string head;
  std::getline(stream, head);
  const auto cells = std::count(head.begin(), head.end(), ',');
  size_t rows = 0;
  for (std::string line; std::getline(stream, line); ++rows) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), cells) << line;
  }
  EXPECT_EQ(rows, result.runs.size());
}

}  // namespace
}  // namespace cuesta
