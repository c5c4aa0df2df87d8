#include "reports/result_json.h"

#include <nlohmann/json.hpp>
#include <numeric>

#include "models/common/error.h"
#include "models/units/statistics.h"
#include "reports/quantities.h"

namespace cuesta {
namespace {

using Json = nlohmann::ordered_json;

std::string unit_of(std::string_view path) { return std::string(definition_of(path).unit); }

Json inputs_of(const Result& result) {
  Json inputs = Json::array();
  for (const Input& input : result.inputs) {
    inputs.push_back({{"role", input.role}, {"path", input.path}, {"sha256", input.sha256}});
  }
  return inputs;
}

Json machine_of(const MachineFacts& machine) {
  return {{"pipelines", machine.pipelines()},
          {"clock_mhz", machine.clock_mhz()},
          {"line_bytes", machine.line_bytes()},
          {"texel_bytes", machine.texel_bytes},
          {"dram_peak_bytes_per_cycle", {machine.dram_peak_bytes(), machine.dram_peak_cycles()}}};
}

Json counters_of(const Counters& counters) {
  Json object = Json::object();
  for (const auto& [path, value] : counters.all()) object[path] = {{"value", value}, {"unit", unit_of(path)}};
  return object;
}

Json derived_of(const RunEntry& run) {
  Json object = Json::object();
  for (const DerivedQuantity& derived : derived_quantities()) {
    const auto value = quantity(run, derived.name);
    if (value) object[std::string(derived.name)] = {{"value", *value}, {"unit", std::string(derived.unit)}};
  }
  return object;
}

Json ratios_json(const RunEntry& run) {
  Json object = Json::object();
  for (const Ratio& ratio : ratios_of(run)) {
    const RatioDefinition& definition = *ratio.definition;
    object[std::string(definition.name)] = {{"value", ratio.value},
                                            {"numerator", std::string(definition.numerator)},
                                            {"denominator", std::string(definition.denominator)},
                                            {"unit", std::string(definition.unit)}};
  }
  return object;
}

Json histograms_of(const Measurements& measurements) {
  Json object = Json::object();
  for (const Histogram& histogram : measurements.histograms) {
    Json bins = Json::array();
    for (size_t k = 0; k < histogram.first.size(); ++k) {
      if (histogram.count[k] != 0) bins.push_back({histogram.first[k], histogram.count[k]});
    }
    object[histogram.name] = {{"unit", unit_of(histogram.name)},
                              {"median", histogram.median},
                              {"p99", histogram.p99},
                              {"max", histogram.max},
                              {"bins", bins}};
  }
  return object;
}

Json planes_of(const Result& result, size_t run_index) {
  const Measurements& measurements = result.runs[run_index].measurements;
  Json object = Json::object();
  for (const Plane& plane : measurements.planes) {
    const int64_t pixels = std::accumulate(plane.values.begin(), plane.values.end(), int64_t{0});
    Json entry = {{"unit", unit_of(plane.name)},
                  {"file", planes_path(result, run_index)},
                  {"channel", plane.name.substr(plane.name.find('.') + 1)},
                  {"width", measurements.plane_width},
                  {"height", measurements.plane_height},
                  {"adds_up", plane.adds_up}};
    if (plane.adds_up) {
      entry["pixels"] = pixels;
      entry["nobody"] = plane.nobody;
      entry["total"] = pixels + plane.nobody;
    }
    object[plane.name] = entry;
  }
  return object;
}

Json pairs_of(const ManifestInfo::Pairs& pairs) {
  Json object = Json::object();
  for (const auto& [name, value] : pairs) object[name] = value;
  return object;
}

/// Text from a command line or a file name may be anything but must not stop a report: bad UTF-8 is replaced.
std::string dump(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace

std::string planes_path(const Result& result, size_t run_index) {
  return "planes/" + file_stem_of(result, run_index) + ".exr";
}

std::string result_json(const Result& result) {
  Json runs = Json::array();
  for (size_t i = 0; i < result.runs.size(); ++i) {
    const RunEntry& run = result.runs[i];
    runs.push_back({{"scene", run.scene},
                    {"algorithm", run.algorithm},
                    {"architecture", run.architecture},
                    {"fidelity", run.fidelity},
                    {"partial", run.partial()},
                    {"rays", {{"finished", run.finished_rays}, {"of", run.all_rays}}},
                    {"machine", machine_of(run.machine)},
                    {"counters", counters_of(run.measurements.counters)},
                    {"derived", derived_of(run)},
                    {"ratios", ratios_json(run)},
                    {"histograms", histograms_of(run.measurements)},
                    {"planes", planes_of(result, i)},
                    {"hits_digest", run.hits_digest},
                    {"digest", run.digest}});
  }
  return dump({{"schema", std::string(kResultSchema)},
               {"command", result.command},
               {"inputs", inputs_of(result)},
               {"runs", runs}});
}

std::string manifest_json(const Result& result) {
  const ManifestInfo& manifest = result.manifest;
  Json digests = Json::array();
  for (const RunEntry& run : result.runs) {
    digests.push_back({{"scene", run.scene},
                       {"algorithm", run.algorithm},
                       {"architecture", run.architecture},
                       {"fidelity", run.fidelity},
                       {"hits_digest", run.hits_digest},
                       {"digest", run.digest}});
  }
  return dump({{"schema", "cuesta-manifest-1"},
               {"tool", {{"name", "cuesta"}, {"version", manifest.version}, {"commit", manifest.commit}}},
               {"build", {{"compiler", manifest.compiler}, {"flags", manifest.flags}}},
               {"libraries", pairs_of(manifest.libraries)},
               {"inputs", inputs_of(result)},
               {"seeds", pairs_of(manifest.seeds)},
               {"digests", digests},
               {"environment", pairs_of(manifest.environment)}});
}

}  // namespace cuesta
