#include "sim/explore/study/view_runner.h"

#include <algorithm>

#include "models/algorithms/schedule.h"
#include "models/common/digest.h"
#include "models/common/error.h"
#include "models/heightmap/generator.h"
#include "sim/config/on_architecture.h"

namespace cuesta {
namespace {

constexpr int kHeightBits = 8;
constexpr uint64_t kMapSeed = 1;

/// Numbers the warps of the picture side by side, then below each other.
uint32_t warp_of(uint32_t pixel) {
  return pixel / kViewWidth / kWarpHeight * (kViewWidth / kWarpWidth) + pixel % kViewWidth / kWarpWidth;
}

}  // namespace

ViewRunner::ViewRunner(const StudyData& plan, std::span<const uint16_t> size_and_map,
                       std::vector<uint32_t> pixels)
    : plan_(plan), pixels_(std::move(pixels)) {
  turns_ = std::ranges::any_of(plan.axes, [](const StudyAxis& axis) { return axis.name == "turn"; });
  const StudyPlace place(size_and_map.begin(), size_and_map.end());
  const int side = static_cast<int>(number_at(plan, place, "size"));
  const HeightGrid grid = generate(value(place, "map"), side, side, kHeightBits, kMapSeed);
  pyramid_ = build_max_pyramid(grid);
  map_ = {grid.width, grid.height, pyramid_.root_level(), grid.bits, AddressMode::kWrap};
}

const std::vector<MachineRay>& ViewRunner::rays_at(const StudyPlace& place, const NumberFormat& format) {
  std::string view = value(place, "depth") + " deep at " + value(place, "angle") + " degrees";
  ParallelView wanted = study_view(number_at(plan_, place, "angle"), number_at(plan_, place, "depth"));
  if (turns_) {
    view += ", turned by " + value(place, "turn");
    wanted.turn_degrees = number_at(plan_, place, "turn");
  }
  if (view == view_) return rays_;
  const RayTrace picture = parallel_rays(wanted);
  rays_.clear();
  for (const uint32_t pixel : pixels_) rays_.push_back(quantise(picture.rays[pixel], map_, format));
  view_ = view;
  hits_digest_.clear();
  return rays_;
}

Workload ViewRunner::work_at(const StudyPlace& place, const Architecture& architecture) {
  Workload work;
  work.pyramid = &pyramid_;
  work.map = map_;
  set_numbers(work, architecture);
  work.rays = rays_at(place, work.format);
  work.pixel_of_ray = pixels_;
  work.width = kViewWidth;
  work.height = kViewHeight;
  const Algorithm algorithm = parse_algorithm(value(place, "algorithm"));
  work.schedule = algorithm.schedule;
  work.depth = number_at(plan_, place, "depth");
  if (algorithm.search) {
    work.search = algorithm.search;
    work.search_map =
        &search_maps_.try_emplace(algorithm.search->kind, *algorithm.search, pyramid_, map_.address_mode)
             .first->second;
  }
  return work;
}

void ViewRunner::check_same_hits(const StudyPlace& place, std::span<const HitRecord> hits) {
  Digest digest;
  for (const HitRecord& hit : hits) add_answer(digest, hit);
  const std::string found = digest.hex();
  const std::string& algorithm = value(place, "algorithm");
  if (hits_digest_.empty()) {
    hits_digest_ = found;
    first_algorithm_ = algorithm;
  }
  if (found != hits_digest_) {
    throw Error(ExitCode::kMismatch, algorithm + " and " + first_algorithm_ +
                                         " find different hits on the same rays, " + value(place, "map") +
                                         " " + view_ + ": a fault of the simulator; please report it.");
  }
}

void ViewRunner::check_laws(const Workload& work, const Architecture& architecture, Fidelity fidelity,
                            const Outcome& outcome) {
  const std::vector<std::string> broken = broken_laws(work, architecture, fidelity, outcome);
  if (!broken.empty()) {
    throw Error(ExitCode::kMismatch,
                "The accounting of a case of the study breaks its laws; the first: " + broken.front());
  }
}

int64_t ViewRunner::simt_slots(std::span<const HitRecord> hits) const {
  std::vector<uint32_t> longest(kViewWidth / kWarpWidth * (kViewHeight / kWarpHeight), 0);
  std::vector<bool> used(longest.size(), false);
  for (size_t k = 0; k < hits.size(); ++k) {
    const uint32_t warp = warp_of(pixels_[k]);
    longest[warp] = std::max(longest[warp], hits[k].steps);
    used[warp] = true;
  }
  int64_t slots = 0;
  for (size_t k = 0; k < longest.size(); ++k)
    slots += used[k] ? int64_t{kWarpWidth} * kWarpHeight * longest[k] : 0;
  return slots;
}

}  // namespace cuesta
