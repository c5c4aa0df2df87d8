#pragma once

#include <cstdint>

#include "models/common/counter_table.h"

namespace cuesta {

/// What a workload is worth, summed over its rays.
struct WorkCounts {
  int64_t rays = 0;
  int64_t hits = 0;
  int64_t misses = 0;
  int64_t dead_rays = 0;
  int64_t unfinished_rays = 0;
  int64_t steps = 0;
  int64_t fetches = 0;
  int64_t fetched_texels = 0;
  int64_t texel_bytes = 0;
};

inline constexpr CounterRow<WorkCounts> kWorkCounters[] = {
    {"machine.rays", "rays", "Rays with a result: all of the trace, unless the run was ended early.",
     &WorkCounts::rays},
    {"machine.hits", "rays", "Rays that hit the surface.", &WorkCounts::hits},
    {"machine.misses", "rays", "Rays that did not, dead ones included.", &WorkCounts::misses},
    {"machine.dead_rays", "rays", "Rays that missed at set-up, with no step: outside the slab or the map.",
     &WorkCounts::dead_rays},
    {"machine.unfinished_rays", "rays", "Rays without a result: the run was ended early.",
     &WorkCounts::unfinished_rays},
    {"machine.steps", "steps", "Node visits of all rays; in a search, its steps.", &WorkCounts::steps},
    {"machine.fetches", "fetches",
     "Node visits that read memory: every step, but with fetch = quad those whose siblings the ray had kept.",
     &WorkCounts::fetches},
    {"machine.fetched_texels", "texels",
     "Texels that the fetches brought: one each, or with fetch = quad the 2 x 2 siblings as far as the level "
     "has them; records of its map in a search.",
     &WorkCounts::fetched_texels},
    {"machine.texel_bytes", "bytes",
     "Bytes of the texels that the fetches brought: the traffic without any cache.",
     &WorkCounts::texel_bytes},
};

/// How the rays' answers stand to the true ones, summed over them.
struct ErrorCounts {
  int64_t exact = 0;
  int64_t tie = 0;
  int64_t missed = 0;
  int64_t behind = 0;
  int64_t wrong_cell = 0;
  int64_t wrong = 0;
};

inline constexpr CounterRow<ErrorCounts> kErrorCounters[] = {
    {"error.exact", "rays", "Rays of a search that hit the true cell, or rightly miss.", &ErrorCounts::exact},
    {"error.tie", "rays",
     "Rays of a search whose answer is the true one if touching counts as a hit, or edges are closed on the "
     "other side.",
     &ErrorCounts::tie},
    {"error.missed", "rays", "Rays of a search that miss, and truly hit.", &ErrorCounts::missed},
    {"error.behind", "rays", "Rays of a search that hit another cell than the true one, and later.",
     &ErrorCounts::behind},
    {"error.wrong_cell", "rays",
     "Rays of a search that hit where nothing is, or another cell than the true one and earlier.",
     &ErrorCounts::wrong_cell},
    {"error.wrong", "rays", "Rays of a search that missed, are behind, or hit a wrong cell.",
     &ErrorCounts::wrong},
};

/// Rays of algorithms as printed that end without an answer.
struct NoAnswerCounts {
  int64_t nan = 0;
  int64_t unfinished = 0;
};

inline constexpr CounterRow<NoAnswerCounts> kNoAnswerCounters[] = {
    {"error.nan", "rays",
     "Rays of a search as printed that ended at no place: a coordinate NaN, infinite, or beyond a hit "
     "record's; not among error.wrong.",
     &NoAnswerCounts::nan},
    {"error.unfinished", "rays",
     "Rays of a search as printed that did not end within its steps; not among error.wrong.",
     &NoAnswerCounts::unfinished},
};

/// What the making of a search's map cost.
struct PreprocessingCounts {
  int64_t texels_read = 0;
  int64_t records = 0;
  int64_t bytes = 0;
};

inline constexpr CounterRow<PreprocessingCounts> kPreprocessingCounters[] = {
    {"preprocessing.texels_read", "texels", "Texels that the making of a search's map read.",
     &PreprocessingCounts::texels_read},
    {"preprocessing.records", "records", "Records that the making of a search's map wrote.",
     &PreprocessingCounts::records},
    {"preprocessing.bytes", "bytes",
     "Bytes of the map that a search reads: one record per texel; of one as printed, the pyramid's image.",
     &PreprocessingCounts::bytes},
};

/// Histograms and planes of a workload's value.
inline constexpr StatisticDefinition kWorkStatistics[] = {
    {"steps", "steps", "Histogram over rays of the node visits."},
    {"height_error", "height LSB / 256",
     "Histogram over the rays of a search that hit and truly hit: how far along the ray the found place lies "
     "from the true one, as a difference in height."},
    {"texel_error", "texels / 256",
     "Histogram over the rays of a search that hit and truly hit: how far along the ray the found place lies "
     "from the true one, in the plane of the map."},
    {"plane.steps", "steps", "Node visits of the pixel's rays."},
    {"plane.wrong", "rays",
     "How many of the pixel's rays missed, are behind, hit a wrong cell, or have no answer: error.wrong, "
     "error.nan and error.unfinished together; 0 where all are right."},
};

}  // namespace cuesta
