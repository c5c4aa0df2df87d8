#pragma once

#include <string>
#include <string_view>

namespace cuesta::html {

/// Makes text fit for markup and for attribute values in double quotes.
std::string escape(std::string_view text);

/// Keeps numbers and their per cent signs on one line.
std::string with_firm_spaces(std::string text);

/// Makes JSON fit for a <script> element, which no "</" and no "<!--" in it can end.
std::string safe_json(std::string json);

/// Makes an id or class of a statistic's name: "def-height_l1-misses".
std::string anchor_of(std::string_view name);

/// How many colour classes style.css has: "s0" to "s12".
inline constexpr size_t kSeriesColours = 13;
/// Gives the colour class of the n-th run in a group; they repeat.
std::string series_class(size_t index);

std::string base64(std::string_view bytes);

/// Gives the attributes of a mark that answers to pointing, touch and keyboard; lines of `tip` are split by
/// '\n'.
std::string tip_attributes(std::string_view tip);

}  // namespace cuesta::html
