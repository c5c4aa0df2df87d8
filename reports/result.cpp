#include "reports/result.h"

#include <algorithm>

namespace cuesta {
namespace {

bool varies(const Result& result, std::string RunEntry::*part) {
  return std::any_of(result.runs.begin(), result.runs.end(),
                     [&](const RunEntry& run) { return run.*part != result.runs.front().*part; });
}

std::string stem_without_number(const Result& result, const RunEntry& run) {
  std::string stem = varies(result, &RunEntry::scene) ? run.scene + "." : std::string();
  stem += label_of(result, run);
  for (char& c : stem) {
    const bool fit = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
                     c == '_' || c == '-';
    if (!fit) c = '-';
  }
  if (stem.empty() || stem.front() == '.') stem.insert(0, "run");
  return stem.substr(0, 120);
}

}  // namespace

int64_t MachineFacts::at(std::string_view path, int64_t absent) const {
  const auto row = std::find_if(parameters.begin(), parameters.end(),
                                [&](const UsedParameter& one) { return one.path == path; });
  return row == parameters.end() ? absent : row->value;
}

int64_t MachineFacts::pipelines() const { return at("machine.pipelines", 1); }
int64_t MachineFacts::clock_mhz() const { return at("machine.clock_mhz"); }
int64_t MachineFacts::line_bytes() const { return at("height_l1.line_bytes"); }
int64_t MachineFacts::dram_peak_bytes() const {
  return at("dram.channels") * at("dram.bus_bytes") * at("dram.clock_num");
}
int64_t MachineFacts::dram_peak_cycles() const { return at("dram.clock_den", 1); }

std::string label_of(const Result& result, const RunEntry& run) {
  std::string label = run.algorithm;
  if (varies(result, &RunEntry::architecture)) label += " " + run.architecture;
  if (varies(result, &RunEntry::fidelity)) label += " " + run.fidelity;
  return label;
}

std::string file_stem_of(const Result& result, size_t run_index) {
  const std::string stem = stem_without_number(result, result.runs[run_index]);
  int before = 0;
  bool alone = true;
  for (size_t i = 0; i < result.runs.size(); ++i) {
    if (i == run_index || stem_without_number(result, result.runs[i]) != stem) continue;
    alone = false;
    before += i < run_index ? 1 : 0;
  }
  return alone ? stem : stem + ".run" + std::to_string(before + 1);
}

std::vector<RunGroup> group_by_scene(const Result& result) {
  std::vector<RunGroup> groups;
  for (size_t i = 0; i < result.runs.size(); ++i) {
    auto found = std::find_if(groups.begin(), groups.end(),
                              [&](const RunGroup& group) { return group.scene == result.runs[i].scene; });
    if (found == groups.end()) found = groups.insert(groups.end(), RunGroup{result.runs[i].scene, {}});
    found->runs.push_back(i);
  }
  return groups;
}

std::string_view level_of_detail(const RunEntry& run) {
  constexpr std::string_view kStop = ":stop=";
  const std::string_view name = run.algorithm;
  const size_t at = name.find(kStop);
  if (at == std::string_view::npos) return "0";
  const std::string_view level = name.substr(at + kStop.size());
  return level.substr(0, level.find(':'));
}

const RunEntry* baseline_of(const Result& result, const RunEntry& run) {
  const RunEntry* first = nullptr;
  bool some_oh = false;
  for (const RunEntry& other : result.runs) {
    if (level_of_detail(other) != level_of_detail(run)) continue;
    const bool oh = other.algorithm.starts_with("oh2006") &&
                    (other.algorithm == "oh2006" ||
                     other.algorithm == "oh2006:stop=" + std::string(level_of_detail(run)));
    some_oh = some_oh || oh;
    if (other.scene != run.scene) continue;
    if (first == nullptr) first = &other;
    const bool same_machine = other.architecture == run.architecture && other.fidelity == run.fidelity;
    if (oh && same_machine) return &other;
  }
  return some_oh ? nullptr : first;
}

const RunEntry* common_baseline(const Result& result, const RunGroup& group) {
  const RunEntry* common = baseline_of(result, result.runs[group.runs.front()]);
  for (size_t index : group.runs) {
    if (baseline_of(result, result.runs[index]) != common) return nullptr;
  }
  return common;
}

std::string baseline_name(const Result& result, const RunGroup& group) {
  const RunEntry* common = common_baseline(result, group);
  if (common != nullptr) return label_of(result, *common);
  for (size_t index : group.runs) {
    const RunEntry* own = baseline_of(result, result.runs[index]);
    if (own != nullptr) return own->algorithm;
  }
  return "";
}

}  // namespace cuesta
