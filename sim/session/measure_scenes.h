#pragma once

#include <optional>
#include <string>
#include <vector>

#include "models/common/error.h"
#include "reports/result.h"
#include "sim/config/architecture_file.h"
#include "sim/session/job.h"
#include "sim/session/measure.h"
#include "sim/session/progress.h"

namespace cuesta {

/// What is to be measured: every algorithm on every machine, over the rays of every scene.
struct RunRequest {
  std::vector<std::string> scenes;  ///< names or files
  SceneChanges changes;             ///< of each of them
  std::vector<Algorithm> algorithms;
  std::vector<ResolvedArchitecture> machines;
  Fidelity fidelity = Fidelity::kCycle;
};

/// Throws usage_error where a scene's surface does not go with an algorithm or a machine's numbers. Reads the scenes'
/// files, and neither heights nor rays.
void check_surfaces(const RunRequest& wanted);

/// Gives the names that the scenes' runs will carry. Throws usage_error for two scenes of one name.
std::vector<std::string> scene_names(const RunRequest& wanted);

/// Counts the runs: a machine whose [traverse] section makes two algorithms the same schedule runs it once.
size_t planned_runs(const RunRequest& wanted);

/// Remarks each machine on which there are fewer different schedules than algorithms.
void remark_same_schedules(const RunRequest& wanted, Observer& observer);

/// Makes one scene ready after another and runs every algorithm on every machine over its rays; runs, inputs, seeds and
/// how long the maps of searches took go into `result`, in this order. `cycle_runner` may be empty: the machine's own
/// loop. Ended by the observer, the last run may be partial and later ones are missing.
/// Throws what making ready and running throw as long as no run is finished; later the error ends the measurement and
/// is given back, so that what was measured before it can be kept.
std::optional<Error> measure_scenes(const RunRequest& wanted, const CycleRunner& cycle_runner,
                                    Observer& observer, Result& result);

}  // namespace cuesta
