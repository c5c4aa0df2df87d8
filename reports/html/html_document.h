#pragma once

#include <string>

namespace cuesta::html {

/// Makes a self-contained HTML file, with style sheet and script in it. On top stands `headline`, then the
/// title, then `facts`, a line; these three are text, `body` is markup. The file asks the network for
/// nothing.
std::string html_document(const std::string& title, const std::string& headline, const std::string& facts,
                          const std::string& body);

}  // namespace cuesta::html
