#include "reports/html/html_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "models/common/error.h"
#include "reports/headline.h"
#include "reports/html/html_document.h"
#include "reports/html/html_sections.h"
#include "reports/html/html_text.h"
#include "reports/numbers.h"

namespace cuesta {
namespace {

using namespace html;

std::string section(const std::string& title, const std::string& lead, const std::string& body) {
  if (body.empty()) return "";
  return "<section><h2>" + title + "</h2>" + (lead.empty() ? "" : "<p class=\"lead\">" + lead + "</p>") +
         body + "</section>\n";
}

std::string facts_line(const Result& result) {
  const RunEntry& run = result.runs.front();
  auto varies = [&](std::string RunEntry::*part) {
    for (const RunEntry& other : result.runs) {
      if (other.*part != run.*part) return true;
    }
    return false;
  };
  std::string line = fmt::format("{} fidelity", varies(&RunEntry::fidelity) ? "several" : run.fidelity);
  line += varies(&RunEntry::architecture) ? ", several architectures" : ", architecture " + run.architecture;
  if (!varies(&RunEntry::architecture) && run.machine.clock_mhz() > 0) {
    line += fmt::format(" ({} pipeline{} at {} MHz)", run.machine.pipelines(),
                        run.machine.pipelines() == 1 ? "" : "s", run.machine.clock_mhz());
  }
  return line;
}

std::string scene_sections(const Result& result, const RunGroup& group, bool several, ShownNames& shown) {
  const RunEntry& first = result.runs[group.runs.front()];
  const std::string on = several ? " on " + escape(group.scene) : "";
  // Of a partial run's rays only those count that it has finished.
  const bool same_rays =
      group.runs.size() > 1 && std::none_of(group.runs.begin(), group.runs.end(),
                                            [&](size_t run) { return result.runs[run].partial(); });
  std::string html = section(several ? escape(group.scene) : "In numbers",
                             fmt::format("{} rays{}.", grouped(static_cast<int64_t>(first.all_rays)),
                                         same_rays ? ", the same for every row" : ""),
                             comparison_table(result, group, shown) + number_plots(result, group, shown));
  html += section("Where the cycles went" + on, "", utilisation_plots(result, group, shown));
  html += section("Memory traffic" + on, "", traffic_plots(result, group, shown));
  html += section("Distributions" + on, "", histogram_plots(result, group, shown));
  return html;
}

}  // namespace

std::string html_page(const Result& result) {
  if (result.runs.empty()) throw usage_error("A report needs at least one run; this result has none.");
  ShownNames shown;
  const std::vector<RunGroup> groups = group_by_scene(result);
  std::string body = section("Over the scenes", "", scene_plots(result, shown));
  for (const RunGroup& group : groups) body += scene_sections(result, group, groups.size() > 1, shown);
  body +=
      section("Per pixel",
              "The same pixel is marked in every picture of its scene. The EXR files hold the exact counts.",
              heat_map_section(result, shown));
  const std::string counters = counter_tables(result, shown);
  if (!counters.empty()) {
    body += "<section><h2>Every counter</h2><details><summary>Table</summary>" + counters +
            "</details></section>\n";
  }
  body += section("What the words mean", "", definition_list(shown));
  body += "<section><h2>Where this comes from</h2><details><summary>Inputs, digests, versions</summary>" +
          provenance(result) + "</details></section>\n";
  const std::string title = "Cuesta: " + result.command + " on " + result.runs.front().scene +
                            (groups.size() > 1 ? fmt::format(" and {} more", groups.size() - 1) : "");
  return html_document(title, headline(result), facts_line(result), body);
}

}  // namespace cuesta
