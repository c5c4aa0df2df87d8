#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cuesta {

struct Colour {
  uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Colour&) const = default;
};

/// Indices into a palette of at most 256 colours, row by row from the top.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<Colour> palette;
  std::vector<uint8_t> pixels;

  void fill_rectangle(int x, int y, int w, int h, uint8_t colour);  ///< clipped to the picture
};

/// Viridis: dark violet to yellow through green, even steps to the eye, also in grey and to the colour-blind.
/// `position` 0 to 1. The polynomial fit by Matt Zucker (2017, CC0) to the colour map of Smith and van der Walt
/// (2015).
Colour viridis(double position);

/// Bytes of a PNG file with that palette; the same for the same picture. Throws Error(kResource).
std::string encode_png(const Picture& picture);

/// Draws text in a 5 x 7 dot font, each dot `scale` pixels on a side, its top left at (x, y). Characters outside
/// printable ASCII show as '?'.
void draw_text(Picture& picture, int x, int y, std::string_view text, uint8_t colour, int scale = 2);

/// Width in pixels that `draw_text` takes.
int text_width(std::string_view text, int scale = 2);

inline constexpr int kGlyphHeight = 7;

}  // namespace cuesta
