#include <fmt/format.h>

#include <map>
#include <vector>

#include "reports/html/html_sections.h"
#include "reports/html/html_text.h"
#include "reports/numbers.h"
#include "reports/quantities.h"

namespace cuesta::html {
namespace {

struct Definition {
  std::string unit, sentence, formula;
};

Definition find_definition(std::string_view name) {
  if (const RatioDefinition* ratio = find_ratio(name)) {
    return {std::string(ratio->unit), std::string(ratio->sentence),
            fmt::format("{} / {}", ratio->numerator, ratio->denominator)};
  }
  for (const DerivedQuantity& derived : derived_quantities()) {
    if (derived.name == name) return {std::string(derived.unit), std::string(derived.sentence), ""};
  }
  if (const StatisticDefinition* statistic = find_statistic(name)) {
    return {std::string(statistic->unit), std::string(statistic->sentence), ""};
  }
  return {};
}

}  // namespace

std::string definition_sentence(std::string_view name) { return find_definition(name).sentence; }

std::string defined(std::string_view name, std::string_view text, ShownNames& shown) {
  shown.insert(std::string(name));
  return fmt::format("<a class=\"def\" href=\"#{}\" data-tip=\"{}\">{}</a>", anchor_of(name),
                     escape(definition_sentence(name)), escape(text));
}

std::string definition_list(const ShownNames& shown) {
  ShownNames names = shown;
  for (const std::string& name : shown) {  // and what the ratios are made of
    if (const RatioDefinition* ratio = find_ratio(name)) {
      names.insert({std::string(ratio->numerator), std::string(ratio->denominator)});
    }
  }
  std::string html = "<dl class=\"definitions\">";
  for (const std::string& name : names) {
    const Definition definition = find_definition(name);
    if (definition.sentence.empty()) continue;
    html += fmt::format("<div id=\"{}\"><dt>{}<small>{}</small></dt><dd>{}", anchor_of(name), escape(name),
                        escape(definition.unit), escape(definition.sentence));
    if (!definition.formula.empty()) html += "<code>" + escape(definition.formula) + "</code>";
    html += "</dd></div>";
  }
  return html + "</dl>";
}

std::string counter_tables(const Result& result, ShownNames& shown) {
  std::map<std::string, std::vector<std::string>> rows;  // by name: one text per run
  for (size_t k = 0; k < result.runs.size(); ++k) {
    for (const auto& [path, value] : result.runs[k].measurements.counters.all()) {
      std::vector<std::string>& row = rows[without_index(path)];
      row.resize(result.runs.size());
      row[k] = grouped(counter_total(result.runs[k].measurements.counters, without_index(path)).value_or(0));
    }
  }
  if (rows.empty()) return "";
  const bool scenes = group_by_scene(result).size() > 1;
  std::string html =
      "<div class=\"scroll\"><table class=\"numbers\"><thead><tr><th scope=\"col\">counter, all "
      "pipelines</th>";
  for (const RunEntry& run : result.runs) {
    html += "<th scope=\"col\">" + escape(label_of(result, run)) +
            (scenes ? "<small>" + escape(run.scene) + "</small>" : "") + "</th>";
  }
  html += "</tr></thead><tbody>";
  for (const auto& [name, row] : rows) {
    html += "<tr><th scope=\"row\">" + defined(name, name, shown) + "</th>";
    for (const std::string& text : row)
      html += text.empty() ? "<td class=\"none\">-</td>" : "<td>" + text + "</td>";
    html += "</tr>";
  }
  return html + "</tbody></table></div>";
}

std::string provenance(const Result& result) {
  std::string html = "<dl class=\"provenance\">";
  auto item = [&](const std::string& name, const std::string& value) {
    if (!value.empty()) html += "<div><dt>" + escape(name) + "</dt><dd>" + escape(value) + "</dd></div>";
  };
  for (const Input& input : result.inputs) item(input.role, input.path + "  sha256 " + input.sha256);
  for (const RunEntry& run : result.runs) {
    const std::string label = label_of(result, run) + " on " + run.scene;
    item("digest of " + label, run.digest.empty() ? "none: partial" : run.digest);
    item("hits digest of " + label, run.hits_digest);
  }
  const ManifestInfo& manifest = result.manifest;
  item("cuesta", manifest.version.empty() ? "" : manifest.version + ", commit " + manifest.commit);
  item("compiler", manifest.compiler + (manifest.flags.empty() ? "" : ", " + manifest.flags));
  for (const auto& [name, value] : manifest.libraries) item(name, value);
  for (const auto& [name, value] : manifest.seeds) item("seed of " + name, value);
  return html + "</dl>";
}

}  // namespace cuesta::html
