#include "sim/explore/study/plan_parts.h"

#include <fmt/format.h>

#include <iterator>

namespace cuesta {
namespace {

constexpr double kTilesAcross = 2;
constexpr double kTurnDegrees = 25;

}  // namespace

StudyData begin_plan(std::string_view study, std::string question, bool quick) {
  StudyData plan;
  plan.study = study;
  plan.question = std::move(question);
  plan.amount = quick ? "quick" : "published";
  return plan;
}

void add_conditions(StudyData& plan, std::vector<std::string> sentences) {
  std::ranges::move(sentences, std::back_inserter(plan.conditions));
}

ParallelView study_view(double angle_degrees, double depth) {
  return {angle_degrees, kTurnDegrees, depth, kTilesAcross, kViewWidth, kViewHeight};
}

std::vector<uint32_t> picture_pixels(bool sampled) {
  std::vector<uint32_t> pixels;
  for (uint32_t k = 0; k < kViewWidth * kViewHeight; ++k) {
    const uint32_t across = k % kViewWidth / kWarpWidth, down = k / kViewWidth / kWarpHeight;
    if (!sampled || (across % 2 == 0 && down % 2 == 0)) pixels.push_back(k);
  }
  return pixels;
}

std::vector<std::string> view_conditions() {
  return {
      fmt::format("Rays: a picture of {} x {} square pixels in parallel projection, two tiles across, turned "
                  "by {} degrees around the normal, of an endless plane of tiles (wrap): every ray has the "
                  "case's angle, and every ray hits.",
                  kViewWidth, kViewHeight, kTurnDegrees),
      "Maps: generated, seed 1, 8 bits, square; full resolution is traced whatever a pixel covers (no level "
      "of detail).",
      "Traversal: fixed point with the default widths. In each view every algorithm found the same hits, bit "
      "for bit."};
}

StudyAxis map_axis(std::vector<std::string> kinds) {
  return {"map", "", "Generated height map, as `cuesta heightmap make` calls it.", std::move(kinds)};
}

StudyAxis size_axis(std::vector<std::string> texels) {
  return {"size", "texels", "Side of the square map: the same tile in more detail.", std::move(texels)};
}

StudyAxis depth_axis(std::vector<std::string> tiles) {
  return {"depth", "tiles", "Thickness of the relief in widths of a tile.", std::move(tiles)};
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

std::vector<std::string> study_maps() {
  return {"fractal", "rocks", "text", "spikes", "hawaii", "rockbump", "logo", "noise", "terraces"};
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

StudyCounter simt_counter() {
  return {
      "simt_slots", "steps",
      fmt::format("Steps of warps of {} x {} neighbouring pixels in which every lane waits for the longest.",
                  kWarpWidth, kWarpHeight)};
}

}  // namespace cuesta
