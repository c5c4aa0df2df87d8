#include "sim/explore/precision/precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "models/common/elementary.h"
#include "models/common/error.h"
#include "models/common/random.h"
#include "models/common/statistics.h"
#include "models/heightmap/generator.h"
#include "models/rays/hit_time.h"
#include "models/traversal/traversal.h"
#include "sim/explore/precision/exact_skipping_walk.h"
#include "sim/explore/precision/half_precision.h"
#include "sim/explore/study/plan_parts.h"

namespace cuesta {
namespace {

using namespace precision;

constexpr std::string_view kName = "precision";
constexpr int kReliefSide = 256;
constexpr int kRays = 512;  // of a case
constexpr double kDepth = 0.1;
constexpr int kErrorBits = 40;  // fraction bits of an error in height LSBs, before it is rounded for the file

/// The finest grid on which a ray can enter.
constexpr NumberFormat kFinest = {12, 32, 12, kTileBits};

/// What a value of the axis `format` stands for.
struct Format {
  Arithmetic arithmetic = Arithmetic::kFixed;
  NumberFormat number;
  bool half_heights = false;
};

int number_after(const std::string& name, const char* key) {
  int value = 0;
  const size_t at = name.find(key);
  if (at != std::string::npos)
    std::from_chars(name.data() + at + std::char_traits<char>::length(key), name.data() + name.size(), value);
  return value;
}

Format format_of(const std::string& name, int bits) {
  Format format;
  format.half_heights = name.ends_with(kHalf);
  if (name.starts_with("double") || name.starts_with("float")) {
    format.arithmetic = name.starts_with("double") ? Arithmetic::kDouble : Arithmetic::kFloat;
    format.number = kFinest;
  } else {
    format.number = {number_after(name, "f"), number_after(name, "D"), bits + number_after(name, "M+"),
                     kTileBits};
  }
  return format;
}

/// Repeats the texels of a small map `scale` times along both sides: the same relief in finer texels.
HeightGrid magnified(const HeightGrid& small, int scale) {
  HeightGrid grid;
  grid.width = small.width * scale;
  grid.height = small.height * scale;
  grid.bits = small.bits;
  grid.texels.reserve(pyramid_storage(grid.width, grid.height));
  for (int j = 0; j < grid.height; ++j) {
    const uint16_t* row = small.texels.data() + static_cast<size_t>(j / scale) * small.width;
    for (int i = 0; i < small.width; ++i)
      grid.texels.insert(grid.texels.end(), static_cast<size_t>(scale), row[i]);
  }
  return grid;
}

/// Splits v = whole * 2^exponent.
std::pair<int64_t, int> as_dyadic(double v) {
  int exponent = 0;
  const auto whole = static_cast<int64_t>(std::ldexp(std::frexp(v, &exponent), 53));
  return {whole, exponent - 53};
}

/// Gives when a record says that its ray has hit, in units of the traced ray's t.
ExactTime<BigInt> found_time(const HitRecord& record, const Format& format, int exponent) {
  const NumberFormat& number = format.number;
  ExactTime<BigInt> t{BigInt(record.t), machine_units_of(number, exponent)};
  if (format.arithmetic == Arithmetic::kFixed) return t;
  const auto [whole, binary] = as_dyadic(recorded_time(record, format.arithmetic));
  const int shift = binary + number.fraction_bits + number.direction_bits - 1 + number.mantissa_bits;
  t.num = BigInt(whole) << std::max(shift, 0);
  t.den = BigInt(t.den << std::max(-shift, 0));
  return t;
}

/// Measures how far apart two times are along a ray, as a difference in height: height LSBs.
double height_between(const ExactRay<BigInt>& ray, const ExactTime<BigInt>& a, const ExactTime<BigInt>& b) {
  BigInt apart = BigInt(a.num * b.den) - BigInt(b.num * a.den);
  if (apart < 0) apart = -apart;
  const BigInt parts = BigInt(BigInt(apart * ray.z.den) << kErrorBits) /
                       BigInt(BigInt(a.den * b.den) * BigInt(ray.z.num * ray.z.unit));
  const BigInt most = BigInt(1) << 52;
  return std::ldexp(static_cast<double>(static_cast<int64_t>(parts < most ? parts : most)), -kErrorBits);
}

/// Gives the largest, the 99th percentile and the root mean square, in parts.
std::array<int64_t, 3> spread_of(const std::vector<double>& errors) {
  if (errors.empty()) return {0, 0, 0};
  std::vector<int64_t> parts;
  double squares = 0;
  for (const double error : errors) {
    parts.push_back(std::llround(error * kParts));
    squares += error * error;
  }
  const Histogram histogram = make_histogram("error", std::move(parts));
  return {histogram.max, histogram.p99,
          std::llround(std::sqrt(squares / static_cast<double>(errors.size())) * kParts)};
}

class PrecisionRunner : public CaseRunner {
 public:
  PrecisionRunner(const StudyData& plan, std::span<const uint16_t> size_and_bits) : plan_(plan) {
    StudyPlace place(size_and_bits.begin(), size_and_bits.end());
    const int side = static_cast<int>(number_at(plan, place, "size"));
    const int bits = static_cast<int>(number_at(plan, place, "bits"));
    pyramid_ = build_max_pyramid(
        magnified(generate("fractal", kReliefSide, kReliefSide, bits, 1), side / kReliefSide));
    map_ = {side, side, pyramid_.root_level(), bits, AddressMode::kWrap};
    for (int level = 0; level <= pyramid_.root_level(); ++level) {
      OracleMap& view = levels_.emplace_back();
      view.values = pyramid_.level(level);
      view.width = pyramid_.width(level);
      view.height = pyramid_.height(level);
      view.level = level;
      view.highest = pyramid_.highest();
      view.shape = map_;
    }
  }

  std::vector<int64_t> run(const StudyPlace& place) override {
    make_rays(place);
    const Format format = format_of(
        plan_.axes[axis_index(plan_, "format")].values[place[axis_index(plan_, "format")]], map_.bits);
    int64_t same = 0, earlier_cell = 0, later_cell = 0, missed = 0, strayed = 0;
    std::vector<double> all, all_texels, top, top_texels, wall, wall_texels;
    for (const Ray& ray : rays_) {
      const MachineRay input = quantise(ray.traced, map_, format.number);
      const HitRecord found = walk(format, input);
      if (found.status != HitStatus::kHit) {
        ++missed;
        continue;
      }
      const ExactTime<BigInt> t = found_time(found, format, input.exponent);
      const double error = height_between(ray.exact, t, ray.truth.t), texels = error * ray.texels_per_lsb;
      all.push_back(error);
      all_texels.push_back(texels);
      strayed += error > 1 && texels > 1;
      if (found.i != ray.truth.i || found.j != ray.truth.j) {
        ++(t < ray.truth.t ? earlier_cell : later_cell);
        continue;
      }
      ++same;
      if (found.face != ray.truth.face) continue;  // at an edge: its error is in that of all rays
      const bool on_top = ray.truth.face == HitFace::kTop;
      (on_top ? top : wall).push_back(error);
      (on_top ? top_texels : wall_texels).push_back(texels);
    }
    const auto of_all = spread_of(all), of_all_texels = spread_of(all_texels);
    const auto of_top = spread_of(top), of_wall = spread_of(wall_texels);
    return {static_cast<int64_t>(rays_.size()),
            same,
            earlier_cell,
            later_cell,
            missed,
            strayed,
            of_all[0],
            of_all[1],
            of_all_texels[0],
            of_all_texels[1],
            static_cast<int64_t>(top.size()),
            of_top[0],
            of_top[1],
            of_top[2],
            spread_of(top_texels)[0],
            static_cast<int64_t>(wall.size()),
            of_wall[0],
            of_wall[1],
            of_wall[2],
            spread_of(wall)[0]};
  }

 private:
  struct Ray {
    TracedRay traced;
    ExactRay<BigInt> exact;
    OracleHit<BigInt> truth;
    double texels_per_lsb = 0;  ///< along the ray
  };

  /// Makes the rays of the place's angle and finds what they truly hit, once for all formats.
  void make_rays(const StudyPlace& place) {
    const double degrees = number_at(plan_, place, "angle");
    if (degrees == degrees_) return;
    degrees_ = degrees;
    rays_.clear();
    Random random(11);
    const double angle = degrees * 3.14159265358979323846 / 180;
    for (int k = 0; k < kRays; ++k) {
      Ray& ray = rays_.emplace_back();
      ray.traced.id = static_cast<uint64_t>(k);
      ray.traced.origin[0] = random.unit();
      ray.traced.origin[1] = random.unit();
      ray.traced.origin[2] = 1;
      const double turn = random.unit() * 6.283185307179586;
      double* const d = ray.traced.direction;
      d[0] = degrees == 0 ? 0 : elementary::sin(angle) * elementary::cos(turn);
      d[1] = degrees == 0 ? 0 : elementary::sin(angle) * elementary::sin(turn);
      d[2] = -elementary::cos(angle) / kDepth;
      ray.texels_per_lsb = std::sqrt(d[0] * d[0] + d[1] * d[1]) * map_.width /
                           (-d[2] * static_cast<double>(map_.full_scale()));
      const auto exact = exact_traced_ray(ray.traced, map_, kFinest, false);
      if (!exact) throw Error(ExitCode::kMismatch, "A ray of study precision has no exact form.");
      ray.exact = *exact;
      ray.truth = exact_skipping_walk(ray.exact, levels_);
      if (!ray.truth.hit) throw Error(ExitCode::kMismatch, "A ray of study precision hits nothing.");
    }
  }

  HitRecord walk(const Format& format, const MachineRay& input) const {
    return with_traversal_types(format.arithmetic, map_, [&]<class A, class G>() {
      const int64_t full = map_.full_scale(), highest = pyramid_.highest();
      const auto stored = [&](int64_t height) {
        return format.half_heights ? in_half_precision(height, full) : height;
      };
      const Walk<A, G> rules(map_, format.number, find_algorithm("yun2013")->schedule,
                             static_cast<int32_t>(stored(highest)));
      return traverse_ray(rules, input, [&](int level, int64_t i, int64_t j) -> int64_t {
        return stored(pyramid_.at(level, static_cast<int>(i), static_cast<int>(j)));
      });
    });
  }

  const StudyData& plan_;
  Pyramid pyramid_;
  MapShape map_;
  std::vector<OracleMap> levels_;
  std::vector<Ray> rays_;
  double degrees_ = -1;  ///< of rays_
};

std::vector<std::string> formats(bool quick) {
  std::vector<std::string> names = {"double", "float", std::string("double") + kHalf,
                                    default_format() + kHalf};
  if (quick) {
    for (const int m : {0, 2, 4}) names.push_back(fixed_format(8, m, 32));
    names.push_back(fixed_format(4, 4, 16));
    return names;
  }
  for (const int f : kFractionBits) {
    for (const int m : kMantissaBits) {
      for (const int d : kDirectionBits) names.push_back(fixed_format(f, m, d));
    }
  }
  return names;
}

StudyData make_plan(bool quick) {
  StudyData plan = begin_plan(
      kName, "How far from the truth does each format of numbers put a hit, and how narrow may one be?",
      quick);
  plan.conditions = {
      "Truth: what the ray as traced hits, in rational arithmetic, before anything is rounded. A format's "
      "hit is held against it end to end: the ray's quantisation, its reciprocals, the traversal.",
      fmt::format(
          "Rays: {} a case, random in place and azimuth, from the top of the slab, on an endless plane "
          "of tiles (wrap), {} tiles deep: every ray truly hits. An axis-aligned or otherwise special "
          "ray is not among them.",
          kRays, kDepth),
      fmt::format("Map: the generator's fractal of {0} x {0} texels, seed 1, every texel repeated size / {0} "
                  "times along both sides: the same relief in ever finer texels.",
                  kReliefSide),
      "An error is how far along the ray a hit lies from the true place. In the true cell: of a hit on a "
      "texel's top as a difference in height, of one on its wall as a distance in the plane. A hit in "
      "another cell may be as near: it has strayed if it is more than a height LSB and more than a texel "
      "away.",
      fmt::format("Fixed point: f fraction bits of places, M bits of a reciprocal's mantissa, D bits of the "
                  "largest direction component, w2 = {}. Times have T = max(n + w2, B) + f + M bits (2^n "
                  "texels a side). w2 is no matter of precision: a ray crosses at most 2^w2 tiles, and each "
                  "bit more is a bit of T once n + w2 > B.",
                  kTileBits),
      fmt::format("double and float traverse the ray on the finest grid that can enter, f = {} and D = {}. "
                  "Half heights: texels are stored in IEEE half precision, as fractions of 2^B, so that "
                  "heights to 11 bits are exact; the error is against the map as it was. A height that would "
                  "be rounded above full scale is stored as the largest below.",
                  kFinest.fraction_bits, kFinest.direction_bits)};
  plan.axes = {
      {"size", "texels", "Side of the square map.",
       quick ? std::vector<std::string>{"256"} : std::vector<std::string>{"256", "1024", "4096", "16384"}},
      {"bits", "bits", "B, of a height.",
       quick ? std::vector<std::string>{"8"} : std::vector<std::string>{"8", "16"}},
      {"angle", "degrees", "Between the rays and the surface's normal.",
       quick ? std::vector<std::string>{"30", "86"}
             : std::vector<std::string>{"0", "30", "60", "75", "86", "89"}},
      {"format", "",
       "What traversal computes with: f8/M+4/D32 is fixed point with f = 8, M = B + 4, D = 32; /half: "
       "half-precision heights.",
       formats(quick)}};
  const std::string lsb_parts = fmt::format("height LSB / {}", kParts),
                    texel_parts = fmt::format("texels / {}", kParts);
  plan.counters = {
      {"rays", "rays", "Rays traced; all of them truly hit."},
      {"same_cell", "rays", "Rays that hit the true cell."},
      {"earlier", "rays", "Rays that hit another cell, before the true hit."},
      {"later", "rays", "Rays that hit another cell, behind the true hit."},
      {"missed", "rays", "Rays that miss."},
      {"strayed", "rays",
       "Rays that hit more than 1 height LSB and more than 1 texel away from the true place."},
      {"height_max", lsb_parts,
       "Of all rays that hit, in whatever cell, along the ray, as a "
       "difference in height: the largest error."},
      {"height_p99", lsb_parts, "Of these, the 99th percentile."},
      {"texel_max", texel_parts, "Of these, in the plane of the map: the largest error."},
      {"texel_p99", texel_parts, "Of these, the 99th percentile."},
      {"top_rays", "rays", "Rays that hit the true cell on its top, as they truly do."},
      {"top_max", lsb_parts, "Of these, along the ray, as a difference in height: the largest error."},
      {"top_p99", lsb_parts, "Of these, the 99th percentile."},
      {"top_rms", lsb_parts, "Of these, the root mean square."},
      {"top_texel_max", texel_parts, "Of these, in the plane of the map: the largest error."},
      {"wall_rays", "rays", "Rays that hit the true cell on a wall, as they truly do."},
      {"wall_max", texel_parts, "Of these, along the ray, in the plane of the map: the largest error."},
      {"wall_p99", texel_parts, "Of these, the 99th percentile."},
      {"wall_rms", texel_parts, "Of these, the root mean square."},
      {"wall_height_max", lsb_parts, "Of these, as a difference in height: the largest error."},
  };
  return plan;
}

}  // namespace

namespace precision {

std::string fixed_format(int fraction, int mantissa, int direction) {
  return fmt::format("f{}/M+{}/D{}", fraction, mantissa, direction);
}

std::string default_format() { return fixed_format(8, 4, 32); }

}  // namespace precision

Study precision_study() {
  return {.name = kName,
          .plan = make_plan,
          .make_runner = make_case_runner<PrecisionRunner>,
          .page = precision_page,
          .headline = precision_headline};
}

}  // namespace cuesta
