#include "models/work/functional_run.h"

#include <algorithm>

#include "models/work/walker.h"

namespace cuesta {
namespace {

constexpr size_t kRaysPerReport = 1 << 14;

/// Walks all rays in the order of the trace; returns how many, fewer where `progress` ends it.
uint64_t walk_all(const Workload& work, const Progress& progress, std::span<HitRecord> hits,
                  FetchCounts& fetches) {
  const std::unique_ptr<Walker> walker = make_walker(work);
  std::vector<FetchCounts> of_batch;
  for (size_t first = 0; first < work.rays.size(); first += kRaysPerReport) {
    if (progress && !progress(first, work.rays.size())) return first;
    const size_t count = std::min(kRaysPerReport, work.rays.size() - first);
    const std::span<HitRecord> records = hits.subspan(first, count);
    of_batch.assign(walker->counts_fetches() ? count : 0, {});
    walker->walk({work.rays.subspan(first, count), {}}, records, of_batch, nullptr);
    for (const FetchCounts& counts : of_batch) fetches.add(counts);
    if (of_batch.empty()) {
      for (const HitRecord& hit : records) fetches.add({hit.steps, hit.steps});
    }
  }
  if (progress) progress(work.rays.size(), work.rays.size());
  return work.rays.size();
}

}  // namespace

Outcome run_functional(const Workload& work, const Progress& progress) {
  Outcome outcome;
  outcome.hits.resize(work.rays.size());
  for (size_t k = 0; k < work.rays.size(); ++k) {
    outcome.hits[k].ray_id = work.rays[k].id;
    outcome.hits[k].status = HitStatus::kDidNotFinish;
  }
  FetchCounts fetches;
  outcome.finished_rays = walk_all(work, progress, outcome.hits, fetches);
  add_hit_measurements(work, outcome.hits, fetches, outcome.measurements);
  seal(work, outcome.finished_rays == work.rays.size(), outcome);
  return outcome;
}

}  // namespace cuesta
