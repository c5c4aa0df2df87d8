#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "models/heightmap/texel_layout.h"
#include "models/units/parameter_table.h"

namespace cuesta {

struct MachineParameters {
  int pipelines = 1;
  int clock_mhz = 500;
  int64_t no_progress_cycles = 1'000'000;  ///< stop with exit 4 after so many cycles without a finished step
};

struct TexelParameters {
  TexelLayoutKind layout = TexelLayoutKind::kRowMajor;
};

inline constexpr auto kTexelLayoutNames = [] {
  std::array<std::string_view, kTexelLayouts.size()> names;
  for (size_t k = 0; k < names.size(); ++k) names[k] = kTexelLayouts[k].name;
  return names;
}();

/// What stands in a unit's place: the model, or Verilated RTL, which is equal to it cycle by cycle.
enum class Implementation : uint8_t { kModel, kRtl };

inline constexpr std::string_view kImplementationNames[] = {"model", "rtl"};

struct UnitParameters {
  Implementation hmt_top = Implementation::kModel;   ///< ray_setup, traverse and height_l1 of every pipeline
  Implementation traverse = Implementation::kModel;  ///< between the model's ray_setup and height_l1
};

namespace parameter {

inline constexpr std::string_view kEqual = "the hardware is equal to the model, cycle by cycle";

inline constexpr ParameterRow<MachineParameters> kMachineParameters[] = {
    number<&MachineParameters::pipelines>("machine.pipelines", 1, 64, kTime, "",
                                          "Pipelines (ray_setup, traverse, height_l1, hit_queue, "
                                          "result_writer) behind one ray_dispatch and over one dram.",
                                          kOurs),
    inert(number<&MachineParameters::clock_mhz>("machine.clock_mhz", 1, 10'000, kTime, "MHz",
                                                "Clock of the machine, which dram's is a ratio of.", kOurs),
          "turns cycles into rays/s, frames/s and GB/s, and changes no count"),
    inert(number<&MachineParameters::no_progress_cycles>(
              "machine.no_progress_cycles", 1'000, 1'000'000'000'000, kTime, "cycles",
              "The run stops with exit code 4 after so many cycles in which no step finishes.", kOurs),
          "ends a run that stands still, and changes no run that goes on"),
};

inline constexpr ParameterRow<TexelParameters> kTexelParameters[] = {
    name<&TexelParameters::layout>("texels.layout", kTexelLayoutNames, kTime,
                                   "Where each pyramid texel lies in memory.", kOurs),
};

inline constexpr ParameterRow<UnitParameters> kUnitParameters[] = {
    inert(
        name<&UnitParameters::hmt_top>(
            "units.hmt_top", kImplementationNames, kTime,
            "What stands in the place of ray_setup, traverse and height_l1 of every pipeline: the model, or "
            "rtl/hmt_top.sv, Verilated; one of the compiled sets.",
            kOurs),
        kEqual),
    inert(name<&UnitParameters::traverse>("units.traverse", kImplementationNames, kTime,
                                          "What stands in the place of traverse, between the "
                                          "model's ray_setup and height_l1: the model, or "
                                          "rtl/traverse/traverse.sv, Verilated.",
                                          kOurs),
          kEqual),
};

}  // namespace parameter

}  // namespace cuesta
