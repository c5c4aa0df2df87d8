#include "reports/quantities.h"

#include "models/units/statistics.h"

#include <algorithm>
#include <array>

namespace cuesta {
namespace {

using Value = std::optional<double>;

struct Rule {
  DerivedQuantity quantity;
  Value (*compute)(const RunEntry& run);
};

Value known(double value) { return value > 0 ? Value(value) : std::nullopt; }

Value times(Value a, double b) { return a && b > 0 ? Value(*a * b) : std::nullopt; }

constexpr std::array kRules = {
    Rule{{"machine.clock_hz", "cycles/s", "Clock of the machine, as configured."},
         [](const RunEntry& run) { return known(1e6 * static_cast<double>(run.machine.clock_mhz())); }},
    Rule{{"machine.seconds", "s", "Simulated time: the machine's cycles at its configured clock."},
         [](const RunEntry& run) -> Value {
           const Value cycles = quantity(run, "machine.cycles");
           const auto mhz = static_cast<double>(run.machine.clock_mhz());
           return cycles && mhz > 0 ? Value(*cycles / (1e6 * mhz)) : std::nullopt;
         }},
    Rule{{"dram.bytes", "bytes", "Bytes read from and written to DRAM."},
         [](const RunEntry& run) -> Value {
           const Value read = quantity(run, "dram.read_bytes");
           const Value written = quantity(run, "dram.write_bytes");
           return read ? Value(*read + written.value_or(0)) : std::nullopt;
         }},
    Rule{{"dram.accesses", "accesses", "Reads and writes that the DRAM served."},
         [](const RunEntry& run) -> Value {
           const Value reads = quantity(run, "dram.reads");
           const Value writes = quantity(run, "dram.writes");
           return reads ? Value(*reads + writes.value_or(0)) : std::nullopt;
         }},
    Rule{{"dram.peak_bytes", "bytes",
          "Bytes that the data buses of all DRAM channels could carry in the machine's cycles: the "
          "theoretical peak."},
         [](const RunEntry& run) {
           const MachineFacts& machine = run.machine;
           return times(quantity(run, "machine.cycles"), static_cast<double>(machine.dram_peak_bytes()) /
                                                             static_cast<double>(machine.dram_peak_cycles()));
         }},
    Rule{{"height_l1.compulsory_bytes", "bytes",
          "Bytes of the distinct lines that were touched, each fetched once per pipeline: no private L1 of "
          "this "
          "line size can fetch less."},
         [](const RunEntry& run) {
           return times(quantity(run, "height_l1.unique_lines"),
                        static_cast<double>(run.machine.line_bytes()));
         }},
};

constexpr std::array kRatios = {
    RatioDefinition{"steps_per_ray", "Steps per ray", "steps/ray", "machine.steps", "machine.rays", -1,
                    "Node visits of the traversal, over the rays of the trace."},
    RatioDefinition{"rays_hit", "Rays that hit", "fraction", "machine.hits", "machine.rays", 0,
                    "Rays that ended on the surface, over the rays of the trace."},
    RatioDefinition{
        "wrong_rays", "Rays that are wrong", "fraction", "error.wrong", "machine.rays", -1,
        "Rays of a search that missed a hit, hit behind it or hit a wrong cell, over the rays of the "
        "trace; exact ones, which are not judged here, err by the "
        "rounding of their numbers alone (study accuracy)."},
    RatioDefinition{
        "nan_rays", "Rays that end at NaN", "fraction", "error.nan", "machine.rays", -1,
        "Rays of a search as printed whose place is no number, over the rays of the trace; not among "
        "those that are wrong."},
    RatioDefinition{
        "endless_rays", "Rays that do not end", "fraction", "error.unfinished", "machine.rays", -1,
        "Rays of a search as printed that did not end within its steps, over the rays of the trace; not "
        "among those that are wrong."},
    RatioDefinition{"cycles_per_ray", "Cycles per ray", "cycles/ray", "machine.cycles", "machine.rays", -1,
                    "Machine cycles over the rays of the trace."},
    RatioDefinition{"rays_per_second", "Rays per second", "rays/s", "machine.rays", "machine.seconds", 1,
                    "Rays over the simulated time at the configured clock."},
    RatioDefinition{"frames_per_second", "Frames per second", "frames/s", "machine.clock_hz",
                    "machine.cycles", 1,
                    "How often all rays of this run could be traced in one second at the configured clock."},
    RatioDefinition{
        "step_utilisation", "Slots that step", "fraction", "traverse.slots_step", "traverse.cycles", 0,
        "Pipeline cycles whose slot carried out a traversal step, over all pipeline cycles; the rest is "
        "in the plot of reasons."},
    RatioDefinition{"l1_hit_rate", "L1 hit rate", "fraction", "height_l1.hits", "height_l1.accesses", 1,
                    "Lookups in the pipeline's L1 that found their line, over all lookups: retries included, "
                    "replays left out."},
    RatioDefinition{"dram_bytes_per_ray", "DRAM bytes per ray", "bytes/ray", "dram.bytes", "machine.rays", -1,
                    "Bytes read from and written to DRAM, over the rays."},
    RatioDefinition{"dram_read_bytes_per_step", "DRAM bytes read per step", "bytes/step", "dram.read_bytes",
                    "machine.steps", -1, "Bytes read from DRAM, over the traversal steps."},
    RatioDefinition{"dram_bandwidth", "DRAM bandwidth", "bytes/s", "dram.bytes", "machine.seconds", 0,
                    "Bytes to and from DRAM over the simulated time at the configured clock."},
    RatioDefinition{
        "dram_utilisation", "DRAM peak used", "fraction", "dram.bytes", "dram.peak_bytes", 0,
        "Bytes to and from DRAM, over the theoretical peak of the data buses in the same cycles."},
    RatioDefinition{"dram_row_hit_rate", "DRAM row hits", "fraction", "dram.row_hits", "dram.accesses", 1,
                    "DRAM accesses that found their row open, over all DRAM accesses."},
    RatioDefinition{
        "refetch_factor", "Fills over compulsory", "", "height_l1.fill_bytes", "height_l1.compulsory_bytes",
        -1,
        "Bytes that the L1s fetched, over those of the distinct lines touched; 1 means that no line was "
        "fetched twice."},
    RatioDefinition{
        "no_cache_factor", "Fills over no cache", "", "height_l1.fill_bytes", "machine.texel_bytes", -1,
        "Bytes that the L1s fetched, over the traffic without a cache; above 1 the lines brought in more "
        "than was used."},
};

}  // namespace

std::span<const DerivedQuantity> derived_quantities() {
  static const auto table = [] {
    std::array<DerivedQuantity, kRules.size()> quantities;
    std::transform(kRules.begin(), kRules.end(), quantities.begin(),
                   [](const Rule& rule) { return rule.quantity; });
    return quantities;
  }();
  return table;
}

std::span<const RatioDefinition> ratio_definitions() { return kRatios; }

const RatioDefinition* find_ratio(std::string_view name) {
  for (const RatioDefinition& definition : kRatios) {
    if (definition.name == name) return &definition;
  }
  return nullptr;
}

const StatisticDefinition* find_statistic(std::string_view path) {
  const std::string name = without_index(path);
  for (const StatisticDefinition& definition : statistic_definitions()) {
    if (definition.name == name) return &definition;
  }
  return nullptr;
}

std::string without_index(std::string_view path) {
  std::string name;
  bool inside = false;
  for (char c : path) {
    if (c == '[') inside = true;
    if (!inside) name += c;
    if (c == ']') inside = false;
  }
  return name;
}

std::optional<int64_t> counter_total(const Counters& counters, std::string_view name) {
  std::optional<int64_t> total;
  const bool is_maximum = name.ends_with(".max_fill");
  for (const auto& [path, value] : counters.all()) {
    if (path != name && without_index(path) != name) continue;
    total = is_maximum ? std::max(total.value_or(value), value) : total.value_or(0) + value;
  }
  return total;
}

std::optional<double> quantity(const RunEntry& run, std::string_view name) {
  if (const auto total = counter_total(run.measurements.counters, name)) return static_cast<double>(*total);
  for (const Rule& rule : kRules) {
    if (rule.quantity.name == name) return rule.compute(run);
  }
  return std::nullopt;
}

std::optional<Ratio> ratio(const RunEntry& run, const RatioDefinition& definition) {
  if (run.partial() && definition.name == std::string_view("frames_per_second"))
    return std::nullopt;  // no frame
  const auto numerator = quantity(run, definition.numerator);
  const auto denominator = quantity(run, definition.denominator);
  if (!numerator || !denominator || *denominator == 0) return std::nullopt;
  return Ratio{&definition, *numerator, *denominator, *numerator / *denominator};
}

std::optional<double> ratio(const RunEntry& run, std::string_view name) {
  const RatioDefinition* definition = find_ratio(name);
  const auto found = definition == nullptr ? std::nullopt : ratio(run, *definition);
  return found ? std::optional(found->value) : std::nullopt;
}

std::vector<Ratio> ratios_of(const RunEntry& run) {
  std::vector<Ratio> ratios;
  for (const RatioDefinition& definition : kRatios) {
    if (auto found = ratio(run, definition)) ratios.push_back(*found);
  }
  return ratios;
}

bool competes(const RunEntry& run) {
  return !run.partial() && ratio(run, "nan_rays").value_or(0) == 0 &&
         ratio(run, "endless_rays").value_or(0) == 0;
}

}  // namespace cuesta
