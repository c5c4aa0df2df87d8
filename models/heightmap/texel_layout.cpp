#include "models/heightmap/texel_layout.h"

#include <algorithm>
#include <bit>
#include <string>

#include "models/common/error.h"

namespace cuesta {
namespace {

constexpr int kMaxSide = 16384;

}  // namespace

std::string_view name_of(TexelLayoutKind kind) {
  for (const TexelLayoutEntry& entry : kTexelLayouts) {
    if (entry.kind == kind) return entry.name;
  }
  return "?";
}

TexelLayout::TexelLayout(TexelLayoutKind kind, int width, int height, int texel_bytes) : kind_(kind) {
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide) {
    throw usage_error("A texel layout of " + std::to_string(width) + " x " + std::to_string(height) +
                      " texels was asked for; 1 to " + std::to_string(kMaxSide) +
                      " on each side are accepted.");
  }
  if (texel_bytes != 1 && texel_bytes != 2 && texel_bytes != 4) {
    throw usage_error("A texel layout with " + std::to_string(texel_bytes) +
                      " bytes a texel was asked for; 1, 2 and 4 are accepted.");
  }
  texel_shift_ = std::countr_zero(static_cast<unsigned>(texel_bytes));
  while (true) {
    levels_.push_back({});
    levels_.back().width = width;
    levels_.back().height = height;
    if (width == 1 && height == 1) break;
    width = (width + 1) / 2;
    height = (height + 1) / 2;
  }
  if (kind_ == TexelLayoutKind::kMipAtlas) {
    place_in_atlas();
  } else if (kind_ == TexelLayoutKind::kKi2007Slices) {
    place_in_slices();
  } else {
    place_level_after_level();
  }
}

void TexelLayout::place_level_after_level() {
  uint64_t end = 0;
  for (int index = 0; index <= root_level(); ++index) {
    Level& level = levels_[index];
    unsigned last_i = static_cast<unsigned>(level.width - 1);
    unsigned last_j = static_cast<unsigned>(level.height - 1);
    level.base = (end + kLevelAlignment - 1) / kLevelAlignment * kLevelAlignment;
    level.pitch = static_cast<uint32_t>(level.width);
    if (kind_ == TexelLayoutKind::kBlocks4x4) level.pitch = static_cast<uint32_t>(level.width + 3) / 4 * 16;
    level.shared_bits = static_cast<int>(std::min(std::bit_width(last_i), std::bit_width(last_j)));
    // All these orders grow with i and with j, so the last texel of a level is its far corner.
    end = offset(index, level.width - 1, level.height - 1) + static_cast<uint64_t>(texel_bytes());
  }
  size_bytes_ = end;
}

void TexelLayout::place_in_atlas() {
  uint32_t pitch = static_cast<uint32_t>(levels_[0].width);
  if (root_level() > 0) pitch += static_cast<uint32_t>(levels_[1].width);
  uint64_t upper_rows = 0;
  for (int index = 0; index <= root_level(); ++index) {
    Level& level = levels_[index];
    level.pitch = pitch;
    if (index == 0) continue;
    level.base = (upper_rows * pitch + static_cast<uint64_t>(levels_[0].width)) << texel_shift_;
    upper_rows += static_cast<uint64_t>(level.height);
  }
  uint64_t rows = std::max(upper_rows, static_cast<uint64_t>(levels_[0].height));
  size_bytes_ = (rows * pitch) << texel_shift_;
}

void TexelLayout::place_in_slices() {
  uint32_t pitch = static_cast<uint32_t>(levels_[0].width);
  uint64_t upper_rows = 0;
  for (int index = 2; index <= root_level(); ++index) {
    upper_rows += static_cast<uint64_t>(levels_[index].height);
  }
  if (root_level() > 1) pitch = std::max(pitch, static_cast<uint32_t>(levels_[1].width + levels_[2].width));
  const uint64_t slice = pitch * std::max(upper_rows, static_cast<uint64_t>(levels_[0].height));
  uint64_t row = 0;
  for (int index = 0; index <= root_level(); ++index) {
    Level& level = levels_[index];
    level.pitch = pitch;
    if (index == 0) continue;
    uint64_t texel = slice;
    if (index > 1) texel += row * pitch + static_cast<uint64_t>(levels_[1].width);
    if (index > 1) row += static_cast<uint64_t>(level.height);
    level.base = texel << texel_shift_;
  }
  size_bytes_ = (2 * slice) << texel_shift_;
}

std::vector<std::byte> TexelLayout::write_image(const Pyramid& pyramid) const {
  bool same = pyramid.root_level() == root_level() && pyramid.width(0) == levels_[0].width &&
              pyramid.height(0) == levels_[0].height && pyramid.texel_bytes() <= texel_bytes();
  if (!same) {
    throw usage_error("A pyramid of " + std::to_string(pyramid.width(0)) + " x " +
                      std::to_string(pyramid.height(0)) + " texels of " +
                      std::to_string(pyramid.texel_bytes()) + " bytes does not fit a layout made for " +
                      std::to_string(levels_[0].width) + " x " + std::to_string(levels_[0].height) +
                      " texels of " + std::to_string(texel_bytes()) + " bytes.");
  }
  std::vector<std::byte> image(size_bytes_);
  const bool scattered = kind_ == TexelLayoutKind::kMorton || kind_ == TexelLayoutKind::kBlocks4x4;
  const auto texel_size = static_cast<size_t>(texel_bytes());
  for (int level = pyramid.lowest_level(); level <= root_level(); ++level) {
    const int width = levels_[level].width;
    const uint16_t* row = pyramid.level(level);
    for (int j = 0; j < levels_[level].height; ++j, row += width) {
      std::byte* const first = image.data() + offset(level, 0, j);
      for (size_t byte = 0; byte < std::min(texel_size, sizeof(*row)); ++byte) {
        const auto part = [&](int i) { return static_cast<std::byte>(row[i] >> (8 * byte) & 0xFF); };
        if (scattered) {
          for (int i = 0; i < width; ++i) image[offset(level, i, j) + byte] = part(i);
        } else {
          for (int i = 0; i < width; ++i) first[static_cast<size_t>(i) * texel_size + byte] = part(i);
        }
      }
    }
  }
  return image;
}

}  // namespace cuesta
