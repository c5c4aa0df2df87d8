#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "models/algorithms/search.h"
#include "models/rays/machine_ray.h"
#include "models/search/search_map.h"

// Pyramidal displacement mapping and quadtree displacement mapping as their listings have them, in float, with the
// faults that come with it: what a robust traversal is worth is measured against this. Nothing is repaired.

namespace cuesta {

enum class PrintedEnd : uint8_t {
  kFound,         ///< the loop ended; the listings take whatever place it has reached for the hit
  kNotANumber,    ///< the place is NaN, infinite, or beyond what a hit record can hold
  kDidNotFinish,  ///< given up after `Search::steps` passes of the loop
};

/// A place in texture coordinates (unwrapped) and depths of the slab below the top plane.
struct PrintedPlace {
  float x = 0, y = 0, z = 0;
};

struct PrintedFound {
  PrintedEnd end = PrintedEnd::kDidNotFinish;
  PrintedPlace place;
  int64_t i = 0, j = 0;  ///< of kFound: the texel of that place, unwrapped
};

/// What a listing starts with: P on the top plane and E, scaled so that E.z = 1; and `start`, the depth at which P2
/// starts, 0 in the listings.
struct PrintedRay {
  PrintedPlace from, along;
  float start = 0;
};

/// Of a descending ray. For one that starts inside the slab, which the listings do not know, P is where its line
/// meets the top plane, and P2 where it starts (ours).
PrintedRay make_printed_ray(const MachineRay& input, const MapShape& map, const NumberFormat& format);

namespace printed_detail {

inline PrintedPlace moved(const PrintedPlace& from, const PrintedPlace& along, float distance) {
  return {from.x + along.x * distance, from.y + along.y * distance, from.z + along.z * distance};
}

/// min(a, b) of shaders: of a number and NaN the number.
inline float shader_min(float a, float b) { return a < b || b != b ? a : b; }

/// (sign(x) + 1) / 2
inline float dir_sign(float x) { return x > 0 ? 1.0F : x < 0 ? 0.0F : 0.5F; }

inline float floor_of_float(float x) {
  if (!(std::abs(x) < 8388608.0F)) return x;  // whole already, infinite or NaN
  const auto k = static_cast<float>(static_cast<int32_t>(x));
  return k > x ? k - 1 : k;
}

/// 2^e, 0 below float's normal numbers.
inline float power_of_two(int e) {
  return e < -126 ? 0.0F : std::bit_cast<float>(static_cast<uint32_t>(e + 127) << 23);
}

/// The texel of a repeated axis; a place that is no number reads texel 0, as any texel would do.
inline int repeated(float whole, int size) {
  if (!(std::abs(whole) < 0x1p62F)) return 0;
  return static_cast<int>(static_cast<int64_t>(whole) & (size - 1));
}

/// The map as tex2Dlod reads it: depths below the top plane, repeated.
template <class Sink>
class PrintedTexture {
 public:
  PrintedTexture(const SearchMap& map, Sink& sink)
      : map_(&map), sink_(&sink), root_(map.root_level()), full_(static_cast<float>((1 << map.bits()) - 1)) {}

  /// The nearest texel of a level, which is clamped to those that there are.
  float nearest(const PrintedPlace& p, int level) {
    const int clamped = level < 0 ? 0 : level > root_ ? root_ : level, size = 1 << (root_ - clamped);
    const auto scale = static_cast<float>(size);
    return depth(clamped, repeated(floor_of_float(p.x * scale), size),
                 repeated(floor_of_float(p.y * scale), size));
  }
  /// Between the centres of level 0's texels.
  float between(const PrintedPlace& p) {
    const int size = 1 << root_;
    const auto scale = static_cast<float>(size);
    const float u = p.x * scale - 0.5F, v = p.y * scale - 0.5F;
    const float i = floor_of_float(u), j = floor_of_float(v);
    const int i0 = repeated(i, size), i1 = (i0 + 1) & (size - 1);
    const int j0 = repeated(j, size), j1 = (j0 + 1) & (size - 1);
    const float d00 = depth(0, i0, j0), d10 = depth(0, i1, j0), d01 = depth(0, i0, j1),
                d11 = depth(0, i1, j1);
    const float low = d00 + (d10 - d00) * (u - i), high = d01 + (d11 - d01) * (u - i);
    return low + (high - low) * (v - j);
  }

 private:
  float depth(int level, int i, int j) {
    sink_->read(map_->offset_at(level, i, j));
    return (full_ - static_cast<float>(map_->node_at(level, i, j))) / full_;
  }

  const SearchMap* map_;
  Sink* sink_;
  int root_;
  float full_;
};

/// How far the ray is along the plane, in the listing's words: length(P2.xy - P.xy).
inline float ray_length(const PrintedPlace& p, const PrintedPlace& from) {
  const float x = p.x - from.x, y = p.y - from.y;
  return std::sqrt(x * x + y * y);
}

}  // namespace printed_detail

/// ki2007-printed: Ki & Oh 2007, sections 2.2 and 2.3, printed. Each pass reads one texel of the current level; where
/// the ray is above it, it moves to the texel's height, or, if that lies in another node, to the node's boundary and
/// `delta` on; then it goes down a level, or stays after a crossing (their text has it go up; level++ and the loop's
/// level-- cancel). With `linear`, section 2.4, printed: at a leaf half a texel ahead is read, filtered; while the
/// ray is above that it goes on from there; in the end one secant between half a texel before and after, with the
/// listing's weights, which its text contradicts. (`P2.b.z` is read as `P2b.z`.)
///
/// drobot2009-printed, reconstructed from public copies of the talk's pseudo code (GDC 2010) and a public adaptation of
/// the article's sample: the same loop, but a crossing never goes beyond the texel's height, d = min(d, boundary), and
/// always goes up one level, without a limit: above the root a node is 2, 4 ... repetitions of the map. The delta is
/// the adaptation's, as Ki & Oh's; the pseudo code has none, and takes the boundary's distance without its sign.
///
/// With `slope` (ours) the boundary is b / E.xy away, the same without 0 / 0, in the place of (b * P2.z) / a; an axis
/// along which the ray does not move has none.
/// A step is one pass, with one read; a division as printed takes a slot of arithmetic before the next step. A
/// filtered sample is a step with four reads. min(x, NaN) = x, as shaders have it. `delta`: in depths of the slab.
template <class Sink>
PrintedFound printed_search(const Search& search, const PrintedRay& ray, const SearchMap& map, float delta,
                            Sink& sink) {
  using namespace printed_detail;
  const PrintedPlace P = ray.from, E = ray.along;
  const bool drobot = search.kind == SearchKind::kDrobot2009Printed;
  PrintedTexture<Sink> texture(map, sink);
  const int max_level = map.root_level();
  const float texel_span_half = 0.5F / static_cast<float>(1 << max_level);
  PrintedPlace P2 = moved(P, E, ray.start);
  PrintedFound found;
  int level = max_level;
  for (int pass = 0; level >= 0; ++pass) {
    if (pass == search.steps) return found;
    float d = texture.nearest(P2, level);
    sink.end_step();
    if (d > P2.z) {
      const PrintedPlace predicted = moved(P, E, d);
      const float count = power_of_two(max_level - level);
      const float node_x = floor_of_float(P2.x * count), node_y = floor_of_float(P2.y * count);
      const float test_x = std::abs(node_x - floor_of_float(predicted.x * count));
      const float test_y = std::abs(node_y - floor_of_float(predicted.y * count));
      if (test_x + test_y > 0.001F) {
        const float span = 1.0F / count;
        const float a_x = P2.x - P.x, a_y = P2.y - P.y;
        const float b_x = (node_x + dir_sign(E.x)) * span - P.x;
        const float b_y = (node_y + dir_sign(E.y)) * span - P.y;
        float boundary;
        if (search.slope) {
          const float far = std::numeric_limits<float>::infinity();
          boundary = shader_min(E.x != 0 ? b_x / E.x : far, E.y != 0 ? b_y / E.y : far);
        } else {
          sink.compute();
          boundary = shader_min((b_x * P2.z) / a_x, (b_y * P2.z) / a_y);
        }
        d = (drobot ? shader_min(d, boundary) : boundary) + delta;
        level += drobot ? 2 : 1;
      }
      P2 = moved(P, E, d);
    }
    if (search.linear && level <= 0) {
      const float length = ray_length(P2, P);
      sink.compute();
      const PrintedPlace ahead = moved(P, E, P2.z * (length + texel_span_half) / length);
      const float depth = texture.between(ahead);
      sink.end_step();
      if (depth > ahead.z) {
        P2 = ahead;
        ++level;
      }
    }
    --level;
  }
  if (search.linear) {
    const float length = ray_length(P2, P);
    const PrintedPlace a = moved(P, E, P2.z * (length - texel_span_half) / length);
    const PrintedPlace b = moved(P, E, P2.z * (length + texel_span_half) / length);
    sink.compute();
    const float la = std::abs(a.z - texture.between(a));
    sink.end_step();
    const float lb = std::abs(b.z - texture.between(b));
    sink.end_step();
    const float weight = la / (la + lb);
    P2 = {a.x + (b.x - a.x) * weight, a.y + (b.y - a.y) * weight, a.z + (b.z - a.z) * weight};
  }
  found.place = P2;
  found.end = PrintedEnd::kNotANumber;
  const auto size = static_cast<float>(1 << max_level);
  const float i = floor_of_float(P2.x * size), j = floor_of_float(P2.y * size);
  // False for NaN, too.
  if (!(std::abs(i) < 0x1p30F && std::abs(j) < 0x1p30F && std::abs(P2.z) < 0x1p30F)) return found;
  found.end = PrintedEnd::kFound;
  found.i = static_cast<int64_t>(i);
  found.j = static_cast<int64_t>(j);
  return found;
}

}  // namespace cuesta
