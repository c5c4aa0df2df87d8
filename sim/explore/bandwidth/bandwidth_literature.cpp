#include <fmt/format.h>

#include "reports/html/html_text.h"
#include "reports/study/study_parts.h"
#include "sim/explore/bandwidth/bandwidth.h"

namespace cuesta::html {
namespace {

std::string frame_rates(const StudyTable& table) {
  std::string text;
  for (const char* base : {"oh2006", "tevs2008"}) {
    const Spread found = spread_against(table, "yun2013", base, "cycles", {{"machine", "mobile"}});
    if (found.views == 0) continue;
    text += fmt::format("against {}: {} at most ({}), median {}, least {}. ", base,
                        percent_change(1 / found.least), escape(view_name(table, found.least_at)),
                        percent_change(1 / found.median), percent_change(1 / found.largest));
  }
  return "rays per second of yun2013 on mobile " + text;
}

std::string coherent_in_warps(const StudyTable& table) {
  return "yun2013-coherent against yun2013: steps " +
         spread_text(spread_against(table, "yun2013-coherent", "yun2013", "steps", {{"machine", "mobile"}})) +
         "; cycles here " +
         spread_text(
             spread_against(table, "yun2013-coherent", "yun2013", "cycles", {{"machine", "mobile"}})) +
         "; steps of warps " +
         spread_text(
             spread_against(table, "yun2013-coherent", "yun2013", "simt_slots", {{"machine", "mobile"}})) +
         ".";
}

}  // namespace

const std::vector<Statement>& statements_on_cycles() {
  static const std::vector<Statement> all = {
      {"Yun et al. 2013", "printed",
       "Frame rate up to +85 % over Oh, +56 % over Tevs (GTX 460; scenes not at hand).", frame_rates,
       "A GPU of warps with its own caches against one pipeline here: not the same machine, not the same "
       "scenes. Here a "
       "ray cannot be faster than ray_setup lets rays in, which caps what fewer steps can give in front "
       "views."},
      {"Yun et al. 2013", "printed",
       "Selective level-up for hardware, coherent level-up for programmable GPUs.", coherent_in_warps,
       "Warps are counted as the steps of their longest ray: instructions, divergence within a step and "
       "memory are not "
       "in it. The pipeline here never waits for a neighbour's ray."},
  };
  return all;
}

}  // namespace cuesta::html
