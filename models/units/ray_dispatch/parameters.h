#pragma once

#include <cstdint>
#include <string_view>

#include "models/units/parameter_table.h"

namespace cuesta {

enum class DispatchOrder : uint8_t { kScanline, kTile, kMorton, kHilbert };
inline constexpr std::string_view kDispatchOrderNames[] = {"scanline", "tile", "morton", "hilbert"};
enum class DispatchAssign : uint8_t { kFirstFree, kInterleave };
inline constexpr std::string_view kDispatchAssignNames[] = {"first_free", "interleave"};

struct RayDispatchParameters {
  DispatchOrder order = DispatchOrder::kScanline;
  DispatchAssign assign = DispatchAssign::kFirstFree;
  int tile_size = 8;              ///< pixels on a side of a tile: orders `tile`, and `interleave`
  int queue_depth = 4;            ///< rays waiting in front of each ray_setup
  int latency_cycles = 4;         ///< dispatch to ray_setup's queue
  int credit_latency_cycles = 4;  ///< a freed place to the dispatcher
};

namespace parameter {

inline constexpr ParameterRow<RayDispatchParameters> kRayDispatchParameters[] = {
    name<&RayDispatchParameters::order>("ray_dispatch.order", kDispatchOrderNames, kTime,
                                        "Order in which rays leave the trace: by scanline, by tile, or "
                                        "along a space-filling curve over the image.",
                                        "Hilbert curve: Warren, Hacker's Delight, ch. 16"),
    name<&RayDispatchParameters::assign>("ray_dispatch.assign", kDispatchAssignNames, kTime,
                                         "Which pipeline a ray goes to: the lowest one with a free "
                                         "place, or its tile's number modulo pipelines.",
                                         kOurs),
    power<&RayDispatchParameters::tile_size>(
        "ray_dispatch.tile_size", 1, 256, "pixels",
        "Side of a square tile of pixels; for order = \"tile\" and assign = \"interleave\".", kOurs),
    number<&RayDispatchParameters::queue_depth>(
        "ray_dispatch.queue_depth", 1, 1024, kTime, "rays",
        "Rays that wait in front of each ray_setup: the credits that ray_dispatch starts with.", kOurs),
    number<&RayDispatchParameters::latency_cycles>("ray_dispatch.latency_cycles", 1, 1000, kTime, "cycles",
                                                   "From ray_dispatch to the queue in front of ray_setup.",
                                                   kOurs),
    number<&RayDispatchParameters::credit_latency_cycles>(
        "ray_dispatch.credit_latency_cycles", 1, 1000, kTime, "cycles",
        "From a place that gets free to the ray_dispatch that may fill it.", kOurs),
};

}  // namespace parameter

}  // namespace cuesta
