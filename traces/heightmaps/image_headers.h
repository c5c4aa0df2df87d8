#pragma once

#include <string>

namespace cuesta {

/// True when the file's colours come from a palette, which OpenImageIO expands without saying so.
/// Looks at the headers of PNG, BMP and TGA.
bool has_palette(const std::string& path, const std::string& format);

/// Damage that a format's reader passes over in silence, or prints to stderr by itself, as the end of a
/// sentence; empty when there is none, and for files of another format.
/// Before opening: a PNG that ends before its last chunk, or with a chunk whose check sum is wrong.
std::string damage_of_png(const std::string& path);
/// After opening: a JPEG without its end marker (the missing rows would come back grey); a BMP or TGA with
/// fewer bytes than its rows or runs need (they would come back black).
std::string damage_of_others(const std::string& path, const std::string& format, int width, int height);

}  // namespace cuesta
