#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "models/rays/traced_ray.h"

namespace cuesta {

/// What lies beyond the map: nothing; the map again; the map turned over, and again as it is; its edge texels.
enum class AddressMode : uint8_t { kBorder = 0, kWrap = 1, kMirror = 2, kClamp = 3 };

/// border, wrap, mirror, clamp
inline std::string_view name_of(AddressMode mode) {
  constexpr std::string_view kNames[] = {"border", "wrap", "mirror", "clamp"};
  return kNames[static_cast<size_t>(mode) & 3];
}

/// What the heights of a map mean. Bilinear: patch (i, j) interpolates the heights of texels (i, j) to (i + 1, j + 1),
/// which lie at its corners, so that its frame is the texels' shifted by half a texel.
enum class Surface : uint8_t { kTexel = 0, kBilinear = 1 };

/// texel, bilinear
inline std::string_view name_of(Surface surface) { return surface == Surface::kTexel ? "texel" : "bilinear"; }

enum class Arithmetic : uint8_t { kFixed = 0, kFloat = 1, kDouble = 2 };
inline constexpr std::string_view kArithmeticNames[] = {"fixed", "float", "double"};

/// Widths of the machine's numbers.
struct NumberFormat {
  int fraction_bits = 8;    ///< f: fraction bits of x0, y0 (texels) and z0 (height LSBs), 0 to 12
  int direction_bits = 32;  ///< D: bits of the largest direction component, 8 to 32
  int mantissa_bits = 12;   ///< M: bits of a reciprocal's mantissa, 2 to 24
  int tile_bits = 4;        ///< w2: a ray crosses at most 2^w2 tiles, 0 to 20

  bool operator==(const NumberFormat&) const = default;
};

/// The shape of a map as traversal sees it.
struct MapShape {
  int width = 1;
  int height = 1;
  int root_level = 0;  ///< n: smallest with 2^n >= max(width, height)
  int bits = 8;        ///< B
  AddressMode address_mode = AddressMode::kWrap;
  Surface surface = Surface::kTexel;

  int64_t full_scale() const { return (int64_t{1} << bits) - 1; }
  bool is_square_power_of_two() const { return width == height && width == 1 << root_level; }
};

/// Bits of a time, T = max(n + w2, B) + f + M; times saturate at 2^T - 1, which stands for +infinity.
int time_bits(const MapShape& map, const NumberFormat& format);

/// What enters the hardware: a ray on the machine's grid. The point at time t (real) is
/// (x0 + dx * 2^(q+f) * t) / 2^f texels along u, and alike in v and in height LSBs.
/// One machine time unit is 2^-(f + D - 1 + M + q) of the traced ray's t.
struct MachineRay {
  uint64_t id = 0;
  int64_t x0 = 0, y0 = 0, z0 = 0;  ///< f fraction bits; 0 <= z0 <= (2^B - 1) << f
  int64_t dx = 0, dy = 0, dz = 0;  ///< |d| < 2^D; the largest has its bit D - 1 set
  int64_t t_max = 0;               ///< machine time units, 0 to t_end
  int32_t exponent = 0;            ///< q: a component's value is d * 2^q texels (or LSBs) per unit of t
  bool dead = false;               ///< outside the slab and leaving it: a miss with 0 steps
};

/// Puts a traced ray on the machine's grid; all error of the fixed-point traversal but that of the reciprocals
/// is made here. Pure; in float64 and integers.
/// A primary ray that starts above z = 1 is moved to z = 1; x0, y0, z0 are rounded to nearest even on the 2^-f
/// grid; the direction's largest component is scaled to D bits, the others rounded to nearest even.
/// t_max = min(ceil(traced t_max), t_end, the first time an axis has crossed 2^w2 tiles).
/// Over a bilinear surface x0 and y0 are half a texel less, from here on and nowhere else: f must be 1 at least.
/// Throws input_error naming the ray when a component is not finite, the direction is zero, or the origin
/// does not fit n + w2 + f bits and a sign.
MachineRay quantise(const TracedRay& ray, const MapShape& map, const NumberFormat& format);

}  // namespace cuesta
