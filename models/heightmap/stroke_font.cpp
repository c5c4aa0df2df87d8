#include "models/heightmap/stroke_font.h"

#include <algorithm>
#include <cmath>

namespace cuesta {
namespace {

struct Glyph {
  char character;
  std::string_view strokes;
};

constexpr Glyph kGlyphs[] = {
    {'A', "0602204246|0444"},
    {'B', "06003041423303|3344453606"},
    {'C', "4130100105163645"},
    {'D', "00304145360600"},
    {'E', "40000646|0333"},
    {'F', "400006|0333"},
    {'G', "41301001051636454323"},
    {'H', "0006|4046|0343"},
    {'I', "1030|2026|1636"},
    {'J', "4045361605"},
    {'K', "0006|400346"},
    {'L', "000646"},
    {'M', "0600234046"},
    {'N', "06004640"},
    {'O', "103041453616050110"},
    {'P', "06003041423303"},
    {'Q', "103041453616050110|2446"},
    {'R', "06003041423303|2346"},
    {'S', "413010010213334445361605"},
    {'T', "0040|2026"},
    {'U', "000516364540"},
    {'V', "002640"},
    {'W', "0016233640"},
    {'X', "0046|4006"},
    {'Y', "002340|2326"},
    {'Z', "00400646"},
    {'0', "103041453616050110|1531"},
    {'1', "112026|1636"},
    {'2', "01103041420646"},
    {'3', "0110304142334445361605|1333"},
    {'4', "36300444"},
    {'5', "4000033344453606"},
    {'6', "30100105163645443303"},
    {'7', "004016"},
    {'8', "103041423313020110|1304051636454433"},
    {'9', "43130201103041453616"},
    {'.', "2626"},
    {'-', "1333"},
};

}  // namespace

std::string_view glyph_strokes(char character) {
  for (const Glyph& glyph : kGlyphs) {
    if (glyph.character == character) return glyph.strokes;
  }
  return {};
}

double segment_distance(double x, double y, double ax, double ay, double bx, double by) {
  double dx = bx - ax, dy = by - ay, length2 = dx * dx + dy * dy;
  double along = length2 > 0 ? ((x - ax) * dx + (y - ay) * dy) / length2 : 0;
  along = along < 0 ? 0 : along > 1 ? 1 : along;
  double ex = x - ax - along * dx, ey = y - ay - along * dy;
  return std::sqrt(ex * ex + ey * ey);
}

double glyph_distance(char character, double x, double y) {
  std::string_view strokes = glyph_strokes(character);
  double nearest = 1e30;
  for (size_t at = 0; at + 3 < strokes.size(); at += 2) {
    if (strokes[at + 2] == '|') {
      ++at;  // the next stroke's first point
      continue;
    }
    double distance = segment_distance(x, y, strokes[at] - '0', strokes[at + 1] - '0', strokes[at + 2] - '0',
                                       strokes[at + 3] - '0');
    nearest = std::min(nearest, distance);
  }
  return nearest;
}

}  // namespace cuesta
