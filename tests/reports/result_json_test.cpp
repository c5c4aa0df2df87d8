#include "reports/result_json.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>

#include "models/common/error.h"
#include "tests/support/example_result.h"
#include "tests/support/json_schema.h"

namespace cuesta {
namespace {

using Json = nlohmann::json;
using tests::schema_faults;

Json schema() {
  std::ifstream stream("reports/result.schema.json");
  return Json::parse(stream);
}

std::string listed(const std::vector<std::string>& faults) {
  std::string text;
  for (const std::string& fault : faults) text += fault + "\n";
  return text;
}

TEST(ResultJson, OutputOfEveryKindIsValidBySchema) {
  tests::ExampleShape shape;
  EXPECT_EQ(listed(schema_faults(schema(), Json::parse(result_json(tests::example_result(shape))))), "");
  shape.timed = false;
  EXPECT_EQ(listed(schema_faults(schema(), Json::parse(result_json(tests::example_result(shape))))), "");
  shape = {};
  shape.scenes = {"front", "grazing"};
  Result partial = tests::example_result(shape);
  partial.runs[0].finished_rays = 5;
  partial.runs[0].digest.clear();
  EXPECT_EQ(listed(schema_faults(schema(), Json::parse(result_json(partial)))), "");
}

TEST(ResultJson, SchemaRejectsEachOfThese) {
  const Json good = Json::parse(result_json(tests::example_result()));
  const auto broken = [&](const std::function<void(Json&)>& breaks) {
    Json copy = good;
    breaks(copy);
    return schema_faults(schema(), copy).size();
  };
  EXPECT_EQ(broken([](Json&) {}), 0u);
  EXPECT_GT(broken([](Json& j) { j["schema"] = "cuesta-result-0"; }), 0u);
  EXPECT_GT(broken([](Json& j) { j.erase("runs"); }), 0u);
  EXPECT_GT(broken([](Json& j) { j["runs"] = Json::array(); }), 0u);
  EXPECT_GT(broken([](Json& j) { j["more"] = 1; }), 0u);
  EXPECT_GT(broken([](Json& j) { j["runs"][0]["fidelity"] = "guess"; }), 0u);
  EXPECT_GT(broken([](Json& j) { j["runs"][0]["counters"]["machine.rays"]["value"] = 1.5; }), 0u);
  EXPECT_GT(broken([](Json& j) {
              j["runs"][0]["counters"]["Machine rays"] = j["runs"][0]["counters"]["machine.rays"];
            }),
            0u);
  EXPECT_GT(broken([](Json& j) { j["runs"][0]["hits_digest"] = "abc"; }), 0u);
  EXPECT_GT(broken([](Json& j) { j["runs"][0]["planes"]["plane.steps"]["file"] = "../x.exr"; }), 0u);
  EXPECT_GT(broken([](Json& j) { j["runs"][0]["histograms"]["latency"]["bins"][0] = Json::array({1}); }), 0u);
}

TEST(ResultJson, ValidatorReportsAKeywordThatItDoesNotKnow) {
  EXPECT_EQ(schema_faults(Json{{"multipleOf", 2}}, Json(4)).size(), 1u);
}

TEST(ResultJson, HoldsCountersExactly) {
  Result result = tests::example_result();
  result.runs[0].measurements.counters.set("machine.cycles",
                                           9007199254740993);  // 2^53 + 1: no double holds it
  const Json json = Json::parse(result_json(result));
  EXPECT_EQ(json["runs"][0]["counters"]["machine.cycles"]["value"].get<int64_t>(), 9007199254740993);
  EXPECT_EQ(json["runs"][0]["counters"]["machine.cycles"]["unit"], "cycles");
}

TEST(ResultJson, RatiosFollowFromTheNumbersBesideThem) {
  const Json json = Json::parse(result_json(tests::example_result()));
  for (const Json& run : json["runs"]) {
    EXPECT_GE(run["ratios"].size(), 10u);
    for (const auto& [name, ratio] : run["ratios"].items()) {
      auto value = [&, part = &run](const std::string& of) {
        if (part->at("derived").contains(of)) return part->at("derived")[of]["value"].get<double>();
        double sum = 0;
        const size_t dot = of.find('.');
        for (const auto& [path, counter] : part->at("counters").items()) {
          const bool instance =
              path.starts_with(of.substr(0, dot) + "[") && path.ends_with("]" + of.substr(dot));
          if (path == of || instance) sum += counter["value"].get<double>();
        }
        return sum;
      };
      EXPECT_DOUBLE_EQ(ratio["value"].get<double>(), value(ratio["numerator"]) / value(ratio["denominator"]))
          << name;
    }
  }
}

TEST(ResultJson, PlaneAndNobodyAddUpToTheTotal) {
  const Json json = Json::parse(result_json(tests::example_result()));
  const Json& plane = json["runs"][0]["planes"]["plane.issue_slots"];
  EXPECT_EQ(plane["pixels"].get<int64_t>() + plane["nobody"].get<int64_t>(), plane["total"].get<int64_t>());
  EXPECT_FALSE(json["runs"][0]["planes"]["plane.latency"].contains("total"));
}

TEST(ResultJson, SameResultGivesTheSameBytes) {
  EXPECT_EQ(result_json(tests::example_result()), result_json(tests::example_result()));
}

TEST(ResultJson, RefusesACounterThatNobodyDefined) {
  Result result = tests::example_result();
  result.runs[0].measurements.counters.set("made.up", 1);
  EXPECT_THROW(result_json(result), Error);
}

TEST(ManifestJson, KeepsTimesOfDayAndHostApart) {
  Result result = tests::example_result();
  Json first = Json::parse(manifest_json(result));
  result.manifest.environment = {{"host", "another"}, {"started", "2031-01-01T00:00:00Z"}};
  Json second = Json::parse(manifest_json(result));
  EXPECT_NE(first, second);
  first.erase("environment");
  second.erase("environment");
  EXPECT_EQ(first, second);
  EXPECT_EQ(first["digests"].size(), result.runs.size());
}

}  // namespace
}  // namespace cuesta
