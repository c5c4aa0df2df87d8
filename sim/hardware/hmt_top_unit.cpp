#include <algorithm>

#include "models/common/error.h"
#include "models/units/height_l1/height_l1.h"
#include "sim/hardware/rtl_unit.h"

namespace cuesta::rtl {
namespace {

/// How many of the tables' counters the hardware counts: each has a register of its own, without a gap.
constexpr int kCounterRegisters = [] {
  uint64_t seen = 0;
  int rows = 0;
  const auto look_at = [&](const auto& table) {
    for (const auto& row : table) {
      if (row.rtl_register < 0) continue;
      seen |= uint64_t{1} << row.rtl_register;
      ++rows;
    }
  };
  look_at(kRaySetupCounters);
  look_at(kTraverseCounters);
  look_at(kHeightL1Counters);
  return seen == (uint64_t{1} << rows) - 1 ? rows : throw "two counters share a register, or one is left out";
}();

class HmtTopUnit final : public RtlUnit, public MemoryClient {
 public:
  HmtTopUnit(const RtlJob& job, const HmtSite& site)
      : RtlUnit("hmt_top", job, site),
        top_(job.set.make_hmt_top(job.seed)),
        mshrs_(static_cast<size_t>(site.architecture.height_l1.mshrs)),
        seen_((site.image_bytes / line_bytes()) / 64 + 1, 0) {
    top_->reset();
    configure();
    for (size_t c = 0; c < std::size(at_reset_); ++c) at_reset_[c] = counter(c);
  }

  Counts counts(Cycle end) override;
  Fill fill() const override;
  std::string who_waits() const override;

  void respond(int slot, Cycle response) override {
    const Cycle lands = earliest(response);
    mshrs_[static_cast<size_t>(slot)].lands = lands;
    next_landing_ = std::min(next_landing_, lands);
  }
  Cycle earliest(Cycle response) const override {
    return first_free_landing(response, site_.stalls, site_.pipeline, [&](Cycle lands) {
      return std::any_of(mshrs_.begin(), mshrs_.end(), [&](const Mshr& m) { return m.lands == lands; });
    });
  }

 private:
  struct Mshr {
    uint64_t address = 0;
    Cycle lands = kNever;
    bool waits = false;  ///< for its line
  };
  struct Inside {
    uint32_t ray;
    Cycle sent;
  };

  uint64_t line_bytes() const { return static_cast<uint64_t>(site_.architecture.height_l1.line_bytes); }
  uint64_t counter(size_t index) { return top_->read_register(kRegisterCounter + static_cast<int>(index)); }

  void configure();
  void tick() override;
  int inside() const override { return static_cast<int>(inside_.size()); }
  WavePort& waves() override { return *top_; }
  int landing_now() const;
  void request(int mshr, uint64_t address);

  std::unique_ptr<HmtTopPort> top_;
  std::vector<Mshr> mshrs_;
  Cycle next_landing_ = kNever;
  std::deque<uint32_t> owners_;  ///< of misses whose requests have not left
  std::vector<Inside> inside_;
  std::vector<uint64_t> seen_;  ///< lines ever asked for
  int64_t unique_lines_ = 0;
  uint64_t at_reset_[kCounterRegisters];
};

void HmtTopUnit::configure() {
  const MapShape& map = job_.work.map;
  const Schedule& schedule = job_.work.schedule;
  const NumberFormat format = job_.work.format;
  const uint64_t mode = in_field(ModeField::kRootLevel, map.root_level) |
                        in_field(ModeField::kBorder, map.address_mode == AddressMode::kBorder) |
                        in_field(ModeField::kStart, schedule.start) |
                        in_field(ModeField::kDown, schedule.down) | in_field(ModeField::kUp, schedule.up) |
                        in_field(ModeField::kStopLevel, schedule.stop_level) |
                        in_field(ModeField::kMorton, job_.layout.kind() == TexelLayoutKind::kMorton);
  const auto expect = [this](int address, uint64_t value) {
    const uint64_t held = top_->read_register(address);
    if (held == value) return;
    throw Error(ExitCode::kMismatch, "Register " + std::to_string(address) + " of hmt_top reads as " +
                                         std::to_string(held) + " in the place of " + std::to_string(value) +
                                         ": the hardware is not what rtl/README.md says.");
  };
  const auto set = [&](int address, uint64_t value) {
    top_->write_register(address, value);
    expect(address, value);
  };
  constexpr int kNoRegister = 63;
  expect(kNoRegister, 0);
  set(kRegisterMode, mode);
  set(kRegisterTimeEnd, (uint64_t{1} << time_bits(map, format)) - 1);
  set(kRegisterRootBound, static_cast<uint64_t>(job_.work.pyramid->highest()));
  for (int level = schedule.stop_level; level <= map.root_level; ++level) {
    top_->write_register(kRegisterLevelBase + level, job_.layout.offset(level, 0, 0));
  }
}

void HmtTopUnit::tick() {
  auto& queue = site_.dispatch.queue(site_.pipeline);
  if (queue.empty()) site_.dispatch.advance();
  HmtTopPort::Inputs in;
  if (!queue.empty() && queue.front().cycle + site_.architecture.ray_dispatch.latency_cycles <= cycle_ &&
      !blocked(Port::kDispatch)) {
    in.ray_number = queue.front().ray;
    in.ray = &ray(in.ray_number);
  }
  in.no_ray_to_come = no_ray_to_come();
  in.hit_ready = sink_ready();
  in.request_ready = !blocked(Port::kMemoryRequest);
  if (next_landing_ == cycle_) {
    in.fill_mshr = landing_now();
    Mshr& mshr = mshrs_[static_cast<size_t>(in.fill_mshr)];
    in.fill_data = job_.image.data() + mshr.address;
    mshr.lands = kNever;
    mshr.waits = false;
    next_landing_ = kNever;
    for (const Mshr& m : mshrs_) next_landing_ = std::min(next_landing_, m.lands);
  }

  const HmtTopPort::Outputs out = top_->evaluate(in);
  count_slot(out.slot, out.slot_ray);
  if (out.slot == HmtTopPort::Slot::kMiss) owners_.push_back(out.slot_ray);
  if (out.hit_valid && in.hit_ready) {
    const HitRecord record = top_->hit();
    const auto leaves =
        std::find_if(inside_.begin(), inside_.end(), [&](const Inside& r) { return r.ray == record.ray_id; });
    if (leaves == inside_.end()) {
      throw wrong("sends ray " + std::to_string(record.ray_id) + ", which is not inside,");
    }
    retire(record, leaves->sent);
    *leaves = inside_.back();
    inside_.pop_back();
  }
  if (out.request_valid && in.request_ready) request(out.request_mshr, out.request_address);
  if (in.ray != nullptr && out.ray_ready) {
    inside_.push_back({in.ray_number, queue.front().cycle});
    if (site_.log != nullptr) site_.log->entries.push_back({cycle_, in.ray_number});
    queue.pop_front();
    site_.dispatch.give_credit(site_.pipeline,
                               cycle_ + site_.architecture.ray_dispatch.credit_latency_cycles);
  }
  top_->clock();
}

int HmtTopUnit::landing_now() const {
  int mshr = 0;
  while (mshrs_[static_cast<size_t>(mshr)].lands != cycle_) ++mshr;
  return mshr;
}

void HmtTopUnit::request(int mshr, uint64_t address) {
  const std::string asks = "asks for address " + std::to_string(address);
  if (owners_.empty()) throw wrong(asks + " without a miss");
  if (address >= site_.image_bytes || address % line_bytes() != 0)
    throw wrong(asks + ", which is no line of the pyramid,");
  if (static_cast<size_t>(mshr) >= mshrs_.size() || mshrs_[static_cast<size_t>(mshr)].waits)
    throw wrong(asks + " with MSHR " + std::to_string(mshr) + ", which waits or is none,");
  mshrs_[static_cast<size_t>(mshr)] = {address, kNever, true};
  const uint64_t line = address / line_bytes();
  unique_lines_ += static_cast<int64_t>(~seen_[line / 64] >> (line % 64) & 1);
  seen_[line / 64] |= uint64_t{1} << (line % 64);
  const uint32_t owner = owners_.front();
  owners_.pop_front();
  if (site_.log != nullptr) site_.log->requests.push_back({cycle_, mshr, address, owner});
  site_.memory.send(
      {cycle_, site_.pipeline, false, mshr, owner, static_cast<int32_t>(line_bytes()), address, this});
}

HmtUnit::Counts HmtTopUnit::counts(Cycle end) {
  drain_until(end);
  const auto read = [&]<class C, size_t N>(const CounterRow<C>(&table)[N], C& counts) {
    for (const CounterRow<C>& row : table) {
      if (row.rtl_register < 0) continue;
      counts.*row.field = static_cast<int64_t>(counter(row.rtl_register) - at_reset_[row.rtl_register]);
    }
  };
  Counts all;
  read(kRaySetupCounters, all.ray_setup);
  read(kTraverseCounters, all.traverse);
  read(kHeightL1Counters, all.height_l1);
  all.height_l1.fill_bytes = all.height_l1.fills * static_cast<int64_t>(line_bytes());
  all.height_l1.unique_lines = unique_lines_;
  return all;
}

HmtUnit::Fill HmtTopUnit::fill() const {
  const int waiting = static_cast<int>(site_.dispatch.queue(site_.pipeline).size());
  return {waiting + inside() - in_context(), in_context(), 0, 0};  // MSHRs and retries show at no port
}

std::string HmtTopUnit::who_waits() const {
  return "hmt_top[" + std::to_string(site_.pipeline) + "] (RTL) holds " + std::to_string(inside_.size()) +
         " rays, " + std::to_string(site_.dispatch.queue(site_.pipeline).size()) + " wait in front of it; " +
         std::to_string(
             std::count_if(mshrs_.begin(), mshrs_.end(), [](const Mshr& m) { return m.lands != kNever; })) +
         " fills are on their way; " + site_.sink.who_waits();
}

}  // namespace

std::unique_ptr<RtlUnit> make_hmt_top_unit(const RtlJob& job, const HmtSite& site) {
  return std::make_unique<HmtTopUnit>(job, site);
}

}  // namespace cuesta::rtl
