#include "sim/explore/study/view_bench.h"
#include "sim/config/on_architecture.h"

#include <algorithm>
#include <charconv>

#include "models/algorithms/schedule.h"
#include "models/common/digest.h"
#include "models/common/error.h"
#include "models/heightmap/generator.h"
#include "models/work/outcome.h"

namespace cuesta {
namespace {

constexpr int kWidth = 256, kHeight = 128;
constexpr double kTilesAcross = 2;
constexpr double kTurnDegrees = 25;
constexpr int kHeightBits = 8;
constexpr uint32_t kWarpWidth = 8, kWarpHeight = 4;

double number(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Warps side by side, then below each other.
uint32_t warp_of(uint32_t pixel) {
  return pixel / kWidth / kWarpHeight * (kWidth / kWarpWidth) + pixel % kWidth / kWarpWidth;
}

}  // namespace

ParallelView study_view(double angle_degrees, double depth) {
  return {angle_degrees, kTurnDegrees, depth, kTilesAcross, kWidth, kHeight};
}

StudyAxis map_axis(std::vector<std::string> names) {
  return {"map", "", "Generated height map, as `cuesta heightmap make` calls it.", std::move(names)};
}

StudyAxis size_axis(std::vector<std::string> texels) {
  return {"size", "texels", "Side of the square map: the same tile in more detail.", std::move(texels)};
}

StudyAxis depth_axis(std::vector<std::string> values) {
  return {"depth", "tiles", "Thickness of the relief in widths of a tile.", std::move(values)};
}

StudyAxis angle_axis(std::vector<std::string> degrees) {
  return {"angle", "degrees", "Between the view and the surface's normal: 0 is the front view.",
          std::move(degrees)};
}

StudyAxis turn_axis(std::vector<std::string> degrees) {
  return {"turn", "degrees", "Of the view around the normal: at 0 rays run along an axis of the map.",
          std::move(degrees)};
}

StudyAxis algorithm_axis(std::vector<std::string> ids) {
  return {"algorithm", "", "Schedule of the traversal, as `cuesta list algorithms` calls it.",
          std::move(ids)};
}

std::vector<std::string> study_algorithms() {
  return {"dda",
          "oh2006",
          "drobot2009",
          "drobot2009-interval",
          "tevs2008",
          "tevs2008-both-even",
          "yun2013",
          "yun2013-coherent",
          "yun2013-start",
          "yun2013-down",
          "yun2013-up",
          "yun2013-up-selective",
          "yun2013-coherent-up"};
}

bool is_at(const StudyData& plan, const StudyPlace& place, std::string_view axis, std::string_view value) {
  const size_t index = axis_index(plan, axis);
  return plan.axes[index].values[place[index]] == value;
}

double number_at(const StudyData& plan, const StudyPlace& place, std::string_view axis) {
  const size_t index = axis_index(plan, axis);
  return number(plan.axes[index].values[place[index]]);
}

std::vector<uint32_t> picture_pixels(bool sampled) {
  std::vector<uint32_t> pixels;
  for (uint32_t k = 0; k < kWidth * kHeight; ++k) {
    const uint32_t across = k % kWidth / kWarpWidth, down = k / kWidth / kWarpHeight;
    if (!sampled || (across % 2 == 0 && down % 2 == 0)) pixels.push_back(k);
  }
  return pixels;
}

std::vector<std::string> view_conditions() {
  return {
      "Rays: a picture of 256 x 128 square pixels in parallel projection, two tiles across, turned by 25 "
      "degrees around the normal, of an endless plane of tiles (wrap): every ray has the case's angle, and "
      "every ray hits.",
      "Maps: generated, seed 1, 8 bits, square; full resolution is traced whatever a pixel covers (no level "
      "of detail).",
      "Traversal: fixed point with the default widths. In each view every algorithm found the same hits, bit "
      "for bit."};
}

ViewBench::ViewBench(const StudyData& plan, std::span<const uint16_t> size_and_map,
                     std::vector<uint32_t> pixels)
    : plan_(plan), pixels_(std::move(pixels)) {
  turns_ = std::ranges::any_of(plan.axes, [](const StudyAxis& axis) { return axis.name == "turn"; });
  const std::string& size =
      plan.axes[axis_index(plan, "size")].values[size_and_map[axis_index(plan, "size")]];
  const std::string& map = plan.axes[axis_index(plan, "map")].values[size_and_map[axis_index(plan, "map")]];
  const int side = static_cast<int>(number(size));
  const HeightGrid grid = generate(map, side, side, kHeightBits, 1);
  pyramid_ = build_max_pyramid(grid);
  map_ = {grid.width, grid.height, pyramid_.root_level(), grid.bits, AddressMode::kWrap};
}

const std::string& ViewBench::value(const StudyPlace& place, std::string_view axis) const {
  const size_t index = axis_index(plan_, axis);
  return plan_.axes[index].values[place[index]];
}

const std::vector<MachineRay>& ViewBench::rays_at(const StudyPlace& place, const NumberFormat& format) {
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

Workload ViewBench::work_at(const StudyPlace& place, const Architecture& architecture) {
  Workload work;
  work.pyramid = &pyramid_;
  work.map = map_;
  set_numbers(work, architecture);
  work.rays = rays_at(place, work.format);
  work.pixel_of_ray = pixels_;
  work.width = kWidth;
  work.height = kHeight;
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

void ViewBench::check_same_hits(const StudyPlace& place, std::span<const HitRecord> hits) {
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

int64_t ViewBench::simt_slots(std::span<const HitRecord> hits) const {
  std::vector<uint32_t> longest(kWidth / kWarpWidth * (kHeight / kWarpHeight), 0);
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
