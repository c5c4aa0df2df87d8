#include "reports/study/literature.h"

#include <fmt/format.h>

namespace cuesta::html {

std::string statements(const std::vector<Statement>& all, const StudyTable& table) {
  std::string html = "<div class=\"statements\">";
  for (const Statement& one : all) {
    html += fmt::format(
        "<article><h3>{}<small>{}</small></h3><p>{}</p><div><b>Here:</b> {}</div><p "
        "class=\"note\">{}</p></article>",
        one.source, one.mark, one.says, one.ours(table), one.why);
  }
  return html + "</div>";
}

}  // namespace cuesta::html
