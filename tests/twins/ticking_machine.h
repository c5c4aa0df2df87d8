#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "models/rays/hit.h"
#include "models/units/architecture.h"
#include "models/units/ports/port_stalls.h"
#include "tests/twins/dram_twin.h"
#include "tests/twins/height_l1_twin.h"
#include "tests/twins/hit_queue_twin.h"
#include "tests/twins/ray_dispatch_twin.h"
#include "tests/twins/ray_setup_twin.h"
#include "tests/twins/ray_values.h"
#include "tests/twins/result_writer_twin.h"
#include "tests/twins/traverse_twin.h"

namespace cuesta::twins {

/// One ray's time and what it used. Its own steps are in its hit record.
struct RayTimes {
  Cycle sent = kNever;
  Cycle completed = kNever;
  int pipeline = -1;
  int64_t misses = 0;       ///< MSHRs allocated for it
  int64_t issue_slots = 0;  ///< steps, misses, refused lookups, the slot of a dead ray
  int64_t fill_bytes = 0;
  int64_t write_bytes = 0;
  int64_t row_activations = 0;
  int64_t bus_clocks = 0;
};

struct PipelineCounts {
  int64_t rays = 0, rays_entered = 0, rays_completed = 0, rays_hit = 0;
  std::array<int64_t, kTraverseCycleKinds> cycles{};  ///< by TraverseCycle
  int64_t lookups = 0, hits = 0, merged = 0, allocated = 0, refused = 0;
  int64_t replays = 0, retries = 0, fills = 0;
  int64_t kept_steps = 0, fetched_texels = 0;
  int64_t records = 0, bursts = 0;
  int64_t resident_cycles = 0, mshr_cycles = 0, evictions = 0, unique_lines = 0;
  int64_t pushes = 0, pops = 0, record_cycles = 0, most_records = 0;
};

struct TickingResult {
  std::vector<RayTimes> rays;   ///< in the machine's order
  std::vector<HitRecord> hits;  ///< alike
  std::vector<PipelineCounts> pipelines;
  DramTwin::Counts dram;
  Cycle cycles = 0;
};

/// The whole machine, every unit in every cycle.
class TickingMachine {
 public:
  /// `pixels`: y * width + x of each ray, in the machine's order like the rays of `values`. `image_bytes`: of
  /// the pyramid image. Pipelines are evaluated in the order of `evaluation_order` (empty: ascending), which must
  /// change nothing.
  TickingMachine(const Architecture& architecture, const PortStalls& stalls, RayValues& values,
                 std::span<const uint32_t> pixels, int width, uint64_t image_bytes,
                 std::vector<int> evaluation_order = {});

  /// Ticks until everything is written. Throws std::runtime_error when no ray has completed and no burst was
  /// acknowledged for `patience` cycles.
  TickingResult run(Cycle patience = 1'000'000);

 private:
  struct Pipeline {
    RaySetupTwin ray_setup;
    TraverseTwin traverse;
    HeightL1Twin height_l1;
    HitQueueTwin hit_queue;
    ResultWriterTwin result_writer;
    std::vector<DramTwin::Request> requests;  ///< of this cycle
  };

  void tick(Cycle cycle);
  void tick_pipeline(int p, Cycle cycle);
  void account(int p, const TraverseTwin::Event& event, Cycle cycle);
  bool finished() const;

  Architecture architecture_;
  RayValues& values_;
  uint64_t write_base_;
  RayDispatchTwin ray_dispatch_;
  std::vector<Pipeline> pipelines_;
  DramTwin dram_;
  std::vector<int> order_;
  TickingResult result_;
  Cycle last_progress_ = 0;
};

}  // namespace cuesta::twins
