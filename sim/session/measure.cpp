#include "sim/session/measure.h"

#include <chrono>

#include "models/common/digest.h"
#include "models/common/error.h"
#include "models/oracle/checked_walks.h"
#include "models/work/functional_run.h"
#include "models/work/outcome.h"
#include "sim/config/on_architecture.h"
#include "sim/config/parameters.h"

namespace cuesta {
namespace {

/// Gives the parameters that the run uses, as the table of parameters has them.
MachineFacts facts_of(const Architecture& a, Fidelity fidelity, int texel_bytes) {
  MachineFacts facts;
  facts.texel_bytes = texel_bytes;
  for (const Parameter& parameter : parameters()) {
    const bool used = why_unused(parameter, a, fidelity != Fidelity::kFunctional).empty();
    // How many pipelines a result is about is said at every fidelity.
    if (!used && parameter.path != "machine.pipelines") continue;
    facts.parameters.push_back({std::string(parameter.path), parameter.get(a), std::string(parameter.unit)});
  }
  return facts;
}

/// Hardware's records against the value of the walk, which the model's machine has by construction: the hardware may be
/// anybody's. Throws Error(kMismatch) for the first that differs.
void check_hardware(const Workload& work, const std::vector<HitRecord>& hits, const std::string& run_name) {
  const std::vector<HitRecord> right = run_functional(work).hits;
  for (size_t k = 0; k < hits.size(); ++k) {
    if (hits[k] == right[k]) continue;
    const uint32_t pixel = work.pixel_of_ray[k], width = static_cast<uint32_t>(work.width);
    throw Error(ExitCode::kMismatch, run_name + ": the hardware's record of ray " + std::to_string(k) +
                                         ", pixel (" + std::to_string(pixel % width) + ", " +
                                         std::to_string(pixel / width) + "), is wrong: " + describe(hits[k]) +
                                         "; the walk's: " + describe(right[k]) +
                                         ". `cuesta verify rtl` finds where they part.");
  }
}

}  // namespace

void check_surface(const Scene& scene, const Algorithm& named, const Architecture& architecture) {
  if (scene.surface == Surface::kTexel) return;
  const Algorithm algorithm = algorithm_on(named, architecture.traverse);
  const int stop = algorithm.schedule.stop_level;
  if (stop > 0) {
    throw usage_error(
        "Algorithm " + algorithm.id + " stops at level " + std::to_string(stop) + ", and scene " +
        scene.name +
        "'s surface is bilinear, whose leaves are the patches of level 0; accepted with it is stop "
        "level 0.");
  }
  if (algorithm.search) {
    throw usage_error(
        "Algorithm " + algorithm.id + " is a search, and scene " + scene.name +
        "'s surface is bilinear, against which searches are not judged; accepted with it are exact "
        "algorithms, or surface.kind = \"texel\" (a search may filter by an ending of its own, :bilinear or "
        ":linear).");
  }
  MapShape map;
  map.surface = scene.surface;
  number_format(architecture.traverse, map);
}

std::string Measurer::steps_free_digest(const std::vector<HitRecord>& hits) {
  Digest digest;
  for (const HitRecord& hit : hits) add_answer(digest, hit);
  return digest.hex();
}

const std::vector<MachineRay>& Measurer::rays_for(const NumberFormat& format) {
  for (const auto& [known, rays] : rays_) {
    if (known == format) return rays;
  }
  rays_.clear();  // machines mostly share one format: keep the last one only
  return rays_.emplace_back(format, machine_rays(job_, format)).second;
}

void Measurer::check(const Algorithm& named, const Architecture& architecture) const {
  check_surface(job_.scene, named, architecture);
  const Algorithm algorithm = algorithm_on(named, architecture.traverse);
  number_format(architecture.traverse, job_.map);
  const int stop = algorithm.schedule.stop_level, root = job_.pyramid.root_level();
  if (stop > root) {
    throw usage_error("Algorithm " + algorithm.id + " stops at level " + std::to_string(stop) +
                      ", above the root of scene " + job_.scene.name + "'s map of " +
                      std::to_string(job_.map.width) + " x " + std::to_string(job_.map.height) +
                      " texels; accepted are levels 0 to " + std::to_string(root) + ".");
  }
  if (algorithm.search) check_map(*algorithm.search, job_.map.width, job_.map.height, job_.map.address_mode);
}

const Pyramid& Measurer::pyramid_for(const Algorithm& algorithm) {
  const int stop = algorithm.schedule.stop_level;
  if (stop == 0) return job_.pyramid;
  if (!stopped_ || stopped_->lowest_level() != stop) {
    stopped_.reset();
    stopped_ = build_stopped_pyramid(job_.pyramid, stop);
  }
  return *stopped_;
}

const SearchMap& Measurer::search_map_for(const Search& search) {
  const auto known = search_maps_.find(search.kind);
  if (known != search_maps_.end()) return known->second;
  const auto start = std::chrono::steady_clock::now();
  SearchMap map(search, job_.pyramid, job_.map.address_mode);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  preprocessing_.push_back({std::string(row_of(search).id), time.count()});
  return search_maps_.emplace(search.kind, std::move(map)).first->second;
}

void Measurer::judge(const Workload& work, Outcome& outcome) {
  if (!judge_ || !(judge_format_ == work.format)) {
    judge_.emplace(work);
    judge_format_ = work.format;
  }
  add_error_measurements(work, judge_->judge(outcome.hits, work.arithmetic), outcome.measurements);
}

void Measurer::check_same_hits(const Workload& work, const std::vector<HitRecord>& hits,
                               const std::string& run_name) {
  const NumberFormat& format = work.format;
  std::string numbers = std::to_string(static_cast<int>(work.arithmetic));
  for (int bits : {format.fraction_bits, format.direction_bits, format.mantissa_bits, format.tile_bits,
                   work.schedule.stop_level}) {
    numbers += "," + std::to_string(bits);
  }
  const std::string digest = steps_free_digest(hits);
  const auto& [first_digest, first_run] = hits_.try_emplace(numbers, digest, run_name).first->second;
  if (digest != first_digest) {
    throw Error(ExitCode::kMismatch, run_name + " and " + first_run +
                                         " find different hits on the same rays of scene " + job_.scene.name +
                                         ": a fault of the simulator; please report it.");
  }
}

RunEntry Measurer::run(const Algorithm& named, const Architecture& architecture, Fidelity fidelity,
                       const Progress& progress) {
  check(named, architecture);
  const Algorithm algorithm = algorithm_on(named, architecture.traverse);
  const SearchMap* const map = algorithm.search ? &search_map_for(*algorithm.search) : nullptr;
  Workload work = workload_of(job_, architecture, {}, algorithm, map);
  work.rays = rays_for(work.format);
  work.pyramid = &pyramid_for(algorithm);
  Outcome outcome = fidelity == Fidelity::kFunctional    ? run_functional(work, progress)
                    : fidelity == Fidelity::kTransaction ? run_transaction(work, architecture, progress)
                    : cycle_runner_ ? cycle_runner_(work, job_.trace.rays, architecture, progress)
                                    : run_cycle(work, architecture, progress);

  RunEntry entry;
  entry.scene = job_.scene.name;
  entry.algorithm = algorithm.id;
  entry.architecture = architecture.name;
  entry.fidelity = name_of(fidelity);
  entry.machine = facts_of(architecture, fidelity, work.texel_bytes());
  entry.finished_rays = outcome.finished_rays;
  entry.all_rays = work.rays.size();
  if (!entry.partial()) {
    if (work.search) judge(work, outcome);
    const std::string run_name = entry.algorithm + " on " + entry.architecture;
    const std::vector<std::string> broken = broken_laws(work, architecture, fidelity, outcome);
    if (!broken.empty()) {
      throw Error(ExitCode::kMismatch, "The accounting of " + run_name + " over scene " + entry.scene + " (" +
                                           entry.fidelity + ") breaks " + std::to_string(broken.size()) +
                                           " of its laws; the first: " + broken.front());
    }
    const UnitParameters& units = architecture.units;
    if (fidelity != Fidelity::kFunctional &&
        (units.hmt_top == Implementation::kRtl || units.traverse == Implementation::kRtl)) {
      check_hardware(work, outcome.hits, run_name);
    }
    if (!work.search) check_same_hits(work, outcome.hits, run_name);
  }
  entry.measurements = std::move(outcome.measurements);
  entry.hits_digest = std::move(outcome.hits_digest);
  entry.digest = std::move(outcome.digest);
  return entry;
}

}  // namespace cuesta
