#pragma once

#include <array>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "sim/rtl/hmt_top_port.h"
#include "tests/twins/dram_twin.h"
#include "tests/twins/hit_queue_twin.h"
#include "tests/twins/random_machine.h"
#include "tests/twins/ray_dispatch_twin.h"
#include "tests/twins/result_writer_twin.h"

namespace cuesta::rtl {

using MakeHmtTop = std::function<std::unique_ptr<HmtTopPort>()>;

struct RtlRun {
  std::vector<HitRecord> hits;  ///< in the order of the trace
  std::vector<Cycle> completed;
  std::vector<std::array<uint64_t, std::size(kCounters)>> counters;  ///< per pipeline
  Cycle cycles = 0;
};

/// The machine with Verilated pipelines: hmt_top in the place of ray_setup, traverse and height_l1, ticking twins
/// around it. The port between ray_setup and traverse is inside: it knows no stalls.
class RtlMachine {
 public:
  static constexpr Cycle kMostCycles = 50'000'000;

  RtlMachine(const twins::RandomMachine& machine, const HmtTopSet& set, const MakeHmtTop& make);

  /// To the end, or to `kMostCycles`: then rays are missing.
  RtlRun run();

 private:
  struct Waiting {
    int ray;
    Cycle from;
  };
  struct Pipeline {
    std::unique_ptr<HmtTopPort> top;
    std::deque<Waiting> queue;  ///< in front of ray_setup
    twins::HitQueueTwin hit_queue;
    twins::ResultWriterTwin writer;
    std::vector<uint64_t> lines;  ///< byte address per MSHR
    int inside = 0;
    std::array<uint64_t, std::size(kCounters)> counters_at_start{};
  };

  void tick(Cycle cycle);
  void tick_pipeline(int p, Cycle cycle, std::vector<twins::DramTwin::Request>& requests);
  bool finished() const;

  const twins::RandomMachine& machine_;
  Architecture architecture_;
  Workload work_;
  TexelLayout layout_;
  std::vector<std::byte> image_;
  std::vector<uint32_t> order_;
  std::vector<uint32_t> pixels_;
  PortStalls stalls_;
  std::optional<twins::RayDispatchTwin> dispatch_;
  std::optional<twins::DramTwin> dram_;
  uint64_t write_base_ = 0;
  std::vector<Pipeline> pipelines_;
  RtlRun run_;
};

}  // namespace cuesta::rtl
