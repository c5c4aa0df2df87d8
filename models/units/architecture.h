#pragma once

#include <optional>
#include <string>

#include "models/algorithms/schedule.h"
#include "models/heightmap/texel_layout.h"
#include "models/rays/machine_ray.h"
#include "models/units/dram/dram_parameters.h"

namespace cuesta {

enum class DispatchOrder : uint8_t { kScanline, kTile, kMorton, kHilbert };
enum class DispatchAssign : uint8_t { kFirstFree, kInterleave };

struct MachineParameters {
  int pipelines = 1;
  int clock_mhz = 500;
  int64_t no_progress_cycles = 1'000'000;  ///< stop with exit 4 after so many cycles without a finished step
};

struct RayDispatchParameters {
  DispatchOrder order = DispatchOrder::kScanline;
  DispatchAssign assign = DispatchAssign::kFirstFree;
  int tile_size = 8;              ///< pixels on a side of a tile: orders `tile`, and `interleave`
  int queue_depth = 4;            ///< rays waiting in front of each ray_setup
  int latency_cycles = 4;         ///< dispatch to ray_setup's queue
  int credit_latency_cycles = 4;  ///< a freed place to the dispatcher
};

struct RaySetupParameters {
  int latency_cycles = 24;  ///< clip, three reciprocals, start level
  int interval_cycles = 4;  ///< cycles between two rays entering: set by the number of reciprocal units
  int queue_depth = 8;      ///< rays in set-up or waiting for a context
};

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

struct HeightL1Parameters {
  int size_bytes = 16384;
  int line_bytes = 64;
  int ways = 4;
  int mshrs = 8;
};

struct HitQueueParameters {
  int depth = 8;
};

struct ResultWriterParameters {
  int burst_bytes = 64;
  int outstanding = 4;  ///< write bursts on their way
};

/// What stands in a unit's place: the model, or Verilated RTL, which is equal to it cycle by cycle.
enum class Implementation : uint8_t { kModel, kRtl };

struct UnitParameters {
  Implementation hmt_top = Implementation::kModel;   ///< ray_setup, traverse and height_l1 of every pipeline
  Implementation traverse = Implementation::kModel;  ///< between the model's ray_setup and height_l1
};

struct TexelParameters {
  TexelLayoutKind layout = TexelLayoutKind::kRowMajor;
};

/// Everything an architect turns. Sections of an architecture file carry the unit names.
struct Architecture {
  std::string name = "mobile";
  MachineParameters machine;
  RayDispatchParameters ray_dispatch;
  RaySetupParameters ray_setup;
  TraverseParameters traverse;
  HeightL1Parameters height_l1;
  HitQueueParameters hit_queue;
  ResultWriterParameters result_writer;
  DramParameters dram;
  TexelParameters texels;
  UnitParameters units;
};

}  // namespace cuesta
