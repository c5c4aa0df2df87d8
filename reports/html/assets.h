#pragma once

#include <string_view>

namespace cuesta::html {

// The text of style.css and script.js, put into the program when it is built (embed.cmake).
extern const std::string_view kStyleSheet;
extern const std::string_view kScript;

}  // namespace cuesta::html
