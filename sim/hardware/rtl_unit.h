#pragma once

#include <algorithm>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "models/common/error.h"
#include "models/heightmap/texel_layout.h"
#include "models/rays/map_shape.h"
#include "models/units/hmt/hmt_site.h"
#include "models/units/hmt/hmt_unit.h"
#include "models/work/workload.h"
#include "sim/hardware/hmt_top_port.h"
#include "sim/hardware/rtl_set.h"

namespace cuesta::rtl {

/// What all pipelines with Verilated hardware share. References outlive the units.
struct RtlJob {
  const Workload& work;
  const TexelLayout& layout;
  const RtlSet& set;
  std::vector<std::byte> image;  ///< pyramid in memory, a line longer than it
  int seed;                      ///< of what registers without a reset begin with; 0: zeros

  RtlJob(const Workload& workload, const TexelLayout& texels, const RtlSet& compiled, int random_seed);
};

/// A pipeline with Verilated hardware inside, ticked cycle by cycle. What it measures is what the hardware's ports
/// show.
class RtlUnit : public HmtUnit {
 public:
  void advance(Cycle limit) final;
  Cycle cycle() const final { return std::min(cycle_, ended_); }
  bool finished() const final;
  bool starved() const final;
  void drain_until(Cycle end) final;
  void hold_hits_until(Cycle cycle) final { hits_open_from_ = cycle; }
  void log_completions(std::vector<uint32_t>* rays) final { completions_ = rays; }
  int64_t completed() const final { return rays_completed_; }

  /// The hardware's signals into an FST file, from cycle `first` to cycle `last`.
  void record_waves(const std::string& file, Cycle first, Cycle last);

 protected:
  RtlUnit(std::string name, const RtlJob& job, const HmtSite& site)
      : job_(job),
        site_(site),
        most_slots_(kSlotsOfAStep * most_steps(job.work.map, job.work.format)),
        name_(std::move(name)) {}

  /// One cycle, `cycle_`.
  virtual void tick() = 0;
  /// Rays between ray_dispatch's queue and hit_queue.
  virtual int inside() const = 0;
  virtual WavePort& waves() = 0;

  bool blocked(Port port) const {
    return site_.stalls != nullptr && site_.stalls->blocked(port, site_.pipeline, cycle_);
  }
  bool sink_ready() {
    if (cycle_ < hits_open_from_ || blocked(Port::kHitStream)) return false;
    return site_.sink.has_room(cycle_);
  }
  /// ray_dispatch has sent all, and none is in front of ray_setup.
  bool no_ray_to_come() {
    return site_.dispatch.queue(site_.pipeline).empty() && site_.dispatch.all_sent() &&
           site_.dispatch.last_sent() < cycle_;
  }
  /// Throws Error(kMismatch) for a ray that there is not, Error(kNoProgress) for one that has used more slots
  /// than any walk over the map: the hardware may be anybody's.
  void count_slot(HmtTopPort::Slot slot, uint32_t number) {
    using Slot = HmtTopPort::Slot;
    if (slot == Slot::kBubble || slot == Slot::kStall) return;
    if (number >= site_.order.size()) throw no_such_ray(number);
    RayTiming& timing = site_.timing[site_.order[number]];
    in_context_ += timing.issue_slots++ == 0;
    if (timing.issue_slots > most_slots_) [[unlikely]]
      throw goes_nowhere(number);
    timing.misses += slot == Slot::kMiss;
    if (slot == Slot::kStep || slot == Slot::kDead) site_.watchdog.last_progress = cycle_;
  }
  /// Error(kMismatch): "traverse[0] sends ray 7 in cycle 12, which is not inside."
  Error wrong(const std::string& what) const;
  Error no_such_ray(uint32_t number) const;
  /// Error(kNoProgress): steps without an end are no progress.
  Error goes_nowhere(uint32_t number) const;
  /// The hit stream's transfer of this cycle; the record has the ray's number as its id. `sent`: by ray_dispatch.
  void retire(HitRecord record, Cycle sent);
  const MachineRay& ray(uint32_t number) const { return job_.work.rays[site_.order[number]]; }

  /// In a context of traverse: their first slot was theirs.
  int in_context() const { return in_context_; }

  const RtlJob& job_;
  HmtSite site_;
  Cycle cycle_ = 0;

 private:
  static constexpr int kSlotsOfAStep = 3;  ///< refused, allocated or merged, replayed

  int64_t most_slots_;
  Cycle ended_ = kNever;  ///< where it stopped: what `drain_until` ticks is behind its end
  std::string name_;
  Cycle hits_open_from_ = 0;
  std::vector<uint32_t>* completions_ = nullptr;
  int64_t rays_completed_ = 0;
  int in_context_ = 0;
  std::string wave_file_;
  Cycle wave_first_ = kNever, wave_last_ = kNever;
};

/// hmt_top in the place of ray_setup, traverse and height_l1.
std::unique_ptr<RtlUnit> make_hmt_top_unit(const RtlJob& job, const HmtSite& site);
/// traverse in its place between the model's ray_setup and height_l1.
std::unique_ptr<RtlUnit> make_traverse_unit(const RtlJob& job, const HmtSite& site);

}  // namespace cuesta::rtl
