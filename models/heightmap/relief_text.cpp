#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "models/common/random.h"
#include "models/heightmap/noise.h"
#include "models/heightmap/reliefs.h"
#include "models/heightmap/stroke_font.h"

namespace cuesta {
namespace {

/// A block of lines of `columns` characters; a character takes 6 x 9 units of the font.
struct Page {
  int columns;
  std::vector<std::string> lines;
  double stroke;  ///< half of a stroke's width, in units
  double bevel;   ///< width of the slope at a stroke's border, in units; at least a texel is taken
};

constexpr double kPitchX = 6, kPitchY = 9;

/// The page stretched over the map, each axis on its own; 0 outside the strokes, 1 on them.
ReliefRows relief_of_page(Page page, int width, int height) {
  double units_x = page.columns * kPitchX, units_y = static_cast<double>(page.lines.size()) * kPitchY;
  double texel = std::max(units_x / width, units_y / height);
  double bevel = std::max(page.bevel, texel);
  return [=, page = std::move(page)](int j, double* row) {
    double v = (j + 0.5) * units_y / height;
    auto line = static_cast<size_t>(v / kPitchY);
    double y = v - static_cast<double>(line) * kPitchY - (kPitchY - kGlyphHeight) / 2;
    for (int i = 0; i < width; ++i) {
      double u = (i + 0.5) * units_x / width;
      auto column = static_cast<size_t>(u / kPitchX);
      double x = u - static_cast<double>(column) * kPitchX - (kPitchX - kGlyphWidth) / 2;
      const std::string& text = page.lines[line];
      double distance = column < text.size() ? glyph_distance(text[column], x, y) : 1e30;
      row[i] = clamp_unit((page.stroke - distance) / bevel);
    }
  };
}

constexpr const char* kWords[] = {"CUESTA", "HEIGHT", "RELIEF", "RIDGES", "SUMMIT", "SCARPS",
                                  "VALLEY", "TEXELS", "LEVELS", "NODES",  "CACHE",  "QUEUE",
                                  "BASINS", "DELTAS", "FJORDS", "GORGES", "PLAINS", "SLOPES",
                                  "PEAKS",  "STEPS",  "MESAS",  "CLIFFS", "DUNES",  "CRATER"};
constexpr int kWordCount = static_cast<int>(sizeof kWords / sizeof kWords[0]);

std::string centred(const std::string& word, int columns) {
  int gap = (columns - static_cast<int>(word.size())) / 2;
  return std::string(static_cast<size_t>(std::max(gap, 0)), ' ') + word;
}

}  // namespace

ReliefRows make_text(int width, int height, uint64_t seed) {
  Random random(seed);
  Page page{6, {}, 0.75, 0.4};
  while (page.lines.size() < 4) {
    std::string word = kWords[random.below(kWordCount)];
    bool again = false;
    for (const std::string& line : page.lines) again = again || line.find(word) != std::string::npos;
    if (!again) page.lines.push_back(centred(word, page.columns));
  }
  return relief_of_page(std::move(page), width, height);
}

ReliefRows make_text512(int width, int height, uint64_t) {
  Page page{18,
            {"A RAY ENTERS THE", "PYRAMID AT ITS TOP", "AND GOES DOWN WHEN", "THE NODE IS HIGHER",
             "THAN THE RAY. ELSE", "IT CROSSES TO THE", "NEXT NODE AND MAY", "GO UP ONE LEVEL.",
             "NO STEP PASSES THE", "SURFACE - THE HIT", "IS ALWAYS THE SAME", "0123456789 CUESTA"},
            0.5,
            0.1};
  return relief_of_page(std::move(page), width, height);
}

ReliefRows make_logo(int width, int height, uint64_t) {
  double side = std::min(width, height);
  double left = (width / side - 1) / 2, top = (height / side - 1) / 2;
  double texel = 1 / side;
  auto raised = [=](double inside, double bevel) { return clamp_unit(inside / std::max(bevel, texel)); };
  return relief_of(width, height, [=](double map_x, double map_y) {
    double x = map_x - left, y = map_y - top;
    // A ring around a landform that rises gently and falls off as a scarp, three beds one behind the other.
    double dx = x - 0.5, dy = y - 0.38;
    double radius = std::sqrt(dx * dx + dy * dy);
    double ring = raised(0.032 - std::fabs(radius - 0.29), 0.014);
    double height_here = ring;
    if (radius < 0.25) {
      for (int bed = 0; bed < 3; ++bed) {
        double crest_x = 0.67 - 0.07 * bed, crest_y = 0.46 - 0.11 * bed;
        double gentle = (y - crest_y) - 0.36 * (crest_x - x);  // below the gentle slope
        double scarp = (y - crest_y) / 3 - (x - crest_x);      // left of the scarp
        double inside = std::min({gentle, scarp, 0.25 - radius});
        height_here = std::max(height_here, (0.9 - 0.25 * bed) * raised(inside, 0.016));
      }
    }
    // The name below.
    const std::string name = "CUESTA";
    double unit = 0.86 / (static_cast<double>(name.size()) * kPitchX - 2);
    double u = (x - 0.07) / unit, v = (y - 0.765) / unit;
    if (u > -1 && v > -1 && v < kGlyphHeight + 1) {
      auto column = static_cast<size_t>((u + 1) / kPitchX);
      if (column < name.size()) {
        double distance = glyph_distance(name[column], u - static_cast<double>(column) * kPitchX, v);
        height_here = std::max(height_here, raised((0.75 - distance) * unit, 0.010));
      }
    }
    return height_here;
  });
}

}  // namespace cuesta
