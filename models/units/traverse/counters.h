#pragma once

#include <cstdint>

#include "models/common/counter_table.h"

namespace cuesta {

/// What one traverse has counted. Slots, bubbles and stalls are the cycles by what the pipe did: they add up to all.
struct TraverseCounts {
  int64_t steps = 0;
  int64_t part_slots = 0;
  int64_t compute_slots = 0;
  int64_t miss_slots = 0;
  int64_t refused_slots = 0;
  int64_t dead_slots = 0;
  int64_t contexts_full = 0;
  int64_t no_ray = 0;
  int64_t drain = 0;
  int64_t stalls = 0;
  int64_t replays = 0;
  int64_t kept_steps = 0;
  int64_t rays = 0;
  int64_t hits = 0;
  int64_t resident_cycles = 0;

  int64_t total() const {
    return steps + part_slots + compute_slots + miss_slots + refused_slots + dead_slots + contexts_full +
           no_ray + drain + stalls;
  }
};

inline constexpr CounterRow<TraverseCounts> kTraverseCounters[] = {
    {"traverse.cycles", "cycles",
     "Cycles of the unit: slots used, empty slots and standstills add up to them.",
     [](const TraverseCounts& c) { return c.total(); }},
    {"traverse.rays", "rays", "Rays completed: transferred on the hit stream.", &TraverseCounts::rays, 1},
    {"traverse.hits", "rays", "Completed rays that hit.", &TraverseCounts::hits, 2},
    {"traverse.slots_step", "cycles", "Slots in which a node visit, or a step of a search, was done: steps.",
     &TraverseCounts::steps, 3},
    {"traverse.slots_part", "cycles",
     "Slots in which a line of a quad or sample was read and others of its step were still to come.",
     &TraverseCounts::part_slots},
    {"traverse.slots_compute", "cycles",
     "Slots of arithmetic that read nothing, before the samples of a search's step.",
     &TraverseCounts::compute_slots},
    {"traverse.slots_miss", "cycles", "Slots used by a lookup that missed and parked its ray on an MSHR.",
     &TraverseCounts::miss_slots, 4},
    {"traverse.slots_refused", "cycles", "Slots used by a lookup that missed and found no free MSHR.",
     &TraverseCounts::refused_slots, 5},
    {"traverse.slots_dead", "cycles", "Slots used by rays dead at set-up.", &TraverseCounts::dead_slots, 6},
    {"traverse.bubble_contexts_full", "cycles",
     "Empty slots while every context held a ray that waited for memory.", &TraverseCounts::contexts_full, 7},
    {"traverse.bubble_no_ray", "cycles",
     "Empty slots while ray_setup had no ray ready and some were still to come.", &TraverseCounts::no_ray, 8},
    {"traverse.bubble_drain", "cycles", "Empty slots after the last ray had been taken.",
     &TraverseCounts::drain, 9},
    {"traverse.stall_hit_queue", "cycles",
     "Cycles in which the pipe stood still, a result before a full hit_queue.", &TraverseCounts::stalls, 10},
    {"traverse.replays", "accesses", "Of the line accesses, those replayed after their line had landed.",
     &TraverseCounts::replays, 11},
    {"traverse.kept_steps", "steps",
     "Of the steps, those that read nothing: with fetch = quad, since the ray had kept the siblings; in a "
     "search, a last division.",
     &TraverseCounts::kept_steps},
    {"traverse.line_accesses", "accesses",
     "Lines read for steps: one for each, or as many as the quad's or sample's texels lie in, none for a "
     "kept one.",
     [](const TraverseCounts& c) { return c.steps - c.kept_steps + c.part_slots; }},
    {"traverse.resident_cycles", "ray cycles",
     "Sum over rays of the cycles in a context, from entry to completion.", &TraverseCounts::resident_cycles,
     19},
};

}  // namespace cuesta
