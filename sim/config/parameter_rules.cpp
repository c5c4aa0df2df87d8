#include <bit>
#include <string>
#include <vector>

#include "models/rays/hit.h"
#include "sim/config/parameters.h"

namespace cuesta {
namespace {

std::string named(std::string_view path, int64_t value) {
  return "`" + std::string(path) + "` = " + std::to_string(value);
}

}  // namespace

std::string why_unused(const Parameter& parameter, const Architecture& architecture, bool with_time) {
  if (!with_time && parameter.use == ParameterUse::kTime) return "functional fidelity has no time";
  const RayDispatchParameters& dispatch = architecture.ray_dispatch;
  if (parameter.path == "ray_dispatch.tile_size" && dispatch.order != DispatchOrder::kTile &&
      dispatch.assign != DispatchAssign::kInterleave) {
    return "neither is `ray_dispatch.order` \"tile\" nor `ray_dispatch.assign` \"interleave\"";
  }
  if (parameter.path == "units.traverse" && architecture.units.hmt_top == Implementation::kRtl) {
    return "`units.hmt_top` = \"rtl\" holds its own traverse";
  }
  return "";
}

std::vector<std::string> contradictions(const Architecture& a) {
  std::vector<std::string> found;
  if (a.traverse.contexts < a.traverse.stages) {
    found.push_back(named("traverse.contexts", a.traverse.contexts) + " is below " +
                    named("traverse.stages", a.traverse.stages) +
                    ": the pipe could never be full; accepted is at least as many contexts as stages.");
  }
  if (a.traverse.mantissa_bits == 1) {
    found.push_back(named("traverse.mantissa_bits", 1) +
                    "; accepted is 0 (the map's height bits + 4) or 2 to 24.");
  }
  const HeightL1Parameters& l1 = a.height_l1;
  const int64_t set_bytes = int64_t{l1.line_bytes} * l1.ways;
  if (l1.size_bytes % set_bytes != 0 ||
      !std::has_single_bit(static_cast<uint64_t>(l1.size_bytes / set_bytes))) {
    found.push_back(named("height_l1.size_bytes", l1.size_bytes) + " is not sets * " +
                    named("height_l1.ways", l1.ways) + " * " + named("height_l1.line_bytes", l1.line_bytes) +
                    " with a power of two of sets; accepted are " + std::to_string(set_bytes) + ", " +
                    std::to_string(2 * set_bytes) + ", " + std::to_string(4 * set_bytes) + " ... bytes.");
  }
  const DramParameters& dram = a.dram;
  const std::pair<std::string_view, int64_t> accesses[] = {
      {"height_l1.line_bytes", l1.line_bytes}, {"result_writer.burst_bytes", a.result_writer.burst_bytes}};
  for (const auto& [path, bytes] : accesses) {
    if (dram.row_bytes < bytes) {
      found.push_back(named("dram.row_bytes", dram.row_bytes) + " is below " + named(path, bytes) +
                      "; accepted is a row that holds a whole access.");
    }
    if (bytes < dram.bus_bytes) {
      found.push_back(named(path, bytes) + " is below " + named("dram.bus_bytes", dram.bus_bytes) +
                      "; accepted is an access of at least one memory clock.");
    }
  }
  if (dram.tRAS < dram.tRCD) {
    found.push_back(named("dram.tRAS", dram.tRAS) + " is below " + named("dram.tRCD", dram.tRCD) +
                    ": the row would close before it can be read; accepted is at least tRCD.");
  }
  return found;
}

}  // namespace cuesta
