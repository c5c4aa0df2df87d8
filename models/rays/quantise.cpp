#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "models/common/error.h"
#include "models/rays/machine_ray.h"

namespace cuesta {

namespace {

/// Round to nearest, ties to even; |v| < 2^62.
int64_t round_to_even(double v) {
  const double magnitude = v < 0 ? -v : v;
  if (magnitude >= 0x1p52) return static_cast<int64_t>(v);
  const double rounded = (magnitude + 0x1p52) - 0x1p52;
  return static_cast<int64_t>(v < 0 ? -rounded : rounded);
}

/// v * 2^exponent, rounded once unless the result is subnormal; any exponent.
double scaled(double v, int exponent) {
  auto power = [](int e) { return std::bit_cast<double>(static_cast<uint64_t>(1023 + e) << 52); };
  for (; exponent > 1000; exponent -= 1000) v *= power(1000);
  for (; exponent < -1000; exponent += 1000) v *= power(-1000);
  return v * power(exponent);
}

/// floor(log2(v)) of a positive finite v.
int exponent_of(double v) {
  int extra = 0;
  if (v < 0x1p-1000) {
    v *= 0x1p200;
    extra = -200;
  }
  return static_cast<int>(std::bit_cast<uint64_t>(v) >> 52) - 1023 + extra;
}

[[noreturn]] void refuse(const TracedRay& ray, const std::string& why) {
  throw input_error("ray " + std::to_string(ray.id) + ": " + why);
}

void check(const TracedRay& ray) {
  static const char* const axis = "uvz";
  for (int a = 0; a < 3; ++a) {
    if (!std::isfinite(ray.origin[a])) refuse(ray, std::string("origin ") + axis[a] + " is not finite");
    if (!std::isfinite(ray.direction[a])) refuse(ray, std::string("direction ") + axis[a] + " is not finite");
  }
  if (ray.direction[0] == 0 && ray.direction[1] == 0 && ray.direction[2] == 0) {
    refuse(ray, "the direction is zero");
  }
  if (std::isnan(ray.t_min) || std::isnan(ray.t_max) || std::isinf(ray.t_min)) {
    refuse(ray, "t_min must be finite and t_max a number");
  }
}

/// The direction in texels and LSBs as integers of D bits; returns the shared exponent q.
int quantise_direction(const double (&direction)[3], const double (&scale)[3], int bits, int64_t (&out)[3]) {
  // First to the neighbourhood of 1, so that no product overflows: powers of two, exact.
  double largest = 0;
  for (double d : direction) largest = std::max(largest, d < 0 ? -d : d);
  const int first = -exponent_of(largest);
  double texels[3];
  double top = 0;
  for (int a = 0; a < 3; ++a) {
    texels[a] = scaled(direction[a], first) * scale[a];
    top = std::max(top, texels[a] < 0 ? -texels[a] : texels[a]);
  }
  int second = bits - 1 - exponent_of(top);
  if (round_to_even(scaled(top, second)) >> bits != 0) --second;
  for (int a = 0; a < 3; ++a) out[a] = round_to_even(scaled(texels[a], second));
  return -(first + second);
}

/// When an axis moving by |d| has crossed 2^w2 tiles of `size` texels.
int64_t tile_limit(int64_t size, int64_t d, const NumberFormat& format, int64_t t_end) {
  if (d == 0) return t_end;
  using Wide = unsigned __int128;
  const Wide distance = static_cast<Wide>(size) << (format.tile_bits + format.fraction_bits);
  const Wide time =
      (distance << (format.direction_bits - 1 + format.mantissa_bits)) / static_cast<Wide>(d < 0 ? -d : d);
  return time > static_cast<Wide>(t_end) ? t_end : static_cast<int64_t>(time);
}

}  // namespace

int time_bits(const MapShape& map, const NumberFormat& format) {
  return std::max(map.root_level + format.tile_bits, map.bits) + format.fraction_bits + format.mantissa_bits;
}

MachineRay quantise(const TracedRay& ray, const MapShape& map, const NumberFormat& format) {
  check(ray);
  const int f = format.fraction_bits;
  const double full_scale = static_cast<double>(map.full_scale());
  const double scale[3] = {static_cast<double>(map.width), static_cast<double>(map.height), full_scale};
  MachineRay out;
  out.id = ray.id;

  double origin[3];
  double t_max = ray.t_max;
  double skipped = ray.t_min > 0 ? ray.t_min : 0;
  if (ray.fixed_axis == FixedAxis::kNone && ray.origin[2] + skipped * ray.direction[2] > 1 &&
      ray.direction[2] < 0) {
    skipped = (ray.origin[2] - 1) / -ray.direction[2];
    for (int a = 0; a < 2; ++a) origin[a] = ray.origin[a] + skipped * ray.direction[a];
    origin[2] = 1;
  } else {
    for (int a = 0; a < 3; ++a) origin[a] = ray.origin[a] + skipped * ray.direction[a];
  }
  t_max -= skipped;
  // A secondary ray starts on the surface: what of its height lies outside the slab is rounding, and is clamped.
  const bool outside = ray.fixed_axis == FixedAxis::kNone && (origin[2] > 1 || origin[2] < 0);
  out.dead = outside || !(t_max > 0);

  int64_t* const place[3] = {&out.x0, &out.y0, &out.z0};
  for (int a = 0; a < 3; ++a) {
    const double inside = a < 2 ? origin[a] : std::clamp(origin[a], 0.0, 1.0);
    const double position = scaled(inside * scale[a], f);
    const int bits = map.root_level + format.tile_bits + f;
    if (a < 2 && !(position < scaled(1, bits) && position > -scaled(1, bits))) {
      refuse(ray, std::string("origin ") + "uv"[a] + " = " + std::to_string(origin[a]) +
                      " tiles lies outside the " + std::to_string(int64_t{1} << format.tile_bits) +
                      " tiles that traverse.tile_bits = " + std::to_string(format.tile_bits) +
                      " can hold; more tile_bits hold more");
    }
    *place[a] = out.dead && a == 2 ? 0 : round_to_even(position);
  }
  if (ray.fixed_axis != FixedAxis::kNone) {
    const int a = static_cast<int>(ray.fixed_axis) - 1;
    const int64_t fixed = ray.fixed_coordinate;
    const int64_t most = a == 2 ? map.full_scale() : int64_t{1} << (map.root_level + format.tile_bits);
    if (fixed > most || fixed < (a == 2 ? 0 : -most)) {
      refuse(ray, std::string("its fixed coordinate ") + "uvz"[a] + " = " + std::to_string(fixed) +
                      " lies outside the map's " + (a == 2 ? "heights" : "tiles") + ", at most " +
                      std::to_string(most));
    }
    *place[a] = fixed << f;
  }
  if (map.surface == Surface::kBilinear) {
    const int64_t half_texel = (int64_t{1} << f) >> 1;
    out.x0 -= half_texel;
    out.y0 -= half_texel;
  }

  int64_t d[3];
  out.exponent = quantise_direction(ray.direction, scale, format.direction_bits, d);
  out.dx = d[0];
  out.dy = d[1];
  out.dz = d[2];

  const int64_t t_end = (int64_t{1} << time_bits(map, format)) - 1;
  out.t_max =
      std::min(tile_limit(map.width, out.dx, format, t_end), tile_limit(map.height, out.dy, format, t_end));
  const double traced =
      t_max <= 0
          ? 0
          : scaled(t_max, std::clamp(f + format.direction_bits - 1 + format.mantissa_bits + out.exponent,
                                     -4000, 4000));
  if (traced < static_cast<double>(out.t_max)) {
    const int64_t whole = static_cast<int64_t>(traced);
    out.t_max = std::min(out.t_max, whole + (static_cast<double>(whole) < traced ? 1 : 0));
  }
  return out;
}

}  // namespace cuesta
