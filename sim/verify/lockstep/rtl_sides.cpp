#include "sim/verify/lockstep/rtl_sides.h"

#include <algorithm>
#include <charconv>

#include "models/common/error.h"
#include "models/common/words.h"
#include "sim/hardware/choose_set.h"
#include "sim/verify/lockstep/rig.h"

namespace cuesta {
namespace {

constexpr Cycle kWavesBefore = 64, kWavesBehind = 16;
constexpr std::string_view kUnitNames[] = {"hmt_top", "traverse"};

/// "traverse[1]": 1.
int pipeline_of(const std::string& unit) {
  const size_t bracket = unit.find('[');
  int pipeline = 0;
  if (bracket != std::string::npos)
    std::from_chars(unit.data() + bracket + 1, unit.data() + unit.size(), pipeline);
  return pipeline;
}

}  // namespace

std::string_view name_of(HardwareUnit unit) { return kUnitNames[static_cast<size_t>(unit)]; }

HardwareUnit parse_hardware_unit(const std::string& name) {
  for (size_t k = 0; k < std::size(kUnitNames); ++k) {
    if (name == kUnitNames[k]) return static_cast<HardwareUnit>(k);
  }
  const std::string near = did_you_mean(name, kUnitNames);
  throw usage_error("There is no hardware for `" + printable(name) + "`; accepted are hmt_top, traverse" +
                    (near.empty() ? "." : near));
}

std::array<LockstepSide, 2> rtl_sides(HardwareUnit unit) {
  auto model = [](LockstepMachine& m) { m.architecture.units = {}; };
  auto hardware = [unit](LockstepMachine& m) {
    m.architecture.units = {};
    (unit == HardwareUnit::kHmtTop ? m.architecture.units.hmt_top : m.architecture.units.traverse) =
        Implementation::kRtl;
  };
  return {LockstepSide{"model", model}, LockstepSide{"RTL", hardware}};
}

RtlStructure structure_of(const rtl::RtlParameters& p, HardwareUnit unit) {
  RtlStructure structure;
  structure.max_level = p.max_level;
  structure.height_bits = p.height_bits;
  structure.setup_inside = unit == HardwareUnit::kHmtTop;
  Architecture& a = structure.architecture;
  a.ray_setup = {p.setup_latency, p.setup_interval, p.setup_queue};
  a.traverse.stages = p.stages;
  a.traverse.contexts = p.contexts;
  a.traverse.fraction_bits = p.fraction_bits;
  a.traverse.direction_bits = p.direction_bits;
  a.traverse.mantissa_bits = p.mantissa_bits;
  a.traverse.tile_bits = p.tile_bits;
  a.height_l1 = {p.size_bytes, p.line_bytes, p.ways, p.mshrs};
  return structure;
}

std::vector<rtl::RtlSet> compiled_sets(const std::vector<std::string>& names) {
  const auto all = rtl::rtl_sets();
  if (all.empty()) {
    throw usage_error("There is nothing to hold the model against: " + rtl::why_there_is_no_set() + ".");
  }
  if (names.empty()) return {all.begin(), all.end()};
  std::vector<rtl::RtlSet> found;
  for (const std::string& name : names) {
    const auto set = std::ranges::find(all, name, &rtl::RtlSet::name);
    if (set == all.end()) {
      std::string known;
      for (const rtl::RtlSet& one : all) known += (known.empty() ? "" : ", ") + std::string(one.name);
      throw usage_error("There is no compiled set `" + printable(name) + "`; accepted are " + known +
                        ", or a row of rtl/sets.csv named in the CMake option CUESTA_RTL_SETS.");
    }
    found.push_back(*set);
  }
  return found;
}

bool leave_waves(const LockstepCase& one, const LockstepSide& side, const Difference& first,
                 const std::string& file) {
  LockstepMachine machine = one.machine;
  if (side.change) side.change(machine);
  if (!rtl::has_rtl(machine.architecture)) return false;
  const WaveWindow waves{file, pipeline_of(first.unit), std::max<Cycle>(0, first.cycle - kWavesBefore),
                         first.cycle + kWavesBehind};
  LockstepRig rig(one, machine, std::make_shared<LockstepWork>(one, machine), waves);
  rig.step_by(1);
  rig.advance(waves.last + 2);
  return true;
}

}  // namespace cuesta
