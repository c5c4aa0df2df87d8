#include "reports/panel_grid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cuesta {
namespace {

constexpr int kGap = 10, kLine = 22, kWide = 300;
constexpr uint8_t kPaper = kPanelEmpty + 1, kInk = kPanelEmpty + 2;

uint8_t shade(double position) {
  return static_cast<uint8_t>(std::lround(std::clamp(position, 0.0, 1.0) * (kPanelShades - 1)));
}

std::vector<Colour> panel_palette() {
  std::vector<Colour> palette;
  for (int k = 0; k < kPanelShades; ++k) palette.push_back(viridis(k / (kPanelShades - 1.0)));
  for (int k = 0; k < kPanelShades; ++k) {
    const auto grey = static_cast<uint8_t>(255 * k / (kPanelShades - 1));
    palette.push_back({grey, grey, grey});
  }
  palette.push_back({230, 30, 40});
  palette.push_back({225, 232, 240});
  palette.push_back({255, 255, 255});
  palette.push_back({32, 32, 32});
  return palette;
}

}  // namespace

uint8_t panel_colour(double position) { return shade(position); }
uint8_t panel_grey(double position) { return static_cast<uint8_t>(kPanelShades + shade(position)); }

Picture panel_picture(const PanelGrid& grid) {
  const int columns = static_cast<int>(grid.columns.size()), rows = static_cast<int>(grid.rows.size());
  const int text = grid.width >= kWide ? 2 : 1;
  Picture picture{kGap + columns * (grid.width + kGap),
                  kLine + kGap + rows * (grid.height + kLine + kGap),
                  panel_palette(),
                  {}};
  picture.pixels.assign(static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height), kPaper);
  for (int c = 0; c < columns; ++c) {
    draw_text(picture, kGap + c * (grid.width + kGap), kGap, grid.columns[static_cast<size_t>(c)], kInk,
              text);
  }
  for (int r = 0; r < rows; ++r) {
    const int top = kGap + kLine + r * (grid.height + kLine + kGap);
    draw_text(picture, kGap, top, grid.rows[static_cast<size_t>(r)], kInk, text);
    for (int c = 0; c < columns; ++c) {
      const std::vector<uint8_t>& panel = grid.panels[static_cast<size_t>(r)][static_cast<size_t>(c)];
      for (int y = 0; y < grid.height; ++y) {
        const size_t to = static_cast<size_t>(top + kLine + y) * static_cast<size_t>(picture.width) +
                          static_cast<size_t>(kGap + c * (grid.width + kGap));
        std::copy_n(panel.begin() + static_cast<ptrdiff_t>(y) * grid.width, grid.width,
                    picture.pixels.begin() + static_cast<ptrdiff_t>(to));
      }
    }
  }
  return picture;
}

}  // namespace cuesta
