#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/picture.h"

namespace cuesta {

/// Small pictures of one size side by side: a column per subject, a row per view of it. Their pixels are entries of
/// `panel_palette()`.
struct PanelGrid {
  int width = 0, height = 0;                              ///< of a panel, pixels
  std::vector<std::string> columns, rows;                 ///< headings
  std::vector<std::vector<std::vector<uint8_t>>> panels;  ///< [row][column][y * width + x]
};

inline constexpr int kPanelShades = 100;
/// A colour from dark violet (0) to yellow (1); and a grey from black to white.
uint8_t panel_colour(double position);
uint8_t panel_grey(double position);
inline constexpr uint8_t kPanelMark = 2 * kPanelShades;  ///< signal red: what is wrong
inline constexpr uint8_t kPanelEmpty = kPanelMark + 1;   ///< no ray

Picture panel_picture(const PanelGrid& grid);

}  // namespace cuesta
