#pragma once

#include <algorithm>
#include <cstdint>

#include "models/search/search_ray.h"
#include "models/search/search_surface.h"

// The searches that walk along the ray in equal steps of time over the segment, then refine. One sample is one step.
// They differ in five choices, said in one table.

namespace cuesta {

/// What a search found; `t` is meaningless unless found.
template <class Real>
struct SearchFound {
  bool found = false;
  Real t = 0;
  HitFace face = HitFace::kTop;  ///< kInside: the first sample, at the entry, was under the surface
  bool has_cell = false;         ///< (i, j) is the cell; else it is that of the ray's place at t
  int64_t i = 0, j = 0;
};

namespace search_detail {

enum class Refine : uint8_t {
  kNone,  ///< the first sample under the surface
  /// Where the chords of ray and surface between the last two samples meet: one division, a slot without memory.
  kSecant,
  kBinary,  ///< `refinements` halvings, each one sample; the last sample that lay under
  kSecants,  ///< `refinements` times a secant (a slot without memory) and a sample there, one step; it replaces one end
};
enum class Unfound : uint8_t { kMiss, kEntry, kBottom };

struct LinearRule {
  bool by_angle;       ///< steps = (int)lerp(steps, least_steps, N.V)
  bool samples_entry;  ///< the entry itself is the first sample: steps + 1 samples, not steps
  bool one_late;       ///< sample k is compared with the ray's height at k + 1
  Refine refine;
  Unfound
      unfound;  ///< no sample under: a miss; a hit at the entry; a hit where z = 0 (a miss if it ends elsewhere)
};

/// steep            McGuire & McGuire 2005, reconstructed: the entry is sampled, then step by step.
/// pom-printed      Luna 2012, printed: the ray's height runs one step ahead of the sample, the sample before the first
///                  has height 0 at the ray's start, and nothing found leaves the offset at 0.
/// pom              Luna 2012, repaired (ours): a sample is compared with its own height, nothing found is a miss.
/// pom-tatarchuk    Tatarchuk 2006, reconstructed: no sample at the entry, where the surface is taken to touch the ray;
///                  nothing found is the far end of the offset.
/// relief           Policarpo, Oliveira, Comba 2005, reconstructed: no sample at the entry; binary search.
/// interval         Risser et al. 2005, reconstructed; that the entry is sampled is ours. The answer is the last
/// secant's.
inline LinearRule linear_rule(SearchKind kind) {
  switch (kind) {
    case SearchKind::kPomPrinted:
      return {true, true, true, Refine::kSecant, Unfound::kEntry};
    case SearchKind::kPom:
      return {true, true, false, Refine::kSecant, Unfound::kMiss};
    case SearchKind::kPomTatarchuk:
      return {true, false, false, Refine::kSecant, Unfound::kBottom};
    case SearchKind::kRelief:
      return {false, false, false, Refine::kBinary, Unfound::kMiss};
    case SearchKind::kInterval:
      return {false, true, false, Refine::kSecants, Unfound::kMiss};
    default:
      return {false, true, false, Refine::kNone, Unfound::kMiss};
  }
}

/// Halves [above, under] `count` times, each one sample; the last sample that lay under the surface.
template <class Real, class Sink>
Real halve(const SearchRay<Real>& ray, const SearchSurface<Real>& surface, Real above, Real under, int count,
           Sink& sink) {
  for (int k = 0; k < count; ++k) {
    const SearchPoint<Real> middle = ray.point(above + (under - above) / 2);
    const Real height = surface.height(middle, sink);
    sink.end_step();
    (ray.under(middle.z, height) ? under : above) = middle.t;
  }
  return under;
}

}  // namespace search_detail

template <class Real, class Sink>
SearchFound<Real> linear_search(const Search& search, const SearchRay<Real>& ray,
                                const SearchSurface<Real>& surface, Real n_dot_v, Sink& sink) {
  using namespace search_detail;
  const LinearRule rule = linear_rule(search.kind);
  int steps = search.steps;
  if (rule.by_angle) {
    const Real most = static_cast<Real>(search.steps), least = static_cast<Real>(search.least_steps);
    steps = std::max(1, static_cast<int>(most + (least - most) * n_dot_v));
  }
  const Real count = static_cast<Real>(steps);
  const SearchPoint<Real> entry = ray.point(ray.t_start);
  const Real step_t = (ray.t_end - ray.t_start) / count, step_z = (ray.z_end - entry.z) / count;

  // What lies before the first sample: `gap` is surface minus ray, the printed one's with a height of 0.
  Real before_t = ray.t_start, before_gap = rule.one_late ? -entry.z : Real{0};
  int k = rule.samples_entry ? 0 : 1;
  Real t = 0, gap = 0;
  bool crossed = false;
  for (; k <= steps; ++k) {
    const SearchPoint<Real> point =
        k == steps ? ray.point(ray.t_end) : ray.point(ray.t_start + static_cast<Real>(k) * step_t);
    t = point.t;
    const Real z = rule.one_late ? entry.z + static_cast<Real>(k + 1) * step_z : point.z;
    const Real height = surface.height(point, sink);
    sink.end_step();
    gap = height - z;
    // Luna's and Tatarchuk's comparison is strict; where it matters alone, at z = 0 over height 0, the rules below and
    // kBottom agree on the answer.
    crossed = rule.one_late || rule.unfound == Unfound::kBottom ? height > z : ray.under(z, height);
    if (crossed) break;
    before_t = t;
    before_gap = gap;
  }
  if (!crossed) {
    if (rule.unfound == Unfound::kEntry) return {true, ray.t_start, HitFace::kTop};
    if (rule.unfound == Unfound::kBottom && ray.ends_at_bottom) return {true, ray.t_end, HitFace::kTop};
    return {};
  }
  if (k == 0 && !rule.one_late) return {true, t, HitFace::kInside};
  switch (rule.refine) {
    case Refine::kNone:
      break;
    case Refine::kSecant:
      sink.compute();
      sink.end_step();
      // As printed the step of the first sample is added to no offset: its secant reaches on by one step.
      t = before_t + before_gap / (before_gap - gap) * (rule.one_late ? step_t : t - before_t);
      break;
    case Refine::kBinary:
      t = halve(ray, surface, before_t, t, search.refinements, sink);
      break;
    case Refine::kSecants: {
      Real under_t = t, under_gap = gap;
      for (int secant = 0; secant < search.refinements; ++secant) {
        sink.compute();
        t = before_t + before_gap / (before_gap - under_gap) * (under_t - before_t);
        const SearchPoint<Real> point = ray.point(t);
        const Real height = surface.height(point, sink);
        sink.end_step();
        const bool is_under = ray.under(point.z, height);
        (is_under ? under_t : before_t) = t;
        (is_under ? under_gap : before_gap) = height - point.z;
      }
      break;
    }
  }
  return {true, t, HitFace::kTop};
}

}  // namespace cuesta
