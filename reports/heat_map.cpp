#include "reports/heat_map.h"

#include <algorithm>
#include <cmath>

#include "reports/numbers.h"
#include "reports/quantities.h"

namespace cuesta {
namespace {

constexpr size_t kMostBins = 254;

const Plane* plane_of(const RunEntry& run, std::string_view name) {
  for (const Plane& plane : run.measurements.planes) {
    if (plane.name == name) return &plane;
  }
  return nullptr;
}

int64_t percentile_99(std::vector<uint32_t> values) {
  const auto place = values.begin() + static_cast<ptrdiff_t>((values.size() - 1) * 99 / 100);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// 0, 1, 2 and so on, each at least `factor` times the one before, as far as `maximum`.
std::vector<int64_t> rising(double factor, int64_t maximum) {
  std::vector<int64_t> first = {0};
  for (int64_t next = 1; next <= std::max<int64_t>(maximum, 1) && first.size() <= kMostBins;) {
    first.push_back(next);
    next = std::max(next + 1, static_cast<int64_t>(std::ceil(static_cast<double>(next) * factor)));
  }
  return first;
}

/// Single counts as far as they reach, then the finest equal ratio that 254 bins allow.
std::vector<int64_t> logarithmic_bins(int64_t maximum) {
  double fine = 1, coarse = 2;
  for (int k = 0; k < 30; ++k) {
    const double factor = (fine + coarse) / 2;
    (rising(factor, maximum).size() <= kMostBins ? coarse : fine) = factor;
  }
  return rising(coarse, maximum);
}

std::vector<int64_t> even_bins(int64_t maximum) {
  std::vector<int64_t> first;
  for (size_t k = 0; k < kMostBins; ++k) {
    first.push_back(static_cast<int64_t>(k) * (maximum + 1) / static_cast<int64_t>(kMostBins));
  }
  return first;
}

}  // namespace

size_t HeatScale::bin_of(int64_t value) const {
  return static_cast<size_t>(std::upper_bound(first.begin() + 1, first.end(), value) - first.begin()) - 1;
}

double HeatScale::place_of(int64_t value) const {
  const double top = static_cast<double>(std::max<int64_t>(maximum, 1));
  const double v = static_cast<double>(value);
  return std::clamp(logarithmic ? std::log1p(v) / std::log1p(top) : v / top, 0.0, 1.0);
}

std::vector<int64_t> HeatScale::ticks() const {
  std::vector<int64_t> ticks = {0};
  if (logarithmic) {
    for (int64_t decade = 1; decade <= maximum; decade *= 10) {
      for (int64_t step : {1, 2, 5}) {
        const bool room = place_of(step * decade) - place_of(ticks.back()) > 0.07;
        if (step * decade <= maximum && room && place_of(step * decade) < 0.95)
          ticks.push_back(step * decade);
      }
    }
  } else {
    const auto step = static_cast<int64_t>(std::max(1.0, round_up_nicely(static_cast<double>(maximum) / 5)));
    for (int64_t tick = step; tick <= maximum; tick += step) {
      if (place_of(tick) < 0.95) ticks.push_back(tick);
    }
  }
  if (maximum > 0) ticks.push_back(maximum);
  return ticks;
}

HeatScale make_heat_scale(const Result& result, std::string_view plane_name) {
  HeatScale scale;
  int64_t lowest_high = -1, highest_high = 0;  // the 99th percentiles of the runs
  for (const RunEntry& run : result.runs) {
    const Plane* plane = plane_of(run, plane_name);
    if (plane == nullptr || plane->values.empty()) continue;
    scale.maximum =
        std::max<int64_t>(scale.maximum, *std::max_element(plane->values.begin(), plane->values.end()));
    const int64_t high = percentile_99(plane->values);
    lowest_high = lowest_high < 0 ? high : std::min(lowest_high, high);
    highest_high = std::max(highest_high, high);
  }
  if (const StatisticDefinition* definition = find_statistic(plane_name)) scale.unit = definition->unit;
  scale.logarithmic = scale.maximum > 16 && 3 * std::max<int64_t>(lowest_high, 1) <= scale.maximum;
  scale.first = scale.maximum < static_cast<int64_t>(kMostBins) ? rising(1.0, scale.maximum)
                : scale.logarithmic                             ? logarithmic_bins(scale.maximum)
                                                                : even_bins(scale.maximum);
  for (int64_t first : scale.first) scale.position.push_back(scale.place_of(first));
  return scale;
}

std::vector<Colour> palette_of(const HeatScale& scale) {
  std::vector<Colour> palette;
  for (double position : scale.position) {
    Colour colour = viridis(position);
    while (std::find(palette.begin(), palette.end(), colour) != palette.end()) ++colour.b;
    palette.push_back(colour);
  }
  return palette;
}

PlanePicture plane_picture(const Plane& plane, int width, int height, const HeatScale& scale, int limit) {
  PlanePicture result;
  result.reduction = std::max(1, (std::max(width, height) + limit - 1) / limit);
  Picture& picture = result.picture;
  const int n = result.reduction;
  picture.width = (width + n - 1) / n;
  picture.height = (height + n - 1) / n;
  picture.palette = palette_of(scale);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      int64_t sum = 0, count = 0;
      for (int v = y * n; v < std::min(height, (y + 1) * n); ++v) {
        for (int u = x * n; u < std::min(width, (x + 1) * n); ++u, ++count) {
          sum += plane.values[static_cast<size_t>(v) * static_cast<size_t>(width) + static_cast<size_t>(u)];
        }
      }
      picture.pixels.push_back(static_cast<uint8_t>(scale.bin_of((sum + count / 2) / count)));
    }
  }
  return result;
}

Picture heat_map(const Plane& plane, int width, int height, const HeatScale& scale, const std::string& title,
                 const std::string& subtitle) {
  constexpr int kText = 2, kMargin = 12, kBarWidth = 20, kLine = (kGlyphHeight + 3) * kText,
                kTop = kMargin + 2 * kLine + 6;
  const Picture map = plane_picture(plane, width, height, scale, 2048).picture;
  const int zoom = std::max(1, 384 / std::max(map.width, map.height));
  const int map_width = map.width * zoom, map_height = std::max(map.height * zoom, 160);
  const int label_width = text_width(grouped(scale.maximum) + " ") + 14;
  const int bar_caption = text_width(scale.unit + (scale.logarithmic ? " (log)" : ""));
  const int texts = std::max({text_width(title), text_width(subtitle),
                              map_width + kMargin + std::max(kBarWidth + label_width, bar_caption)});
  Picture picture{2 * kMargin + texts, kTop + map_height + kMargin + kLine, map.palette, {}};
  const auto paper = static_cast<uint8_t>(picture.palette.size()), ink = static_cast<uint8_t>(paper + 1);
  picture.palette.push_back({255, 255, 255});
  picture.palette.push_back({32, 32, 32});
  picture.pixels.assign(static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height), paper);
  draw_text(picture, kMargin, kMargin, title, ink, kText);
  draw_text(picture, kMargin, kMargin + kLine, subtitle, ink, kText);
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const uint8_t colour =
          map.pixels[static_cast<size_t>(y) * static_cast<size_t>(map.width) + static_cast<size_t>(x)];
      picture.fill_rectangle(kMargin + x * zoom, kTop + y * zoom, zoom, zoom, colour);
    }
  }
  const int bar = kMargin + map_width + kMargin;
  for (int y = 0; y < map_height; ++y) {
    const double share = map_height == 1 ? 1 : 1 - static_cast<double>(y) / (map_height - 1);
    const auto bin =
        std::upper_bound(scale.position.begin() + 1, scale.position.end(), share) - scale.position.begin();
    picture.fill_rectangle(bar, kTop + y, kBarWidth, 1, static_cast<uint8_t>(bin - 1));
  }
  for (int64_t tick : scale.ticks()) {
    const int y = kTop + static_cast<int>(std::lround((1 - scale.place_of(tick)) * (map_height - 1)));
    picture.fill_rectangle(bar + kBarWidth, y, 6, 1, ink);
    const int text_y =
        std::clamp(y - kGlyphHeight * kText / 2, kTop, kTop + map_height - kGlyphHeight * kText);
    draw_text(picture, bar + kBarWidth + 10, text_y, grouped(tick), ink, kText);
  }
  draw_text(picture, bar, kTop + map_height + 6, scale.unit + (scale.logarithmic ? " (log)" : ""), ink,
            kText);
  return picture;
}

}  // namespace cuesta
