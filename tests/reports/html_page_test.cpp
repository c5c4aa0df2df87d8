#include "reports/html/html_page.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "models/common/error.h"
#include "reports/html/html_text.h"
#include "tests/support/example_result.h"

namespace cuesta {
namespace {

std::set<std::string> all_matches(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  std::set<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) found.insert((*it)[1]);
  return found;
}

/// Without pictures: std::regex is slow on them.
Result without_planes(Result result) {
  for (RunEntry& run : result.runs) run.measurements.planes.clear();
  return result;
}

TEST(HtmlPage, AsksTheNetworkForNothing) {
  const std::string page = html_page(tests::example_result());
  EXPECT_EQ(page.find("http:"), std::string::npos);
  EXPECT_EQ(page.find("https:"), std::string::npos);
  EXPECT_EQ(page.find("@import"), std::string::npos);
  EXPECT_EQ(page.find("url("), std::string::npos);
  EXPECT_EQ(page.find("<script src"), std::string::npos);
}

TEST(HtmlPage, DefinesEveryStatisticThatItShows) {
  const std::string page = html_page(without_planes(tests::example_result()));
  const std::set<std::string> links = all_matches(page, "href=\"#(def-[a-z0-9_-]+)\"");
  const std::set<std::string> definitions = all_matches(page, "id=\"(def-[a-z0-9_-]+)\"");
  EXPECT_GT(links.size(), 20u);
  for (const std::string& link : links) EXPECT_TRUE(definitions.contains(link)) << link;
}

TEST(HtmlPage, StartsWithTheSentenceToTakeAway) {
  const std::string page = html_page(without_planes(tests::example_result()));
  EXPECT_LT(page.find("needed the fewest cycles on rocks-front"), page.find("<h1>"));
}

TEST(HtmlPage, LeavesOutWhatWasNotCounted) {
  tests::ExampleShape shape;
  shape.timed = false;
  const std::string page = html_page(tests::example_result(shape));
  EXPECT_EQ(page.find("Where the cycles went"), std::string::npos);
  EXPECT_EQ(page.find("Memory traffic"), std::string::npos);
  EXPECT_NE(page.find("Steps per ray"), std::string::npos);
  EXPECT_NE(page.find("Per pixel"), std::string::npos);
}

TEST(HtmlPage, NamesFromFilesCannotBecomeMarkup) {
  Result result = tests::example_result();
  for (RunEntry& run : result.runs) run.scene = "</script><script>alert(1)</script>\"'&";
  result.inputs[0].path = "<img src=x onerror=alert(1)>";
  const std::string page = html_page(result);
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
  EXPECT_EQ(page.find("<img src=x"), std::string::npos);
}

TEST(HtmlPage, SaysKOfNForAPartialRun) {
  Result result = without_planes(tests::example_result());
  result.runs[1].finished_rays = 77;
  EXPECT_NE(html_page(result).find("partial: 77 of 384 rays"), std::string::npos);
}

TEST(HtmlPage, IsTheSameForTheSameResult) {
  EXPECT_EQ(html_page(tests::example_result()), html_page(tests::example_result()));
}

TEST(HtmlPage, RefusesAResultWithoutRuns) { EXPECT_THROW(html_page({}), Error); }

TEST(HtmlText, Base64MatchesRfc4648) {
  EXPECT_EQ(html::base64(""), "");
  EXPECT_EQ(html::base64("f"), "Zg==");
  EXPECT_EQ(html::base64("fo"), "Zm8=");
  EXPECT_EQ(html::base64("foo"), "Zm9v");
  EXPECT_EQ(html::base64("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace cuesta
