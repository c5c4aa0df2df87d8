#pragma once

#include <string_view>

namespace cuesta {

/// A font of straight strokes: capitals, digits, full stop and hyphen. A glyph is 4 units wide and 6 high,
/// its strokes run through the points of that grid; x to the right, y down.
inline constexpr double kGlyphWidth = 4, kGlyphHeight = 6;

/// Strokes of a glyph: points of two digits (x, then y), strokes split by '|'. Empty for anything else.
std::string_view glyph_strokes(char character);

/// Distance from a point to the middle line of a glyph's nearest stroke, in units; 1e30 for an empty glyph.
double glyph_distance(char character, double x, double y);

/// Distance from (x, y) to the segment from a to b.
double segment_distance(double x, double y, double ax, double ay, double bx, double by);

}  // namespace cuesta
