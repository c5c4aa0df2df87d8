#include <algorithm>
#include <array>
#include <type_traits>

#include "models/traversal/fetch.h"
#include "models/traversal/lanes.h"
#include "models/traversal/traversal.h"
#include "models/work/bilinear_run.h"
#include "models/work/outcome.h"
#include "models/work/search_source.h"
#include "models/work/workload.h"

namespace cuesta {

namespace {

constexpr size_t kRaysPerReport = 1 << 14;

template <class A, class G>
uint64_t trace_all(const Workload& work, const NumberFormat& format, const Progress& progress,
                   std::vector<HitRecord>& hits, FetchCounts& fetches) {
  const Pyramid& pyramid = *work.pyramid;
  const int root = pyramid.root_level();
  const Walk<A, G> walk(work.map, format, work.schedule, pyramid.highest());
  struct LevelView {
    const uint16_t* texels;
    int64_t width;
  };
  std::array<LevelView, 32> levels{};
  for (int level = 0; level <= root; ++level) {
    levels[static_cast<size_t>(level)] = {pyramid.level(level), pyramid.width(level)};
  }
  auto fetch = [&](int level, int64_t i, int64_t j) -> int64_t {
    const LevelView& view = levels[static_cast<size_t>(level)];
    return view.texels[j * view.width + i];
  };
  for (size_t first = 0; first < work.rays.size(); first += kRaysPerReport) {
    if (progress && !progress(first, work.rays.size())) return first;
    const size_t count = std::min(kRaysPerReport, work.rays.size() - first);
    if constexpr (std::is_same_v<Walk<A, G>, Walk<FixedArithmetic, PlainAxis>>) {
      if (lanes_can(walk)) {
        traverse_lanes(walk, pyramid, work.rays.subspan(first, count), {},
                       std::span(hits).subspan(first, count), nullptr);
        continue;
      }
    }
    if (work.schedule.fetch == FetchRule::kQuad) {
      for (size_t k = first; k < first + count; ++k) {
        KeptQuad kept;
        hits[k] = traverse_ray(walk, work.rays[k], [&](int level, int64_t i, int64_t j) {
          if (kept.fetches(level, i, j)) {
            const Quad quad = Quad::of(pyramid, level, static_cast<int>(i), static_cast<int>(j));
            fetches.add({1, int64_t{quad.width} * quad.height});
          }
          return fetch(level, i, j);
        });
      }
      continue;
    }
    for (size_t k = first; k < first + count; ++k) hits[k] = traverse_ray(walk, work.rays[k], fetch);
  }
  if (progress) progress(work.rays.size(), work.rays.size());
  return work.rays.size();
}

}  // namespace

Outcome run_functional(const Workload& work, const Architecture& architecture, const Progress& progress) {
  Outcome outcome;
  outcome.hits.resize(work.rays.size());
  for (size_t k = 0; k < work.rays.size(); ++k) {
    outcome.hits[k].ray_id = work.rays[k].id;
    outcome.hits[k].status = HitStatus::kDidNotFinish;
  }
  const NumberFormat format = number_format(architecture.traverse, work.map);
  FetchCounts fetches;
  const bool bilinear = work.map.surface == Surface::kBilinear;
  if (work.search) {
    outcome.finished_rays = search_all(work, architecture, progress, outcome.hits, fetches);
  } else if (bilinear) {
    outcome.finished_rays =
        trace_bilinear(work, architecture.traverse.arithmetic, format, progress, outcome.hits, fetches);
  } else {
    outcome.finished_rays = with_traversal_types(
        architecture.traverse.arithmetic, work.map,
        [&]<class A, class G>() { return trace_all<A, G>(work, format, progress, outcome.hits, fetches); });
  }
  if (!work.search && !bilinear && work.schedule.fetch == FetchRule::kTexel) {
    for (const HitRecord& hit : outcome.hits) fetches.add({hit.steps, hit.steps});
  }
  add_hit_measurements(work, outcome.hits, fetches, outcome.measurements);
  seal(work, outcome.finished_rays == work.rays.size(), outcome);
  return outcome;
}

}  // namespace cuesta
