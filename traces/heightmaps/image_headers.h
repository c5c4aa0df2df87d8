#pragma once

#include <string>

namespace cuesta {

/// True when the file's colours come from a palette, which OpenImageIO expands without saying so.
/// Looks at the headers of PNG, BMP and TGA.
bool has_palette(const std::string& path, const std::string& format);

/// Damage that the format's reader passes over in silence, as the end of a sentence; empty when there is none:
/// a JPEG without its end marker (the missing rows would come back grey), a BMP or TGA with fewer bytes than its
/// uncompressed rows need.
std::string damage_that_readers_hide(const std::string& path, const std::string& format, int width,
                                     int height);

}  // namespace cuesta
