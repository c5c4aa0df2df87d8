#include "sim/verify/laws/laws_check.h"

#include "models/common/error.h"
#include "sim/session/job.h"
#include "sim/session/measure.h"

namespace cuesta {
namespace {

constexpr uint64_t kFidelities = 3;

/// Runs one algorithm on one machine at each fidelity; gives the rays of all.
uint64_t check_one(Measurer& measurer, const Algorithm& algorithm, const Architecture& architecture) {
  const RunEntry plain = measurer.run(algorithm, architecture, Fidelity::kFunctional);
  const RunEntry timed = measurer.run(algorithm, architecture, Fidelity::kCycle);
  const RunEntry loose = measurer.run(algorithm, architecture, Fidelity::kTransaction);
  if (plain.hits_digest != timed.hits_digest || plain.hits_digest != loose.hits_digest) {
    throw Error(ExitCode::kMismatch,
                "functional, transaction and cycle fidelity differ in hits or steps: " + plain.algorithm +
                    " on " + plain.architecture + ", scene " + plain.scene + ".");
  }
  return plain.all_rays + timed.all_rays + loose.all_rays;
}

}  // namespace

LawsCounts check_laws(const LawsRequest& request, Observer& observer) {
  LawsCounts counts;
  counts.planned = request.scenes.size() * request.machines.size() * algorithms().size() * kFidelities;
  Stage stage(observer, "laws", "runs", counts.planned);
  for (const std::string& scene : request.scenes) {
    SceneChanges changes;
    const Scene wanted = changed_scene(scene, changes);
    if (wanted.rays_file.empty() && wanted.ray_set.kind.empty()) changes.size = {request.size, request.size};
    const Job job = prepare_job(scene, changes);
    Measurer measurer(job);
    for (const ResolvedArchitecture& machine : request.machines) {
      for (const Algorithm& algorithm : algorithms()) {
        counts.stopped = !stage.update(counts.runs);
        if (counts.stopped) return counts;
        counts.rays += check_one(measurer, algorithm, machine.architecture);
        counts.runs += kFidelities;
      }
    }
  }
  return counts;
}

}  // namespace cuesta
