#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Words for messages.
namespace cuesta {

/// Number of letters to insert, delete, change or swap to make one text of the other.
size_t edit_distance(std::string_view a, std::string_view b);
/// The nearest of `names` if it is near enough to be meant, else empty.
std::string_view nearest_name(std::string_view found, std::span<const std::string_view> names);
/// "; did you mean `x`?", or empty.
std::string did_you_mean(std::string_view found, std::span<const std::string_view> names);
/// "a:b" at ':' -> a, b; an empty text is one empty word.
std::vector<std::string_view> split(std::string_view text, char at);
/// "a, b, c".
std::string joined(std::span<const std::string_view> names);
/// Printable, at most `limit` characters: for texts of unknown origin in messages.
std::string printable(std::string_view text, size_t limit = 60);
/// Shortest decimal text that reads back as the same double.
std::string shortest_text(double value);

}  // namespace cuesta
