#include "sim/config/parameters.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

#include "models/common/words.h"
#include "models/heightmap/texel_layout.h"

namespace cuesta {
namespace {

constexpr auto kHits = ParameterUse::kHits;
constexpr auto kTime = ParameterUse::kTime;

// Each list in the order of its enum.
constexpr std::string_view kOrders[] = {"scanline", "tile", "morton", "hilbert"};
constexpr std::string_view kAssigns[] = {"first_free", "interleave"};
constexpr std::string_view kArithmetics[] = {"fixed", "float", "double"};
constexpr auto kLayouts = [] {
  std::array<std::string_view, kTexelLayouts.size()> names;
  for (size_t k = 0; k < names.size(); ++k) names[k] = kTexelLayouts[k].name;
  return names;
}();

constexpr std::string_view kStarts[] = {"algorithm", "root", "leaf", "span"};
constexpr std::string_view kDowns[] = {"algorithm", "1", "2", "3", "common"};
constexpr std::string_view kUps[] = {"algorithm", "never",     "always",         "interval", "even-axis",
                                     "both-even", "selective", "selective-even", "coherent"};
constexpr std::string_view kStops[] = {"algorithm", "0", "1", "2",  "3",  "4",  "5",  "6",
                                       "7",         "8", "9", "10", "11", "12", "13", "14"};
constexpr std::string_view kImplementations[] = {"model", "rtl"};
constexpr std::string_view kFetches[] = {"algorithm", "texel", "quad"};
static_assert(std::size(kStops) == kMostStopLevel + 2);
constexpr int down_value(int index) { return index == 3 ? kDownCommon : index + 1; }

template <auto Section, auto Member>
struct Bound {
  using Value = std::remove_cvref_t<decltype((std::declval<Architecture&>().*Section).*Member)>;
  static int64_t get(const Architecture& a) { return static_cast<int64_t>((a.*Section).*Member); }
  static void set(Architecture& a, int64_t value) { (a.*Section).*Member = static_cast<Value>(value); }
};

template <auto Section, auto Member>
constexpr Parameter number(std::string_view path, int64_t low, int64_t high, ParameterUse use,
                           std::string_view unit, std::string_view meaning, std::string_view source) {
  using B = Bound<Section, Member>;
  return {path, low, high, {}, false, use, unit, meaning, source, B::get, B::set};
}

template <auto Section, auto Member>
constexpr Parameter power(std::string_view path, int64_t low, int64_t high, std::string_view unit,
                          std::string_view meaning, std::string_view source) {
  using B = Bound<Section, Member>;
  return {path, low, high, {}, true, kTime, unit, meaning, source, B::get, B::set};
}

template <auto Section, auto Member>
constexpr Parameter name(std::string_view path, std::span<const std::string_view> names, ParameterUse use,
                         std::string_view meaning, std::string_view source) {
  using B = Bound<Section, Member>;
  return {path,   0,     static_cast<int64_t>(names.size()) - 1, names, false, use, "", meaning, source,
          B::get, B::set};
}

/// A choice of the schedule; the first name, none, leaves it to the algorithm.
template <auto Member, int (*ValueOf)(int)>
struct Choice {
  using Value =
      typename std::remove_cvref_t<decltype(std::declval<TraverseParameters&>().*Member)>::value_type;
  static int64_t get(const Architecture& a) {
    const auto& value = a.traverse.*Member;
    int index = 0;
    while (value && static_cast<Value>(ValueOf(index)) != *value) ++index;
    return value ? index + 1 : 0;
  }
  static void set(Architecture& a, int64_t index) {
    auto& value = a.traverse.*Member;
    value.reset();
    if (index > 0) value = static_cast<Value>(ValueOf(static_cast<int>(index) - 1));
  }
};

constexpr int same(int index) { return index; }

template <auto Member, int (*ValueOf)(int) = same>
constexpr Parameter choice(std::string_view path, std::span<const std::string_view> names,
                           std::string_view meaning) {
  using C = Choice<Member, ValueOf>;
  return {path,   0,     static_cast<int64_t>(names.size()) - 1, names, false, kHits, "", meaning, "ours",
          C::get, C::set};
}

constexpr Parameter inert(Parameter parameter, std::string_view reason) {
  parameter.inert = reason;
  return parameter;
}

using A = Architecture;
using Machine = MachineParameters;
using Dispatch = RayDispatchParameters;
using Setup = RaySetupParameters;
using Traverse = TraverseParameters;
using L1 = HeightL1Parameters;
using Writer = ResultWriterParameters;
using Dram = DramParameters;

constexpr std::string_view kOurs = "ours";
constexpr std::string_view kEqual = "the hardware is equal to the model, cycle by cycle";
constexpr std::string_view kDatasheet = "ours; the default is DDR3-1600 11-11-11 (JEDEC JESD79-3) at 800 MHz";

constexpr auto kParameters = std::to_array<Parameter>({
    number<&A::machine, &Machine::pipelines>(
        "machine.pipelines", 1, 64, kTime, "",
        "Pipelines (ray_setup, traverse, height_l1, hit_queue) behind one ray_dispatch and over one dram.",
        kOurs),
    inert(
        number<&A::machine, &Machine::clock_mhz>("machine.clock_mhz", 1, 10'000, kTime, "MHz",
                                                 "Clock of the machine, which dram's is a ratio of.", kOurs),
        "turns cycles into rays/s, frames/s and GB/s, and changes no count"),
    inert(number<&A::machine, &Machine::no_progress_cycles>(
              "machine.no_progress_cycles", 1'000, 1'000'000'000'000, kTime, "cycles",
              "The run stops with exit code 4 after so many cycles in which no step finishes.", kOurs),
          "ends a run that stands still, and changes no run that goes on"),

    name<&A::ray_dispatch, &Dispatch::order>("ray_dispatch.order", kOrders, kTime,
                                             "Order in which rays leave the trace: by scanline, by tile, or "
                                             "along a space-filling curve over the image.",
                                             "Hilbert curve: Warren, Hacker's Delight, ch. 16"),
    name<&A::ray_dispatch, &Dispatch::assign>("ray_dispatch.assign", kAssigns, kTime,
                                              "Which pipeline a ray goes to: the lowest one with a free "
                                              "place, or its tile's number modulo pipelines.",
                                              kOurs),
    power<&A::ray_dispatch, &Dispatch::tile_size>(
        "ray_dispatch.tile_size", 1, 256, "pixels",
        "Side of a square tile of pixels; for order = \"tile\" and assign = \"interleave\".", kOurs),
    number<&A::ray_dispatch, &Dispatch::queue_depth>(
        "ray_dispatch.queue_depth", 1, 1024, kTime, "rays",
        "Rays that wait in front of each ray_setup: the credits that ray_dispatch starts with.", kOurs),
    number<&A::ray_dispatch, &Dispatch::latency_cycles>(
        "ray_dispatch.latency_cycles", 1, 1000, kTime, "cycles",
        "From ray_dispatch to the queue in front of ray_setup.", kOurs),
    number<&A::ray_dispatch, &Dispatch::credit_latency_cycles>(
        "ray_dispatch.credit_latency_cycles", 1, 1000, kTime, "cycles",
        "From a place that gets free to the ray_dispatch that may fill it.", kOurs),

    number<&A::ray_setup, &Setup::latency_cycles>(
        "ray_setup.latency_cycles", 1, 1000, kTime, "cycles",
        "From a ray's entry to its readiness for traverse: clip, three reciprocals, start level.", kOurs),
    number<&A::ray_setup, &Setup::interval_cycles>(
        "ray_setup.interval_cycles", 1, 1000, kTime, "cycles",
        "Between two rays that enter: set by the number of reciprocal units.", kOurs),
    number<&A::ray_setup, &Setup::queue_depth>("ray_setup.queue_depth", 1, 1024, kTime, "rays",
                                               "Rays in set-up or waiting for a context of traverse.", kOurs),

    name<&A::traverse, &Traverse::arithmetic>(
        "traverse.arithmetic", kArithmetics, kHits,
        "Numbers that traversal computes with: the hardware's fixed point, or floating point for comparison.",
        kOurs),
    number<&A::traverse, &Traverse::stages>("traverse.stages", 1, 256, kTime, "cycles",
                                            "From one step of a ray to its next, on a hit in height_l1.",
                                            kOurs),
    number<&A::traverse, &Traverse::contexts>(
        "traverse.contexts", 1, 4096, kTime, "rays",
        "Rays resident in a pipeline: in the pipe, or parked on a miss.", kOurs),
    number<&A::traverse, &Traverse::fraction_bits>(
        "traverse.fraction_bits", 0, 12, kHits, "bits",
        "Fraction bits of a ray's origin, in texels and in height units.", kOurs),
    number<&A::traverse, &Traverse::direction_bits>("traverse.direction_bits", 8, 32, kHits, "bits",
                                                    "Bits of the largest component of a ray's direction.",
                                                    kOurs),
    number<&A::traverse, &Traverse::mantissa_bits>(
        "traverse.mantissa_bits", 0, 24, kHits, "bits",
        "Bits of a reciprocal's mantissa; 0 stands for the map's height bits + 4, 1 is not accepted.", kOurs),
    number<&A::traverse, &Traverse::tile_bits>("traverse.tile_bits", 0, 20, kHits, "bits",
                                               "A ray crosses at most 2^tile_bits tiles of the map.", kOurs),
    choice<&Traverse::start>(
        "traverse.start", kStarts,
        "Where rays enter the pyramid: \"algorithm\" is the algorithm's own choice, here and in "
        "the four below; another value takes its place, and the run is named by what results."),
    choice<&Traverse::down, down_value>("traverse.down", kDowns,
                                        "Levels per descent before the first crossing; common: to the "
                                        "smallest node that holds the ray's cell and "
                                        "its end cell. Without effect from the leaves."),
    choice<&Traverse::up>("traverse.up", kUps, "When a ray that has crossed goes up one level."),
    choice<&Traverse::stop_level>(
        "traverse.stop_level", kStops,
        "Level of the leaves; above 0 they are the texels of the mean pyramid. At most the map's root."),
    choice<&Traverse::fetch>("traverse.fetch", kFetches,
                             "What a visit reads: its texel, or its 2 x 2 siblings, which the ray keeps."),

    power<&A::height_l1, &L1::size_bytes>("height_l1.size_bytes", 16, 1 << 24, "bytes",
                                          "Data bytes of each pipeline's private cache of pyramid texels.",
                                          kOurs),
    power<&A::height_l1, &L1::line_bytes>("height_l1.line_bytes", 16, 1024, "bytes",
                                          "Bytes of a line: what one miss fetches.", kOurs),
    number<&A::height_l1, &L1::ways>("height_l1.ways", 1, 64, kTime, "",
                                     "Lines of a set; the least recently used one is replaced.", kOurs),
    number<&A::height_l1, &L1::mshrs>(
        "height_l1.mshrs", 1, 64, kTime, "",
        "Misses to different lines on their way at once; misses to one line merge.", kOurs),

    number<&A::hit_queue, &HitQueueParameters::depth>(
        "hit_queue.depth", 1, 4096, kTime, "records",
        "Hit records that wait between a traverse and result_writer.", kOurs),

    power<&A::result_writer, &Writer::burst_bytes>(
        "result_writer.burst_bytes", 32, 1024, "bytes",
        "Hit records (32 bytes each) are gathered into write bursts of so many bytes.", kOurs),
    number<&A::result_writer, &Writer::outstanding>("result_writer.outstanding", 1, 256, kTime, "bursts",
                                                    "Write bursts on their way to dram at once.", kOurs),

    power<&A::dram, &Dram::channels>("dram.channels", 1, 16, "",
                                     "Channels, each with its banks and data bus.", kOurs),
    power<&A::dram, &Dram::banks>("dram.banks", 1, 64, "", "Banks of a channel, each with one open row.",
                                  kDatasheet),
    power<&A::dram, &Dram::row_bytes>("dram.row_bytes", 256, 65'536, "bytes",
                                      "Bytes of an open row, over all chips of a channel.", kDatasheet),
    power<&A::dram, &Dram::bus_bytes>(
        "dram.bus_bytes", 1, 64, "bytes",
        "Bytes that a channel's data bus moves in one memory clock: twice its width for double data rate.",
        kDatasheet),
    number<&A::dram, &Dram::tRCD>("dram.tRCD", 1, 255, kTime, "memory clocks",
                                  "Row activation to column command.", kDatasheet),
    number<&A::dram, &Dram::tRP>("dram.tRP", 1, 255, kTime, "memory clocks",
                                 "Precharge to activation of the next row.", kDatasheet),
    number<&A::dram, &Dram::tCL>("dram.tCL", 1, 255, kTime, "memory clocks",
                                 "Column command to the first data.", kDatasheet),
    number<&A::dram, &Dram::tRAS>("dram.tRAS", 1, 1023, kTime, "memory clocks",
                                  "Row activation to precharge.", kDatasheet),
    number<&A::dram, &Dram::clock_num>("dram.clock_num", 1, 64, kTime, "",
                                       "Memory clock = machine clock * clock_num / clock_den.", kOurs),
    number<&A::dram, &Dram::clock_den>("dram.clock_den", 1, 64, kTime, "",
                                       "Memory clock = machine clock * clock_num / clock_den.", kOurs),
    number<&A::dram, &Dram::request_latency_cycles>(
        "dram.request_latency_cycles", 1, 10'000, kTime, "cycles",
        "From height_l1 or result_writer to the memory controller.", kOurs),
    number<&A::dram, &Dram::response_latency_cycles>(
        "dram.response_latency_cycles", 1, 10'000, kTime, "cycles",
        "From the memory controller back to height_l1 or result_writer.", kOurs),

    name<&A::texels, &TexelParameters::layout>("texels.layout", kLayouts, kTime,
                                               "Where each pyramid texel lies in memory.", kOurs),

    inert(
        name<&A::units, &UnitParameters::hmt_top>(
            "units.hmt_top", kImplementations, kTime,
            "What stands in the place of ray_setup, traverse and height_l1 of every pipeline: the model, or "
            "rtl/hmt_top.sv, Verilated; one of the compiled sets.",
            kOurs),
        kEqual),
    inert(name<&A::units, &UnitParameters::traverse>("units.traverse", kImplementations, kTime,
                                                     "What stands in the place of traverse, between the "
                                                     "model's ray_setup and height_l1: the model, or "
                                                     "rtl/traverse/traverse.sv, Verilated.",
                                                     kOurs),
          kEqual),
});

}  // namespace

std::string Parameter::accepted() const {
  if (!names.empty()) return "one of " + joined(names);
  const std::string range = " from " + std::to_string(low) + " to " + std::to_string(high);
  return (power_of_two ? "a power of two" : "a whole number") + range;
}

std::string Parameter::text(int64_t value) const {
  if (names.empty()) return std::to_string(value);
  return "\"" + std::string(names[static_cast<size_t>(value)]) + "\"";
}

std::span<const Parameter> parameters() { return kParameters; }

std::span<const std::string_view> parameter_sections() {
  static const std::vector<std::string_view> sections = [] {
    std::vector<std::string_view> names;
    for (const Parameter& parameter : kParameters) {
      if (names.empty() || names.back() != parameter.section()) names.push_back(parameter.section());
    }
    return names;
  }();
  return sections;
}

const Parameter* find_parameter(std::string_view path) {
  const auto found = std::find_if(kParameters.begin(), kParameters.end(),
                                  [&](const Parameter& parameter) { return parameter.path == path; });
  return found == kParameters.end() ? nullptr : &*found;
}

}  // namespace cuesta
