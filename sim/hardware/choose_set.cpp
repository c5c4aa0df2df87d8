#include "sim/hardware/choose_set.h"

#include <algorithm>

#include "models/common/error.h"
#include "sim/config/on_architecture.h"

namespace cuesta::rtl {
namespace {

std::string choice_text(const Architecture& architecture) {
  return architecture.units.hmt_top == Implementation::kRtl ? "units.hmt_top = \"rtl\""
                                                            : "units.traverse = \"rtl\"";
}

/// What the hardware has no wires for, as the end of a sentence; empty: nothing.
std::string beyond_rtl(const Architecture& a, const Workload& work) {
  if (a.traverse.arithmetic != Arithmetic::kFixed)
    return "traverse.arithmetic is floating point; accepted is fixed.";
  const AddressMode mode = work.map.address_mode;
  if (mode != AddressMode::kWrap && mode != AddressMode::kBorder)
    return "the scene's address mode is " + std::string(name_of(mode)) + "; accepted are wrap, border.";
  if (!work.map.is_square_power_of_two()) {
    return "the map has " + std::to_string(work.map.width) + " x " + std::to_string(work.map.height) +
           " texels; accepted are squares whose side is a power of two.";
  }
  if (work.search)
    return "the algorithm is a search, " + name_of(*work.search) + "; accepted are exact algorithms.";
  if (work.schedule.fetch != FetchRule::kTexel) return "traverse.fetch is quad; accepted is texel.";
  if (work.schedule.down == kDownCommon) return "traverse.down is common; accepted are 1, 2, 3.";
  if (a.texels.layout != TexelLayoutKind::kRowMajor && a.texels.layout != TexelLayoutKind::kMorton) {
    return "texels.layout is " + std::string(name_of(a.texels.layout)) + "; accepted are row_major, morton.";
  }
  return {};
}

}  // namespace

std::vector<std::string> differences(const RtlSet& set, const Architecture& a, const MapShape& map) {
  const RtlParameters& p = set.parameters;
  const NumberFormat format = number_format(a.traverse, map);
  std::vector<std::string> found;
  auto compare = [&](const char* key, int wanted, int compiled) {
    if (wanted != compiled) {
      found.push_back(std::string(key) + " is " + std::to_string(wanted) + ", compiled is " +
                      std::to_string(compiled));
    }
  };
  compare("traverse.stages", a.traverse.stages, p.stages);
  compare("traverse.contexts", a.traverse.contexts, p.contexts);
  compare("traverse.fraction_bits", format.fraction_bits, p.fraction_bits);
  compare("traverse.direction_bits", format.direction_bits, p.direction_bits);
  compare("traverse.mantissa_bits", format.mantissa_bits, p.mantissa_bits);
  compare("traverse.tile_bits", format.tile_bits, p.tile_bits);
  if (map.root_level > p.max_level) {
    found.push_back("the map's side is " + std::to_string(map.width) + ", compiled are up to " +
                    std::to_string(1 << p.max_level));
  }
  if (map.bits > p.height_bits || (map.bits <= 8 && p.height_bits > 8)) {
    found.push_back("the map's heights have " + std::to_string(map.bits) + " bits, compiled are " +
                    (p.height_bits > 8 ? "9 to " : "1 to ") + std::to_string(p.height_bits));
  }
  if (a.units.hmt_top != Implementation::kRtl) return found;
  compare("ray_setup.latency_cycles", a.ray_setup.latency_cycles, p.setup_latency);
  compare("ray_setup.interval_cycles", a.ray_setup.interval_cycles, p.setup_interval);
  compare("ray_setup.queue_depth", a.ray_setup.queue_depth, p.setup_queue);
  compare("height_l1.size_bytes", a.height_l1.size_bytes, p.size_bytes);
  compare("height_l1.line_bytes", a.height_l1.line_bytes, p.line_bytes);
  compare("height_l1.ways", a.height_l1.ways, p.ways);
  compare("height_l1.mshrs", a.height_l1.mshrs, p.mshrs);
  return found;
}

std::string why_there_is_no_set() {
#ifdef CUESTA_HARDWARE_MODULE
  return "the Verilated hardware, " CUESTA_HARDWARE_MODULE
         ".so, is not beside this program; `cmake --build --preset release --target " CUESTA_HARDWARE_MODULE
         "` builds it";
#else
  return "this program is built without RTL (CMake option CUESTA_RTL)";
#endif
}

const RtlSet& choose_set(const Architecture& architecture, const Workload& work) {
  const std::string choice = choice_text(architecture);
  if (rtl_sets().empty()) {
    throw usage_error(choice + ": " + why_there_is_no_set() +
                      "; accepted without is \"model\", which is equal to it cycle by cycle.");
  }
  const std::string beyond = beyond_rtl(architecture, work);
  if (!beyond.empty()) throw usage_error(choice + ": " + beyond);

  const RtlSet* nearest = nullptr;
  std::vector<std::string> fewest;
  for (const RtlSet& set : rtl_sets()) {
    std::vector<std::string> found = differences(set, architecture, work.map);
    if (nearest == nullptr || found.size() < fewest.size()) {
      nearest = &set;
      fewest = std::move(found);
    }
    if (fewest.empty()) return *nearest;
  }
  std::string text = choice + ": no compiled set of the hardware is this machine; the nearest is " +
                     std::string(nearest->name) + ": ";
  for (const std::string& difference : fewest) text += difference + "; ";
  throw usage_error(text +
                    "accepted are a set's values, or a row of rtl/sets.csv named in the CMake option "
                    "CUESTA_RTL_SETS.");
}

}  // namespace cuesta::rtl
