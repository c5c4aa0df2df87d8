#include <gtest/gtest.h>

#include "reports/html/svg_line_plot.h"
#include "reports/study/study_parts.h"
#include "sim/explore/iterations/iterations.h"
#include "tests/reports/study/example_study.h"

namespace cuesta {
namespace {

using namespace html;

TEST(StudyPage, StartsWithTheSentenceAndItsNumbersComeFromTheData) {
  // Front: 450/900 and 320/800; the lower median of two is the smaller ratio, .4. Grazing: 1200/1500 and
  // 1000/2000.
  const StudyData data = tests::example_iterations();
  const std::string headline = iterations_headline(data);
  EXPECT_NE(
      headline.find("yun2013 takes 60 % fewer steps than oh2006 in front views (to 30°) and 50 % fewer"),
      std::string::npos)
      << headline;
  EXPECT_NE(headline.find("up to 60 % fewer on spikes 256, depth 0.05, 10°"), std::string::npos) << headline;
  // Fewest: dda in both front views, yun2013 in both grazing ones.
  EXPECT_NE(headline.find("published schedules: dda alone in 50 % of the views, yun2013 in 50 %."),
            std::string::npos)
      << headline;
  const std::string page = iterations_page(data);
  EXPECT_LT(page.find("yun2013 takes 60"), page.find("<h1>"));
}

TEST(StudyPage, AViewThatSeveralShareIsNobodysAlone) {
  StudyData data = tests::example_iterations();
  // The first front view: dda 300, oh2006 300, yun2013 450.
  data.cases[1].values[1] = 300;
  const std::string headline = iterations_headline(data);
  EXPECT_NE(headline.find("published schedules: yun2013 alone in 50 % of the views, dda in 25 %; several of "
                          "dda, oh2006 alike "
                          "in 25 %."),
            std::string::npos)
      << headline;
  const Wins found = wins(StudyTable(data), "steps", {}, kAnyAngle);
  size_t all = found.shared;
  for (const auto& [algorithm, views] : found.alone) all += views;
  EXPECT_EQ(all, found.views);
  EXPECT_EQ(found.of("dda"), 2u) << "its own view and the shared one";
}

TEST(StudyPage, AsksTheNetworkForNothingAndEscapesItsData) {
  const std::string page = iterations_page(tests::example_iterations());
  for (const char* part : {"http:", "https:", "@import", "url(", "<script src", "1 < 2"}) {
    EXPECT_EQ(page.find(part), std::string::npos) << part;
  }
  EXPECT_NE(page.find("1 &lt; 2 &amp; &quot;so&quot;"), std::string::npos);
}

TEST(StudyPage, EveryStatementOfTheLiteratureCarriesItsMark) {
  const std::string page = iterations_page(tests::example_iterations());
  size_t articles = 0;
  for (size_t at = page.find("<article>"); at != std::string::npos; at = page.find("<article>", at + 1)) {
    const size_t mark = page.find("<small>", at) + 7;
    const std::string text = page.substr(mark, page.find('<', mark) - mark);
    EXPECT_TRUE(text == "printed" || text.find("prototype") != std::string::npos) << text;
    ++articles;
  }
  EXPECT_GE(articles, 8u);
}

TEST(StudyPage, APartialOrNearlyEmptyStudyStillMakesAPage) {
  StudyData data = tests::example_iterations();
  data.cases.resize(1);
  EXPECT_NE(iterations_page(data).find("1 cases of 11: partial"), std::string::npos);
}

TEST(StudyParts, SpreadGivesLeastLowerMedianAndLargest) {
  const StudyData data = tests::example_iterations();
  const StudyTable table(data);
  const Spread all = spread_against(table, "yun2013", "oh2006", "steps", {});
  EXPECT_EQ(all.views, 4u);
  EXPECT_DOUBLE_EQ(all.least, 0.4);
  EXPECT_DOUBLE_EQ(all.median, 0.5);
  EXPECT_DOUBLE_EQ(all.largest, 0.8);
  EXPECT_EQ(spread_against(table, "tevs2008", "oh2006", "steps", {}).views, 0u);
}

TEST(SvgLinePlot, ALogarithmicAxisPlacesDecadesEquallyFarApart) {
  LinePlot plot;
  plot.logarithmic = true;
  plot.points = true;
  plot.places = {0, 0.5, 1};
  plot.place_texts = {"a", "b", "c"};
  plot.lines = {{"line", "s0", {1, 10, 100}, {"1", "10", "100"}}};
  const std::string svg = svg_line_plot(plot);
  // 220 high from 18: the foot is 1, the top 100.
  for (const char* y : {"cy=\"238.0\"", "cy=\"128.0\"", "cy=\"18.0\""}) {
    EXPECT_NE(svg.find(y), std::string::npos) << y << "\n" << svg;
  }
}

}  // namespace
}  // namespace cuesta
