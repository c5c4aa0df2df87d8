#include "models/oracle/precision_check.h"

#include <cmath>

#include "models/common/error.h"
#include "models/oracle/random_cases.h"
#include "models/oracle/traced_ray.h"
#include "models/rays/hit_time.h"
#include "models/traversal/traversal.h"

namespace cuesta {
namespace {

constexpr int kRaysPerMap = 50;

NumberFormat format_of(const PrecisionFormat& p, int bits) {
  return {p.fraction_bits, p.direction_bits, bits + p.mantissa_over_bits, 4};
}

TracedRay free_ray(Random& random, uint64_t id) {
  constexpr double kSlopes[] = {4, 1, 0.25, 0.05, 0.005};
  TracedRay ray;
  ray.id = id;
  for (int a = 0; a < 2; ++a) {
    ray.origin[a] = random.unit();
    ray.direction[a] = 2 * random.unit() - 1;
  }
  ray.origin[2] = random.chance(0.7) ? 1 : random.unit();
  const double slope = random.unit() * kSlopes[random.below(std::size(kSlopes))];
  ray.direction[2] = random.chance(0.8) ? -slope : slope;
  ray.t_max = 2;  // so many tiles at most
  return ray;
}

/// Time in machine units, for judging only.
long double machine_time(const HitRecord& record, Arithmetic arithmetic, const NumberFormat& format) {
  const int shift = format.fraction_bits + format.direction_bits - 1 + format.mantissa_bits;
  if (arithmetic == Arithmetic::kFixed) return static_cast<long double>(record.t);
  return std::ldexp(recorded_time(record, arithmetic), shift);
}

class Checker {
 public:
  explicit Checker(const RandomMap& map)
      : map_(map), pyramid_(build_max_pyramid(map.grid)), surface_(oracle_map(map.grid, map.shape)) {}

  /// False: a ray that does not fit the formats; nothing is counted.
  bool check(const TracedRay& ray, PrecisionCheck& counts) const {
    std::array<MachineRay, kPrecisionFormats.size()> rays;
    try {
      for (size_t k = 0; k < rays.size(); ++k) {
        rays[k] = quantise(ray, map_.shape, format_of(kPrecisionFormats[k], map_.grid.bits));
      }
    } catch (const Error&) {
      return false;  // beyond the tiles that the formats hold
    }
    auto traced =
        exact_traced_ray(ray, map_.shape, format_of(kPrecisionFormats[0], map_.grid.bits), rays[0].dead);
    if (!traced) return false;
    const auto truth = oracle_leaf_walk(*traced, surface_);
    for (size_t k = 0; k < rays.size(); ++k) {
      const PrecisionFormat& p = kPrecisionFormats[k];
      const NumberFormat format = format_of(p, map_.grid.bits);
      const HitRecord found = walk(p.arithmetic, format, rays[k]);
      const JudgedAnswer answer{found.status == HitStatus::kHit, found.i, found.j,
                                machine_time(found, p.arithmetic, format)};
      PrecisionRow& row = counts.rows[k];
      traced->machine_units = machine_units_of(format, rays[k].exponent);
      row.traced.add(judge(*traced, surface_, truth, answer));
      row.quantised.add(verdict(rays[k], format, OracleInput::kMachineInput, answer));
      if (p.arithmetic != Arithmetic::kFixed) continue;
      const Verdict set_up = verdict(rays[k], format, OracleInput::kSetup, answer);
      row.set_up.add(set_up);
      if (set_up != Verdict::kExact && counts.first_failure.empty()) {
        counts.first_failure = std::string(p.name) + ": " + std::string(name_of(set_up)) + "\n  " +
                               describe(map_) + "\n  " + describe(ray) +
                               "\n  machine ray: " + describe(rays[k]);
      }
    }
    ++counts.rays;
    return true;
  }

 private:
  HitRecord walk(Arithmetic arithmetic, const NumberFormat& format, const MachineRay& ray) const {
    return with_traversal_types(arithmetic, map_.shape, [&]<class A, class G>() {
      const Walk<A, G> leaf_walk(map_.shape, format, {StartRule::kLeaf, 1, UpRule::kNever},
                                 pyramid_.highest());
      return traverse_ray(leaf_walk, ray, [&](int level, int64_t i, int64_t j) -> int64_t {
        return pyramid_.at(level, static_cast<int>(i), static_cast<int>(j));
      });
    });
  }

  Verdict verdict(const MachineRay& ray, const NumberFormat& format, OracleInput input,
                  const JudgedAnswer& answer) const {
    const auto exact = exact_ray(ray, map_.shape, format, input);
    return judge(exact, surface_, oracle_leaf_walk(exact, surface_), answer);
  }

  const RandomMap& map_;
  Pyramid pyramid_;
  OracleMap surface_;
};

void add_counts(VerdictCounts& to, const VerdictCounts& from) {
  for (size_t v = 0; v < kVerdicts; ++v) to.of[v] += from.of[v];
}

}  // namespace

int64_t PrecisionCheck::errors() const {
  int64_t sum = 0;
  for (const PrecisionRow& row : rows) sum += row.set_up.total() - row.set_up.count(Verdict::kExact);
  return sum;
}

void PrecisionCheck::add(const PrecisionCheck& other) {
  rays += other.rays;
  for (size_t k = 0; k < rows.size(); ++k) {
    add_counts(rows[k].set_up, other.rows[k].set_up);
    add_counts(rows[k].quantised, other.rows[k].quantised);
    add_counts(rows[k].traced, other.rows[k].traced);
  }
  if (first_failure.empty()) first_failure = other.first_failure;
}

PrecisionCheck check_precision(uint64_t seed, int64_t rays, int max_side, PrecisionRays kind) {
  PrecisionCheck counts;
  Random random(seed);
  while (counts.rays < rays) {
    RandomMap map = random_map(random.next(), max_side);
    if (map.grid.bits < 8) continue;
    map.format = format_of(kPrecisionFormats[2], map.grid.bits);
    const Checker checker(map);
    for (int r = 0; r < kRaysPerMap && counts.rays < rays; ++r) {
      const auto id = static_cast<uint64_t>(counts.rays);
      checker.check(kind == PrecisionRays::kFree ? free_ray(random, id) : random_ray(random, map, id),
                    counts);
    }
  }
  return counts;
}

}  // namespace cuesta
