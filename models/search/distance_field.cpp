#include <algorithm>
#include <cmath>

#include "models/search/preprocessing.h"

// A 3-D distance field (Donnelly 2005, reconstructed). The metric is ours: along the map a texel is 1, and full scale
// of height is an eighth of the longer tile side. Layer k stands for the heights [k, k + 1) / 16 of full scale; its
// byte is the distance from the texel's centre at the layer's middle height to the nearest solid column, each column
// standing on its texel's centre: min over texels q of sqrt(|p - q|^2 + max(0, z_k - h_q)^2), heights cut to 1/16
// texel, then rounded down to 1/255 of the slab's height. Exact Euclidean: columns are taken along x, then along y,
// each by the lower envelope of parabolas in integers (Felzenszwalb & Huttenlocher's two passes). No distance exceeds
// the slab's height, the way straight down, so that texels further away than that need not be asked. Samples between
// the points are not safe.

namespace cuesta {
namespace {

constexpr int64_t kPart = 16;  ///< parts of a texel; squares count in 1/256 texel^2

/// out[x] = min over k of values[k] + (kPart (x + margin - k))^2, for x = 0 .. count - 1.
class Envelope {
 public:
  void apply(const std::vector<int64_t>& values, int64_t margin, int count, int64_t* out, int64_t stride) {
    constexpr int64_t kUnit = kPart * kPart;
    feet_.clear();
    from_.clear();
    for (int64_t q = 0; q < static_cast<int64_t>(values.size()); ++q) {
      int64_t begins = 0;
      while (!feet_.empty()) {
        // The last place where the parabola on foot p is not above that of q.
        const int64_t p = feet_.back();
        const int64_t rise = values[at(q)] - values[at(p)] + kUnit * (q * q - p * p);
        const int64_t width = 2 * kUnit * (q - p);
        int64_t last = rise / width;
        if (last * width > rise) --last;
        begins = last + 1;
        if (begins > from_.back()) break;
        feet_.pop_back();
        from_.pop_back();
        begins = 0;
      }
      feet_.push_back(q);
      from_.push_back(begins);
    }
    size_t k = 0;
    for (int64_t x = 0; x < count; ++x) {
      const int64_t place = x + margin;
      while (k + 1 < feet_.size() && from_[k + 1] <= place) ++k;
      const int64_t d = place - feet_[k];
      out[x * stride] = values[at(feet_[k])] + kUnit * d * d;
    }
  }

 private:
  static size_t at(int64_t k) { return static_cast<size_t>(k); }
  std::vector<int64_t> feet_, from_;
};

}  // namespace

Preprocessed make_distance_field(const Pyramid& max_pyramid, AddressMode mode) {
  const int width = max_pyramid.width(0), height = max_pyramid.height(0);
  const int64_t side = std::max(width, height), full = max_pyramid.full_scale();
  const int64_t reach = side / 8 + 1;  // texels
  const size_t texels = static_cast<size_t>(width) * static_cast<size_t>(height);
  // Border mode: nothing lies outside; clamp: the same columns as the edge's, further away.
  const bool tiles = mode == AddressMode::kWrap || mode == AddressMode::kMirror;
  const int64_t margin = tiles ? reach : 0;

  Preprocessed result;
  result.bytes.resize(texels * kDistanceLayers);
  std::vector<int64_t> rows(texels), values;
  Envelope envelope;
  for (int layer = 0; layer < kDistanceLayers; ++layer) {
    // (2 layer + 1) / 32 of full scale above h, in parts of a texel: side / 8 texels are full scale.
    const auto above = [&](int64_t h) {
      const int64_t rise = (2 * layer + 1) * full - 32 * h;
      const int64_t parts = rise > 0 ? rise * side * (kPart / 8) / (32 * full) : 0;
      return parts * parts;
    };
    for (int j = 0; j < height; ++j) {
      values.clear();
      for (int64_t i = -margin; i < width + margin; ++i) {
        values.push_back(above(max_pyramid.at(0, stored_index(i, width, mode), j)));
      }
      result.texels_read += values.size();
      envelope.apply(values, margin, width, rows.data() + static_cast<size_t>(j) * static_cast<size_t>(width),
                     1);
    }
    std::vector<int64_t> column(static_cast<size_t>(height));
    for (int i = 0; i < width; ++i) {
      values.clear();
      for (int64_t j = -margin; j < height + margin; ++j) {
        values.push_back(
            rows[static_cast<size_t>(stored_index(j, height, mode)) * static_cast<size_t>(width) +
                 static_cast<size_t>(i)]);
      }
      result.texels_read += values.size();
      envelope.apply(values, margin, height, column.data(), 1);
      for (int j = 0; j < height; ++j) {
        // The largest byte with byte / 255 * (side * 2 parts) <= the distance.
        const int64_t d2 = column[static_cast<size_t>(j)];
        const int64_t slab = side * (kPart / 8);
        const auto fits = [&](int64_t b) { return b * b * slab * slab <= d2 * 255 * 255; };
        auto byte =
            static_cast<int64_t>(255 * std::sqrt(static_cast<double>(d2)) / static_cast<double>(slab));
        byte = std::min<int64_t>(byte, 255);
        while (byte < 255 && fits(byte + 1)) ++byte;
        while (byte > 0 && !fits(byte)) --byte;
        result.bytes[static_cast<size_t>(layer) * texels +
                     static_cast<size_t>(j) * static_cast<size_t>(width) + static_cast<size_t>(i)] =
            static_cast<uint8_t>(byte);
      }
    }
  }
  return result;
}

}  // namespace cuesta
