#include <algorithm>

#include "models/common/error.h"
#include "models/units/height_l1/height_l1.h"
#include "models/units/ray_setup/ray_setup_unit.h"
#include "sim/hardware/rtl_unit.h"
#include "sim/hardware/traverse_port.h"

namespace cuesta::rtl {
namespace {

class TraverseRtl final : public RtlUnit {
 public:
  TraverseRtl(const RtlJob& job, const HmtSite& site)
      : RtlUnit("traverse", job, site),
        traverse_(job.set.make_traverse(job.seed)),
        l1_(site.architecture.height_l1, site.architecture.traverse.contexts, site.image_bytes, site.pipeline,
            site.memory, site.stalls),
        setup_(site.architecture.ray_setup, site.architecture.ray_dispatch, site.pipeline, site.dispatch,
               site.stalls),
        walk_(job.work.map, job.work.format, job.work.schedule, job.work.pyramid->highest()),
        texel_bytes_(job.work.pyramid->texel_bytes()),
        line_bytes_(static_cast<uint64_t>(site.architecture.height_l1.line_bytes)) {
    TraversePort::Settings settings{job.work.map,
                                    job.work.schedule,
                                    static_cast<uint64_t>(walk_.format.t_end),
                                    job.layout.kind() == TexelLayoutKind::kMorton,
                                    {}};
    for (int level = 0; level <= job.work.map.root_level; ++level) {
      settings.level_base.push_back(level < job.work.schedule.stop_level ? 0
                                                                         : job.layout.offset(level, 0, 0));
    }
    l1_.log_ports(site.log);
    setup_.log_ports(site.log);
    traverse_->configure(settings);
    traverse_->reset();
  }

  Counts counts(Cycle end) override {
    drain_until(end);
    l1_.land_before(end);
    Counts counts{setup_.counts(), counts_, l1_.counts_until(end)};
    for (const Resident& ray : resident_) counts.traverse.resident_cycles += end - 1 - ray.entered;
    return counts;
  }
  Fill fill() const override {
    return {static_cast<int>(setup_.queued() + setup_.waiting()), static_cast<int>(resident_.size()),
            l1_.mshrs_taken(), static_cast<int>(l1_.retry_fill())};
  }
  std::string who_waits() const override {
    return "traverse[" + std::to_string(site_.pipeline) + "] (RTL) holds " +
           std::to_string(resident_.size()) + " rays; height_l1: " + std::to_string(l1_.mshrs_taken()) +
           " MSHRs taken, " + std::to_string(l1_.retry_fill()) +
           " rays wait for an MSHR; ray_setup: " + std::to_string(setup_.waiting()) + " rays in set-up; " +
           site_.sink.who_waits();
  }

 private:
  struct Resident {
    uint32_t ray;
    Cycle sent, entered;
  };

  void tick() override;
  int inside() const override { return static_cast<int>(resident_.size() + setup_.waiting()); }
  WavePort& waves() override { return *traverse_; }
  void enter();
  void leave();
  HeightL1::Answer look_up(const TraversePort::Outputs& out);
  void count(const TraversePort::Outputs& out, HeightL1::Answer answer, bool entered);
  uint32_t texel_at(uint64_t address) const {
    const auto* bytes = job_.image.data() + std::min<uint64_t>(address, job_.image.size() - 2);
    const auto low = static_cast<uint32_t>(bytes[0]);
    return texel_bytes_ == 1 ? low : low | static_cast<uint32_t>(bytes[1]) << 8;
  }

  std::unique_ptr<TraversePort> traverse_;
  HeightL1 l1_;
  RaySetupUnit setup_;
  Walk<FixedArithmetic, PlainAxis> walk_;
  int texel_bytes_;
  uint64_t line_bytes_;
  std::vector<Resident> resident_;
  SetUpRay next_{};  ///< the ray that setup_ offers
  uint32_t next_ray_ = UINT32_MAX;
  bool next_dead_ = false;
  uint32_t texel_ = 0;
  TraverseCounts counts_;
};

void TraverseRtl::tick() {
  setup_.advance();
  l1_.land_before(cycle_);
  TraversePort::Inputs in;
  if (setup_.next_ready() <= cycle_ && !blocked(Port::kSetup)) {
    const uint32_t number = setup_.next_ray();
    if (number != next_ray_) {
      next_ray_ = number;
      next_ = {};
      next_dead_ = start(walk_, ray(number), next_) == Visit::kMiss;
      if (next_dead_) next_ = {};
    }
    in.ray = &next_;
    in.ray_dead = next_dead_;
    in.ray_number = number;
  }
  if (l1_.replay_waiting()) in.replay_context = l1_.replay_context();
  if (l1_.retry_possible()) in.retry_context = l1_.retry_context();
  in.hit_ready = sink_ready();
  in.texel = texel_;

  TraversePort::Outputs out = traverse_->evaluate(in);
  if (out.hit_valid && in.hit_ready) leave();
  HeightL1::Answer answer = HeightL1::Answer::kHit;
  if (out.replayed) {
    if (in.replay_context < 0) throw wrong("takes a replay that is not offered");
    l1_.replay(cycle_);
  }
  if (out.ray_taken) enter();
  if (out.lookup) {
    answer = look_up(out);
    if (answer == HeightL1::Answer::kHit) traverse_->answer(true);
  }
  count(out, answer, out.ray_taken);
  if (out.moves) texel_ = texel_at(out.address);
  traverse_->clock();
}

void TraverseRtl::enter() {
  const RaySetupUnit::Ready taken = setup_.take(cycle_);
  resident_.push_back({taken.ray, taken.sent, cycle_});
  setup_.advance();
}

void TraverseRtl::leave() {
  const HitRecord record = traverse_->hit();
  const auto found = std::find_if(resident_.begin(), resident_.end(),
                                  [&](const Resident& r) { return r.ray == record.ray_id; });
  if (found == resident_.end()) {
    throw wrong("sends ray " + std::to_string(record.ray_id) + ", which is not inside,");
  }
  ++counts_.rays;
  counts_.hits += record.status == HitStatus::kHit;
  counts_.resident_cycles += cycle_ - found->entered;
  retire(record, found->sent);
  *found = resident_.back();
  resident_.pop_back();
}

HeightL1::Answer TraverseRtl::look_up(const TraversePort::Outputs& out) {
  if (out.address >= site_.image_bytes)
    throw wrong("looks up address " + std::to_string(out.address) + ", outside the pyramid,");
  if (out.context >= site_.architecture.traverse.contexts)
    throw wrong("looks up for context " + std::to_string(out.context) + ", which is none,");
  if (out.slot_ray >= site_.order.size()) throw no_such_ray(out.slot_ray);
  if (out.retried && !l1_.retry_possible()) throw wrong("takes a retry that is not offered");
  if (out.retried) l1_.pop_retry();
  const HeightL1::Answer answer =
      l1_.lookup(static_cast<uint32_t>(out.address / line_bytes_), out.context, out.slot_ray, cycle_);
  if (answer == HeightL1::Answer::kRefused) l1_.push_retry(out.context);
  return answer;
}

void TraverseRtl::count(const TraversePort::Outputs& out, HeightL1::Answer answer, bool entered) {
  using Slot = HmtTopPort::Slot;
  Slot slot = Slot::kBubble;
  if (!out.moves) {
    slot = Slot::kStall;
    ++counts_.stalls;
  } else if (out.replayed) {
    slot = Slot::kStep;
    ++counts_.steps;
    ++counts_.replays;
  } else if (out.lookup) {
    switch (answer) {
      case HeightL1::Answer::kHit:
        slot = Slot::kStep;
        ++counts_.steps;
        break;
      case HeightL1::Answer::kAllocated:
      case HeightL1::Answer::kMerged:
        slot = answer == HeightL1::Answer::kMerged ? Slot::kMerge : Slot::kMiss;
        ++counts_.miss_slots;
        break;
      case HeightL1::Answer::kRefused:
        slot = Slot::kRefused;
        ++counts_.refused_slots;
        break;
    }
  } else if (entered) {
    slot = Slot::kDead;
    ++counts_.dead_slots;
  } else if (out.full) {
    ++counts_.contexts_full;
  } else if (no_ray_to_come() && setup_.empty()) {
    ++counts_.drain;
  } else {
    ++counts_.no_ray;
  }
  count_slot(slot, out.slot_ray);
}

}  // namespace

std::unique_ptr<RtlUnit> make_traverse_unit(const RtlJob& job, const HmtSite& site) {
  return std::make_unique<TraverseRtl>(job, site);
}

}  // namespace cuesta::rtl
