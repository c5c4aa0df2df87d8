#include "models/oracle/traced_ray.h"

#include <algorithm>
#include <cmath>

namespace cuesta {
namespace {

constexpr int kMostShift = 360;

/// v = whole * 2^exponent, whole odd or 0.
struct Dyadic {
  int64_t whole = 0;
  int exponent = 0;
};

Dyadic dyadic(double v) {
  if (v == 0) return {};
  int exponent = 0;
  auto whole = static_cast<int64_t>(std::ldexp(std::frexp(v, &exponent), 53));
  exponent -= 53;
  for (; whole % 2 == 0; whole /= 2) ++exponent;
  return {whole, exponent};
}

BigInt shifted(const Dyadic& v, int shift) { return BigInt(BigInt(v.whole) << (v.exponent + shift)); }

}  // namespace

std::optional<ExactRay<BigInt>> exact_traced_ray(const TracedRay& traced, const MapShape& map,
                                                 const NumberFormat& format, bool dead) {
  const int64_t size[3] = {map.width, map.height, map.full_scale()};
  Dyadic origin[3], direction[3];
  int shift = 0;
  for (int a = 0; a < 3; ++a) {
    // A secondary ray starts on the surface: what of its height lies outside the slab is rounding.
    const bool on_surface = a == 2 && traced.fixed_axis != FixedAxis::kNone;
    origin[a] = dyadic(on_surface ? std::clamp(traced.origin[a], 0.0, 1.0) : traced.origin[a]);
    direction[a] = dyadic(traced.direction[a]);
    shift = std::max({shift, -origin[a].exponent, -direction[a].exponent});
  }
  const bool limited = std::isfinite(traced.t_max);
  const Dyadic t_max = limited ? dyadic(traced.t_max) : Dyadic{};
  shift = std::max(shift, -t_max.exponent);
  for (const Dyadic& v : {origin[0], origin[1], origin[2], direction[0], direction[1], direction[2], t_max}) {
    if (v.exponent + shift > kMostShift) return std::nullopt;
  }

  const BigInt one = BigInt(1) << shift;
  ExactRay<BigInt> ray;
  ray.dead = dead;
  ray.t_max = limited ? ExactTime<BigInt>{shifted(t_max, shift), one} : ExactTime<BigInt>::infinity();
  ExactAxis<BigInt>* const axes[3] = {&ray.x, &ray.y, &ray.z};
  for (int a = 0; a < 3; ++a) {
    ExactAxis<BigInt>& axis = *axes[a];
    axis.sign = direction[a].whole < 0 ? -1 : direction[a].whole > 0 ? 1 : 0;
    axis.unit = one;
    axis.origin = BigInt(shifted(origin[a], shift) * size[a]);
    if (static_cast<int>(traced.fixed_axis) == a + 1) axis.origin = BigInt(one * traced.fixed_coordinate);
    if (a < 2 && axis.sign < 0) axis.origin = BigInt(one * size[a] - axis.origin);
    if (axis.sign == 0) continue;
    const BigInt speed = shifted(direction[a], shift);
    axis.den = BigInt((axis.sign < 0 ? BigInt(-speed) : speed) * size[a]);
  }
  // 2^w2 tiles from where the ray starts: where it comes down through the slab's top, if it begins above.
  ExactTime<BigInt> start{BigInt(0), BigInt(1)};
  if (ray.z.sign < 0) start = later(start, ray.z.reaches(size[2]));
  for (int a = 0; a < 2; ++a) {
    if (axes[a]->sign == 0) continue;
    const BigInt distance = BigInt((one << format.tile_bits) * size[a]);
    ray.t_max = earlier(ray.t_max, ExactTime<BigInt>{BigInt(start.num * axes[a]->den + distance * start.den),
                                                     BigInt(start.den * axes[a]->den)});
  }
  return ray;
}

BigInt machine_units_of(const NumberFormat& format, int exponent) {
  const int unit = format.fraction_bits + format.direction_bits - 1 + format.mantissa_bits + exponent;
  return unit >= 0 ? BigInt(BigInt(1) << unit) : BigInt(1);
}

}  // namespace cuesta
