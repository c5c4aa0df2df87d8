#include "models/search/search_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <utility>

#include "models/common/error.h"
#include "models/search/preprocessing.h"

namespace cuesta {
namespace {

/// Unit normals of the surface by central differences through the address mode, as an RGB8 normal map has them;
/// slopes in full scales per longer tile side.
std::vector<uint8_t> make_normals(const Pyramid& pyramid, AddressMode mode) {
  const int width = pyramid.width(0), height = pyramid.height(0);
  const double scale = 0.5 * std::max(width, height) / pyramid.full_scale();
  const auto at = [&](int64_t i, int64_t j) {
    return static_cast<double>(pyramid.at(0, stored_index(i, width, mode), stored_index(j, height, mode)));
  };
  const auto byte = [](double n) { return static_cast<uint8_t>((510 * ((n + 1) / 2) + 1) / 2); };
  std::vector<uint8_t> normals;
  normals.reserve(3 * static_cast<size_t>(width) * static_cast<size_t>(height));
  for (int64_t j = 0; j < height; ++j) {
    for (int64_t i = 0; i < width; ++i) {
      const double x = (at(i - 1, j) - at(i + 1, j)) * scale, y = (at(i, j - 1) - at(i, j + 1)) * scale;
      const double length = std::sqrt(x * x + y * y + 1);
      normals.insert(normals.end(), {byte(x / length), byte(y / length), byte(1 / length)});
    }
  }
  return normals;
}

}  // namespace

SearchMap::SearchMap(const Search& search, const Pyramid& max_pyramid, AddressMode mode)
    : pyramid_(&max_pyramid),
      heights_(max_pyramid.level(0)),
      width_(max_pyramid.width(0)),
      height_(max_pyramid.height(0)),
      mode_(mode),
      record_bytes_(max_pyramid.texel_bytes()) {
  const auto take = [this](Preprocessed&& made) {
    added_ = std::move(made.bytes);
    cost_.texels_read = made.texels_read;
  };
  const auto texel_bytes = static_cast<uint64_t>(max_pyramid.texel_bytes());
  switch (search.kind) {
    case SearchKind::kNormal:
      added_ = make_normals(max_pyramid, mode);
      record_bytes_ = 3;
      cost_.texels_read = 4 * texels();
      break;
    case SearchKind::kCone:
      take(make_cone_map(max_pyramid, mode));
      ++record_bytes_;
      break;
    case SearchKind::kRelaxedCone:
      take(make_relaxed_cone_map(max_pyramid, mode));
      ++record_bytes_;
      break;
    case SearchKind::kSafetyRadius:
      take(make_safety_radii(max_pyramid, mode));
      ++record_bytes_;
      break;
    case SearchKind::kDistance:
      take(make_distance_field(max_pyramid, mode));
      record_bytes_ = 1;
      layers_ = kDistanceLayers;
      break;
    case SearchKind::kKi2007Printed:
    case SearchKind::kDrobot2009Printed:
      check_map(search, width_, height_, mode);
      image_.emplace(TexelLayoutKind::kRowMajor, max_pyramid);
      return;
    default:
      return;  // the height grid itself
  }
  record_bytes_ = static_cast<int>(std::bit_ceil(static_cast<unsigned>(record_bytes_)));
  cost_.records_written = texels() * static_cast<uint64_t>(layers_);
  cost_.bytes = cost_.texels_read * texel_bytes + size_bytes();
}

void check_map(const Search& search, int width, int height, AddressMode mode) {
  if (!is_printed(search.kind)) return;
  if (mode == AddressMode::kWrap && width == height && std::has_single_bit(static_cast<unsigned>(width)))
    return;
  throw usage_error(name_of(search) +
                    " reads its map as the listing's repeated texture of 2^n x 2^n texels, and the map is " +
                    std::to_string(width) + " x " + std::to_string(height) + " texels, " +
                    std::string(name_of(mode)) +
                    "; accepted are square powers of two with address mode wrap.");
}

}  // namespace cuesta
