#pragma once

#include <charconv>
#include <string>

namespace cuesta {

/// The shortest decimal text that reads back as the same number, whatever the locale: "255", "-4.7".
inline std::string number_text(double value) {
  char buffer[64];
  auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return std::string(buffer, end);
}

/// The same for a number that a float held: "921.3" instead of "921.2999877929688".
inline std::string number_text(float value) {
  char buffer[64];
  auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return std::string(buffer, end);
}

}  // namespace cuesta
