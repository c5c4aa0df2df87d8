#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "models/common/error.h"
#include "models/heightmap/generator.h"
#include "sim/config/on_architecture.h"
#include "sim/hardware/hmt_top_port.h"
#include "sim/hardware/traverse_port.h"
#include "sim/machine/cycle_machine.h"

// Hardware is anybody's: whatever its ports say, the simulator ends with a sentence.

namespace cuesta {
namespace rtl {
namespace {

std::function<void(HmtTopPort::Outputs&)> hmt_top_says;
std::function<void(TraversePort::Outputs&)> traverse_says;

class WrongHmtTop final : public HmtTopPort {
 public:
  void reset() override {}
  void write_register(int address, uint64_t data) override { registers_[address] = data; }
  uint64_t read_register(int address) override { return registers_[address]; }
  Outputs evaluate(const Inputs&) override {
    Outputs out{.ray_ready = true};
    hmt_top_says(out);
    return out;
  }
  HitRecord hit() const override { return {.ray_id = 123456}; }
  void clock() override {}
  void open_waves(const std::string&, int64_t) override {}
  void close_waves() override {}

 private:
  std::map<int, uint64_t> registers_;  ///< what it is configured by is right
};

class WrongTraverse final : public TraversePort {
 public:
  void reset() override {}
  void configure(const Settings&) override {}
  Outputs evaluate(const Inputs&) override {
    Outputs out{};
    out.moves = true;
    traverse_says(out);
    return out;
  }
  void answer(bool) override {}
  HitRecord hit() const override { return {.ray_id = 123456}; }
  void clock() override {}
  void open_waves(const std::string&, int64_t) override {}
  void close_waves() override {}
};

}  // namespace

/// In the place of the compiled sets: mobile.
std::span<const RtlSet> rtl_sets() {
  static const RtlSet sets[] = {
      {"wrong",
       {12, 8, 8, 32, 12, 4, 24, 4, 8, 8, 32, 16384, 64, 4, 8},
       [](int) -> std::unique_ptr<HmtTopPort> { return std::make_unique<WrongHmtTop>(); },
       [](int) -> std::unique_ptr<TraversePort> { return std::make_unique<WrongTraverse>(); }}};
  return sets;
}

namespace {

/// What the run of one ray ends with; empty: no error.
std::string sentence(Implementation UnitParameters::*unit) {
  const Pyramid pyramid = build_max_pyramid({16, 16, 8, std::vector<uint16_t>(256, 7)});
  Architecture architecture;
  architecture.units.*unit = Implementation::kRtl;
  architecture.machine.no_progress_cycles = 5000;
  Workload work;
  work.pyramid = &pyramid;
  work.map = {16, 16, 4, 8, AddressMode::kWrap};
  set_numbers(work, architecture);
  const MachineRay ray =
      quantise({.origin = {0.5, 0.5, 1}, .direction = {0.1, 0.2, -1}}, work.map, work.format);
  const uint32_t pixel = 0;
  work.rays = {&ray, 1};
  work.pixel_of_ray = {&pixel, 1};
  work.width = work.height = 1;
  try {
    run_cycle(work, architecture);
  } catch (const Error& error) {
    EXPECT_TRUE(error.code() == ExitCode::kMismatch || error.code() == ExitCode::kNoProgress);
    return error.what();
  }
  return {};
}

TEST(WrongHardware, HmtTopEndsTheRunWithASentence) {
  using Out = HmtTopPort::Outputs;
  using Slot = HmtTopPort::Slot;
  const struct {
    std::function<void(Out&)> says;
    const char* part;
  } cases[] = {
      {[](Out&) {}, "no step was finished"},
      {[](Out& o) { o.slot = Slot::kStep, o.slot_ray = 77; }, "works on ray 77 of 1"},
      {[](Out& o) { o.slot = Slot::kStep; }, "more than 6384 slots"},
      {[](Out& o) { o.hit_valid = true; }, "sends ray 123456, which is not inside"},
      {[](Out& o) { o.request_valid = true; }, "without a miss"},
      {[](Out& o) { o.slot = Slot::kMiss, o.request_valid = true, o.request_address = 1 << 20; },
       "no line of the pyramid"},
      {[](Out& o) { o.slot = Slot::kMiss, o.request_valid = true, o.request_mshr = 8; }, "MSHR 8"},
      {[](Out& o) { o.slot = Slot::kMiss, o.request_valid = true; }, "MSHR 0, which waits"},
  };
  for (const auto& [says, part] : cases) {
    hmt_top_says = says;
    const std::string text = sentence(&UnitParameters::hmt_top);
    EXPECT_NE(text.find(part), std::string::npos) << part << ": " << text;
  }
}

TEST(WrongHardware, TraverseEndsTheRunWithASentence) {
  using Out = TraversePort::Outputs;
  const struct {
    std::function<void(Out&)> says;
    const char* part;
  } cases[] = {
      {[](Out&) {}, "no step was finished"},
      {[](Out& o) { o.hit_valid = true; }, "sends ray 123456, which is not inside"},
      {[](Out& o) { o.replayed = true; }, "takes a replay that is not offered"},
      {[](Out& o) { o.lookup = o.retried = true; }, "takes a retry that is not offered"},
      {[](Out& o) { o.lookup = true, o.address = 1 << 20; }, "outside the pyramid"},
      {[](Out& o) { o.lookup = true, o.context = 32; }, "context 32"},
      {[](Out& o) { o.lookup = true, o.slot_ray = 9; }, "ray 9 of 1"},
  };
  for (const auto& [says, part] : cases) {
    traverse_says = says;
    const std::string text = sentence(&UnitParameters::traverse);
    EXPECT_NE(text.find(part), std::string::npos) << part << ": " << text;
  }
}

}  // namespace
}  // namespace rtl
}  // namespace cuesta
