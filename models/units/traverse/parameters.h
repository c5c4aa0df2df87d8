#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "models/algorithms/schedule.h"
#include "models/rays/machine_ray.h"
#include "models/units/parameter_table.h"

namespace cuesta {

struct TraverseParameters {
  Arithmetic arithmetic = Arithmetic::kFixed;
  int stages = 8;     ///< cycles from one step of a ray to its next
  int contexts = 32;  ///< rays resident: in the pipe or parked on a miss; >= stages
  int fraction_bits = 8;
  int direction_bits = 32;
  int mantissa_bits = 0;  ///< 0: height bits + 4
  int tile_bits = 4;
  // Of the schedule; none: as the algorithm says.
  std::optional<StartRule> start;
  std::optional<int> down;
  std::optional<UpRule> up;
  std::optional<int> stop_level;
  std::optional<FetchRule> fetch;
};

namespace parameter {

constexpr int down_value(int index) { return kDownValues[index]; }
inline constexpr auto kStartChoices = with_algorithm_first(kStartNames);
inline constexpr auto kDownChoices = with_algorithm_first(kDownNames);
inline constexpr auto kUpChoices = with_algorithm_first(kUpNames);
inline constexpr auto kFetchChoices = with_algorithm_first(kFetchNames);
inline constexpr std::string_view kStopLevelChoices[] = {"algorithm", "0", "1", "2",  "3",  "4",  "5",  "6",
                                                         "7",         "8", "9", "10", "11", "12", "13", "14"};
static_assert(std::size(kStopLevelChoices) == kMostStopLevel + 2);

inline constexpr ParameterRow<TraverseParameters> kTraverseParameters[] = {
    name<&TraverseParameters::arithmetic>(
        "traverse.arithmetic", kArithmeticNames, kHits,
        "Numbers that traversal computes with: the hardware's fixed point, or floating point for comparison.",
        kOurs),
    number<&TraverseParameters::stages>("traverse.stages", 1, 256, kTime, "cycles",
                                        "From one step of a ray to its next, on a hit in height_l1.", kOurs),
    number<&TraverseParameters::contexts>("traverse.contexts", 1, 4096, kTime, "rays",
                                          "Rays resident in a pipeline: in the pipe, or parked on a miss.",
                                          kOurs),
    number<&TraverseParameters::fraction_bits>(
        "traverse.fraction_bits", 0, 12, kHits, "bits",
        "Fraction bits of a ray's origin, in texels and in height units.", kOurs),
    number<&TraverseParameters::direction_bits>("traverse.direction_bits", 8, 32, kHits, "bits",
                                                "Bits of the largest component of a ray's direction.", kOurs),
    number<&TraverseParameters::mantissa_bits>(
        "traverse.mantissa_bits", 0, 24, kHits, "bits",
        "Bits of a reciprocal's mantissa; 0 stands for the map's height bits + 4, 1 is not accepted.", kOurs),
    number<&TraverseParameters::tile_bits>("traverse.tile_bits", 0, 20, kHits, "bits",
                                           "A ray crosses at most 2^tile_bits tiles of the map.", kOurs),
    choice<&TraverseParameters::start>(
        "traverse.start", kStartChoices,
        "Where rays enter the pyramid: \"algorithm\" is the algorithm's own choice, here and in "
        "the four below; another value takes its place, and the run is named by what results."),
    choice<&TraverseParameters::down, down_value>(
        "traverse.down", kDownChoices,
        "Levels per descent before the first crossing; common: to the "
        "smallest node that holds the ray's cell and "
        "its end cell. Without effect from the leaves."),
    choice<&TraverseParameters::up>("traverse.up", kUpChoices,
                                    "When a ray that has crossed goes up one level."),
    choice<&TraverseParameters::stop_level>(
        "traverse.stop_level", kStopLevelChoices,
        "Level of the leaves; above 0 they are the texels of the mean pyramid. At most the map's root."),
    choice<&TraverseParameters::fetch>(
        "traverse.fetch", kFetchChoices,
        "What a visit reads: its texel, or its 2 x 2 siblings, which the ray keeps."),
};

}  // namespace parameter

}  // namespace cuesta
