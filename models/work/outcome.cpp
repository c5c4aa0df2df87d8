#include "models/work/outcome.h"

#include <algorithm>

#include "models/common/digest.h"
#include "models/common/error.h"

namespace cuesta {

void add_hit_measurements(const Workload& work, std::span<const HitRecord> hits, const FetchCounts& fetches,
                          Measurements& measurements) {
  Counters& counters = measurements.counters;
  int64_t hit = 0, miss = 0, dead = 0, unfinished = 0, steps = 0;
  std::vector<int64_t> per_ray;
  per_ray.reserve(hits.size());
  for (const HitRecord& record : hits) {
    hit += record.status == HitStatus::kHit;
    miss += record.status == HitStatus::kMiss;
    dead += record.status == HitStatus::kMiss && record.steps == 0;
    const bool early = record.status == HitStatus::kDidNotFinish && record.steps == 0;
    unfinished += early;
    steps += record.steps;
    if (!early) per_ray.push_back(record.steps);
  }
  counters.set("machine.rays", static_cast<int64_t>(hits.size()) - unfinished);
  counters.set("machine.hits", hit);
  counters.set("machine.misses", miss);
  counters.set("machine.dead_rays", dead);
  counters.set("machine.unfinished_rays", unfinished);
  counters.set("machine.steps", steps);
  counters.set("machine.fetches", fetches.fetches);
  counters.set("machine.fetched_texels", fetches.texels);
  counters.set("machine.texel_bytes", fetches.texels * work.texel_bytes());
  measurements.histograms.push_back(make_histogram("steps", std::move(per_ray)));
  measurements.plane_width = work.width;
  measurements.plane_height = work.height;
  measurements.planes.push_back(plane_of(work, "plane.steps", [&](size_t k) { return hits[k].steps; }));
}

void add_error_measurements(const Workload& work, const Judgement& judgement, Measurements& measurements) {
  Counters& counters = measurements.counters;
  const auto count = [&](Verdict verdict) { return judgement.counts.count(verdict); };
  counters.set("error.exact", count(Verdict::kExact));
  counters.set("error.tie", count(Verdict::kTie));
  counters.set("error.missed", count(Verdict::kMissed));
  counters.set("error.behind", count(Verdict::kBehind));
  counters.set("error.wrong_cell", count(Verdict::kWrongCell));
  counters.set("error.wrong", judgement.counts.wrong());
  if (is_printed(work.search->kind)) {
    counters.set("error.nan", judgement.not_numbers);
    counters.set("error.unfinished", judgement.unfinished);
  }
  const PreprocessingCost& cost = work.search_map->cost();
  counters.set("preprocessing.texels_read", static_cast<int64_t>(cost.texels_read));
  counters.set("preprocessing.records", static_cast<int64_t>(cost.records_written));
  counters.set("preprocessing.bytes", static_cast<int64_t>(work.search_map->size_bytes()));
  measurements.histograms.push_back(error_histogram("height_error", judgement.height_errors));
  measurements.histograms.push_back(error_histogram("texel_error", judgement.texel_errors));
  measurements.planes.push_back(plane_of(work, "plane.wrong", [&](size_t k) { return judgement.wrong(k); }));
}

void add_answer(Digest& digest, const HitRecord& hit) {
  digest.u64(hit.ray_id);
  digest.u8(static_cast<uint8_t>(hit.status));
  digest.u8(static_cast<uint8_t>(hit.face));
  digest.u8(hit.stop_level);
  digest.u32(static_cast<uint32_t>(hit.i));
  digest.u32(static_cast<uint32_t>(hit.j));
  digest.i64(hit.t);
}

void seal(const Workload& work, bool finished, Outcome& outcome) {
  Digest hits;
  hits.u64(work.rays.size());
  for (const MachineRay& ray : work.rays) {
    for (int64_t value : {ray.x0, ray.y0, ray.z0, ray.dx, ray.dy, ray.dz, ray.t_max}) hits.i64(value);
    hits.u64(ray.id);
    hits.u32(static_cast<uint32_t>(ray.exponent));
    hits.u8(ray.dead ? 1 : 0);
  }
  for (const HitRecord& hit : outcome.hits) {
    add_answer(hits, hit);
    hits.u32(hit.steps);
  }
  outcome.hits_digest = hits.hex();
  if (!finished) return;
  Digest all;
  all.text(outcome.hits_digest);
  for (const auto& [path, value] : outcome.measurements.counters.all()) {
    all.text(path);
    all.i64(value);
  }
  for (const Plane& plane : outcome.measurements.planes) {
    all.text(plane.name);
    for (uint32_t value : plane.values) all.u32(value);
    all.i64(plane.nobody);
  }
  outcome.digest = all.hex();
}

}  // namespace cuesta
