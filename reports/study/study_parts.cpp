#include "reports/study/study_parts.h"

#include <fmt/format.h>

#include "reports/html/html_document.h"
#include "reports/html/html_text.h"
#include "reports/numbers.h"

namespace cuesta::html {

std::string heading_of(const StudyAxis& axis, const std::string& value) {
  return value + (axis.unit == "degrees" ? "°" : "");
}

std::string algorithm_table(const StudyTable& table, const std::string& corner, std::string_view axis,
                            const std::vector<std::string>& algorithms, const Where& where,
                            const std::function<std::string(const std::vector<StudyPlace>&)>& cell) {
  const StudyAxis& columns = table.axis(axis);
  std::vector<std::string> head{corner};
  for (const std::string& value : columns.values) head.push_back(heading_of(columns, value));
  std::vector<std::vector<std::string>> rows;
  for (const std::string& algorithm : algorithms) {
    rows.push_back({escape(algorithm)});
    for (const std::string& value : columns.values) {
      Where here = where;
      here.emplace_back("algorithm", algorithm);
      here.emplace_back(axis, value);
      rows.back().push_back(cell(places_where(table, here)));
    }
  }
  return plain_table(head, rows);
}

std::string median_table(const StudyTable& table, std::string_view axis,
                         const std::vector<std::string>& algorithms, const Where& where,
                         const ReadPlace& number, const std::function<std::string(double)>& text) {
  return algorithm_table(table, "algorithm", axis, algorithms, where,
                         [&](const std::vector<StudyPlace>& places) {
                           const Spread found = spread(places, number);
                           return found.views == 0 ? "-" : text(found.median);
                         });
}

std::string choice(const std::string& id, const std::vector<std::pair<std::string, std::string>>& panels) {
  if (panels.size() == 1) return panels[0].second;
  std::string tabs = "<div class=\"tabs\" role=\"tablist\">", bodies;
  for (size_t k = 0; k < panels.size(); ++k) {
    tabs += fmt::format("<button role=\"tab\" aria-controls=\"{}-{}\">{}</button>", id, k,
                        escape(panels[k].first));
    bodies += fmt::format("<div id=\"{}-{}\" role=\"tabpanel\" aria-label=\"{}\">{}</div>", id, k,
                          escape(panels[k].first), panels[k].second);
  }
  return tabs + "</div>" + bodies;
}

std::string plain_table(const std::vector<std::string>& head,
                        const std::vector<std::vector<std::string>>& rows) {
  std::string html = "<div class=\"scroll\"><table class=\"numbers\"><thead><tr>";
  for (const std::string& cell : head) html += "<th scope=\"col\">" + cell + "</th>";
  html += "</tr></thead><tbody>";
  for (const std::vector<std::string>& row : rows) {
    for (size_t k = 0; k < row.size(); ++k) {
      html += k == 0 ? "<tr><th scope=\"row\">" + row[k] + "</th>" : "<td>" + row[k] + "</td>";
    }
    html += "</tr>";
  }
  return html + "</tbody></table></div>";
}

std::string study_section(const std::string& title, const std::string& lead, const std::string& body) {
  return "<section><h2>" + title + "</h2>" +
         (lead.empty() ? "" : "<p class=\"lead\">" + with_firm_spaces(lead) + "</p>") + body + "</section>\n";
}

std::string study_method(const StudyData& data) {
  std::string html = "<ul class=\"prose\">";
  for (const std::string& condition : data.conditions) html += "<li>" + escape(condition) + "</li>";
  html += "<li>A median over an even number of cases is the lower of the middle two.</li>";
  html += "</ul><dl class=\"definitions\">";
  auto item = [&](const std::string& name, const std::string& unit, const std::string& sentence) {
    html += fmt::format("<div><dt>{}<small>{}</small></dt><dd>{}</dd></div>", escape(name), escape(unit),
                        escape(sentence));
  };
  for (const StudyAxis& axis : data.axes) {
    item(axis.name, axis.unit, axis.sentence + " " + listed_values(axis, ", ") + ".");
  }
  for (const StudyCounter& counter : data.counters) item(counter.name, counter.unit, counter.sentence);
  return study_section("How it was counted", "", html + "</dl>");
}

std::string study_shell(const StudyData& data, const std::string& headline, const std::string& body) {
  const std::string title = "Cuesta: study " + data.study;
  const std::string cases =
      fmt::format("{} cases{}{}", grouped(static_cast<int64_t>(data.cases.size())),
                  data.partial() ? " of " + grouped(static_cast<int64_t>(data.planned)) + ": partial" : "",
                  data.amount == "quick" ? ", the quick matrix" : "");
  return html_document(title, headline, data.question + " " + cases, body);
}

std::string percent_text(std::optional<double> percent) {
  if (!percent) return "-";
  return (*percent == 0 ? "0" : significant(*percent, *percent < 1 ? 2 : 3)) + " %";
}

}  // namespace cuesta::html
