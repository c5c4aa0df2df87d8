#include <gtest/gtest.h>
#include <verilated.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <iostream>
#include <map>
#include <sstream>
#include <vector>

#include "Vheight_l1_direct.h"
#include "Vheight_l1_mobile.h"
#include "Vheight_l1_odd.h"
#include "models/common/random.h"
#include "models/units/height_l1/height_l1.h"
#include "models/units/memory/memory_port.h"
#include "models/units/memory/outside_memory.h"

// rtl/height_l1/height_l1.sv against HeightL1 of models/units: the same random lookups, replays and retries under
// random stalls, with fills after random latencies in any order; every answer, request, texel and counter, cycle by
// cycle.

namespace cuesta {
namespace {

/// What an RTL under test is compiled for.
struct Set {
  int size_bytes, line_bytes, ways, mshrs, contexts, height_bits;
};

constexpr Set kMobile{16384, 64, 4, 8, 32, 8};
constexpr Set kDirect{256, 16, 1, 1, 3, 8};     // one way, one MSHR, and lines of the shortest length
constexpr Set kOdd{96 * 16, 32, 3, 5, 13, 16};  // numbers that are no powers of two, two bytes a texel

struct Totals {
  int64_t lookups = 0, requests = 0, configurations = 0;
  std::map<std::string, int64_t> answers;
};

/// A random stream of what traverse may do.
struct Stream {
  explicit Stream(Random& random) {
    lines = static_cast<uint64_t>(random.between(1, random.chance(0.5) ? 12 : 400));
    lookup = static_cast<int>(random.between(50, 1000));
    replay = static_cast<int>(random.between(100, 1000));
    retry = static_cast<int>(random.between(100, 1000));
    still = random.chance(0.5) ? 0 : static_cast<int>(random.between(1, 700));
    least = random.between(1, random.chance(0.5) ? 3 : 60);
    most = random.between(least, random.chance(0.5) ? least + 3 : 300);
    stalls.seed = random.next();
    for (const Port port : {Port::kMemoryRequest, Port::kMemoryResponse}) {
      if (random.chance(0.4)) continue;
      stalls.per_mille[static_cast<int>(port)] = static_cast<uint16_t>(random.between(1, 900));
    }
  }
  uint64_t lines;                    ///< that are asked for
  int lookup, replay, retry, still;  ///< chances per mille in a cycle
  Cycle least, most;                 ///< latency of a fill
  PortStalls stalls;
};

/// The requests that the model sends; answers come from `serve`.
struct Memory final : OutsideMemory {
  struct Pending {
    uint64_t number;
    MemoryRequest request;
    Cycle response;
  };
  void request(uint64_t number, const MemoryRequest& request) override {
    fresh.push_back({number, request, 0});
  }
  std::vector<Pending> fresh;
};

template <class V>
class Bench {
 public:
  Bench(const Set& set, uint64_t seed)
      : set_(set),
        random_(seed),
        stream_(random_),
        level_(memory_, costs_),
        port_(level_, false),
        model_({set.size_bytes, set.line_bytes, set.ways, set.mshrs}, set.contexts,
               stream_.lines * static_cast<uint64_t>(set.line_bytes), 0, port_, &stream_.stalls),
        image_(stream_.lines * static_cast<uint64_t>(set.line_bytes)),
        fill_lines_(static_cast<size_t>(set.mshrs)) {
    costs_.resize(static_cast<size_t>(set.contexts));
    for (std::byte& byte : image_) byte = static_cast<std::byte>(random_.below(256));
    for (int context = 0; context < set.contexts; ++context) free_.push_back(context);
    addresses_.resize(static_cast<size_t>(set.contexts));
    model_.log_ports(&log_);
    context_.randReset(2);
    context_.randSeed(static_cast<int>(seed % 1000000) + 1);
    rtl_.emplace(&context_);
    rtl_->rst_ni = 0;
    idle();
    clock();
    rtl_->rst_ni = 1;
  }

  /// The first difference; empty: none.
  std::string run(Cycle cycles, Totals& totals) {
    for (cycle_ = 0; cycle_ < cycles; ++cycle_) {
      const std::string found = tick();
      if (!found.empty()) {
        std::ostringstream text;
        text << "cycle " << cycle_ << ": " << found << "\n"
             << stream_.lines << " lines, latency " << stream_.least << " to " << stream_.most << ", chances "
             << stream_.lookup << ' ' << stream_.replay << ' ' << stream_.retry << ' ' << stream_.still;
        return text.str();
      }
    }
    totals.lookups += model_.counts().accesses;
    totals.requests += model_.counts().misses;
    totals.answers["hits"] += model_.counts().hits;
    totals.answers["merges"] += model_.counts().merges;
    totals.answers["refused"] += model_.counts().refused;
    totals.answers["evictions"] += model_.counts().evictions;
    totals.answers["replays"] += replays_;
    totals.answers["retries"] += retries_;
    ++totals.configurations;
    return {};
  }

 private:
  bool chance(int per_mille) { return static_cast<int>(random_.below(1000)) < per_mille; }
  void idle() {
    rtl_->enable_i = rtl_->lookup_valid_i = rtl_->lookup_retry_i = rtl_->replay_take_i = rtl_->fill_valid_i =
        0;
    rtl_->request_ready_i = 0;
  }
  void clock() {
    rtl_->clk_i = 0;
    rtl_->eval();
    rtl_->clk_i = 1;
    rtl_->eval();
  }
  uint32_t texel_at(uint64_t address) const {
    const auto low = static_cast<uint32_t>(image_[address]);
    if (set_.height_bits <= 8) return low;
    return (low | static_cast<uint32_t>(image_[address + 1]) << 8) & ((1u << set_.height_bits) - 1);
  }
  uint64_t random_address() {
    const auto texel = static_cast<uint64_t>(set_.height_bits > 8 ? 2 : 1);
    const uint64_t line = random_.below(stream_.lines);
    return line * static_cast<uint64_t>(set_.line_bytes) +
           random_.below(static_cast<uint64_t>(set_.line_bytes) / texel) * texel;
  }
  template <class A, class B>
  void compare(const std::string& what, A model, B rtl) {
    if (!found_.empty() || static_cast<int64_t>(model) == static_cast<int64_t>(rtl)) return;
    std::ostringstream text;
    text << what << ": model " << static_cast<int64_t>(model) << ", RTL " << static_cast<int64_t>(rtl)
         << std::hex << " (0x" << static_cast<int64_t>(model) << ", 0x" << static_cast<int64_t>(rtl) << ")";
    found_ = text.str();
  }

  std::string tick();
  void look_up(int context, bool retried);
  void memory_after();

  Set set_;
  Random random_;
  Stream stream_;
  Memory memory_;
  std::vector<MemoryCost> costs_;
  OutsideLevel level_;
  MemoryPort port_;
  HeightL1 model_;
  PortLog log_;
  std::vector<std::byte> image_;
  std::vector<uint64_t> fill_lines_;  ///< per MSHR: the line's address
  VerilatedContext context_;
  std::optional<V> rtl_;
  Cycle cycle_ = 0;
  std::vector<int> free_;            ///< contexts that may look up
  std::vector<uint64_t> addresses_;  ///< per context: the last lookup's
  std::optional<uint32_t> texel_;    ///< that follows
  std::map<Cycle, int> landings_;    ///< cycle -> MSHR
  std::vector<Memory::Pending> unanswered_;
  size_t compared_requests_ = 0;
  int64_t evictions_ = 0, replays_ = 0, retries_ = 0;
  std::string found_;
};

/// The port's own lookup, in both.
template <class V>
void Bench<V>::look_up(int context, bool retried) {
  const uint64_t address = addresses_[static_cast<size_t>(context)];
  rtl_->lookup_valid_i = 1;
  rtl_->lookup_retry_i = retried;
  rtl_->lookup_address_i = static_cast<uint32_t>(address);
  rtl_->lookup_context_i = static_cast<uint8_t>(context);
  rtl_->eval();
  if (retried) compare("retried context", model_.pop_retry(), context);
  const HeightL1::Answer answer =
      model_.lookup(static_cast<uint32_t>(address / static_cast<uint64_t>(set_.line_bytes)), context,
                    static_cast<uint32_t>(context), cycle_);
  if (answer == HeightL1::Answer::kRefused) model_.push_retry(context);
  compare("lookup hits", answer == HeightL1::Answer::kHit, rtl_->lookup_hit_o);
  compare("lookup misses", answer == HeightL1::Answer::kAllocated, rtl_->miss_o);
  compare("lookup merges", answer == HeightL1::Answer::kMerged, rtl_->merge_o);
  compare("lookup is refused", answer == HeightL1::Answer::kRefused, rtl_->refuse_o);
  if (answer == HeightL1::Answer::kHit) {
    free_.push_back(context);
    texel_ = texel_at(address);
  }
}

template <class V>
std::string Bench<V>::tick() {
  idle();
  model_.land_before(cycle_);
  rtl_->request_ready_i = !stream_.stalls.blocked(Port::kMemoryRequest, 0, cycle_);
  // A fill of this cycle; its waiters are replayed from the next on.
  const int64_t evictions_before = model_.counts().evictions;
  const auto landing = landings_.find(cycle_);
  if (landing != landings_.end()) {
    rtl_->fill_valid_i = 1;
    rtl_->fill_mshr_i = static_cast<uint8_t>(landing->second);
    std::memcpy(rtl_->fill_data_i.data(), image_.data() + fill_lines_[static_cast<size_t>(landing->second)],
                static_cast<size_t>(set_.line_bytes));
  }
  rtl_->clk_i = 0;
  rtl_->eval();
  compare("evictions so far", evictions_before, evictions_);
  evictions_ += rtl_->evict_o;
  compare("replay offered", model_.replay_waiting(), rtl_->replay_valid_o);
  compare("retry offered", model_.retry_possible(), rtl_->retry_valid_o);
  compare("MSHRs taken", model_.mshrs_taken(), rtl_->mshrs_o);
  if (texel_) compare("texel", *texel_, rtl_->texel_o);

  if (!chance(stream_.still)) {
    // What a slot of traverse does: replay, else retry, else a lookup; or nothing.
    rtl_->enable_i = 1;
    texel_.reset();
    if (model_.replay_waiting()) {
      if (chance(stream_.replay)) {
        const auto context = static_cast<int>(rtl_->replay_context_o);
        rtl_->replay_take_i = 1;
        rtl_->lookup_address_i =
            static_cast<uint32_t>(addresses_[static_cast<size_t>(context) % addresses_.size()]);
        compare("replayed context", model_.replay(cycle_), context);
        if (!found_.empty()) return found_;
        ++replays_;
        free_.push_back(context);
        texel_ = texel_at(addresses_[static_cast<size_t>(context)]);
      }
    } else if (model_.retry_possible() && chance(stream_.retry)) {
      ++retries_;
      look_up(static_cast<int>(rtl_->retry_context_o), true);
    } else if (!free_.empty() && chance(stream_.lookup)) {
      const size_t pick = random_.below(free_.size());
      const int context = free_[pick];
      free_.erase(free_.begin() + static_cast<std::ptrdiff_t>(pick));
      addresses_[static_cast<size_t>(context)] = random_address();
      look_up(context, false);
    }
    rtl_->eval();
  } else {
    // What is asked for while the pipe stands still does not happen.
    rtl_->lookup_valid_i = chance(500);
    rtl_->replay_take_i = model_.replay_waiting() && chance(500);
    rtl_->lookup_retry_i = model_.retry_possible() && rtl_->lookup_valid_i && chance(500);
    rtl_->lookup_address_i = static_cast<uint32_t>(random_address());
    rtl_->lookup_context_i = static_cast<uint8_t>(random_.below(static_cast<uint64_t>(set_.contexts)));
    rtl_->eval();
  }

  // The request of this cycle, and its answer's time.
  const bool leaves = rtl_->request_valid_o && rtl_->request_ready_i;
  const bool model_leaves =
      compared_requests_ < log_.requests.size() && log_.requests[compared_requests_].cycle == cycle_;
  compare("a request leaves", model_leaves, leaves);
  if (leaves && model_leaves) {
    const PortLog::Request& request = log_.requests[compared_requests_++];
    compare("request's MSHR", request.mshr, rtl_->request_mshr_o);
    compare("request's address", request.address, rtl_->request_address_o);
    fill_lines_[static_cast<size_t>(request.mshr)] = request.address;
  }
  if (!found_.empty()) return found_;
  memory_after();
  rtl_->clk_i = 1;
  rtl_->eval();
  return found_;
}

/// Requests that have left are answered after random times; one that lands is booked for both.
template <class V>
void Bench<V>::memory_after() {
  landings_.erase(cycle_);
  port_.serve_until(cycle_ + 1);
  for (const Memory::Pending& fresh : memory_.fresh) {
    const Cycle response = fresh.request.leaves + random_.between(stream_.least, stream_.most);
    const Cycle lands = model_.earliest(response);
    fresh.request.client->respond(fresh.request.slot, response);
    landings_[lands] = fresh.request.slot;
  }
  memory_.fresh.clear();
}

template <class V>
void compare_all(const Set& set) {
  int64_t wanted = 300'000;
  if (const char* told = std::getenv("CUESTA_RTL_RAYS")) wanted = std::max<int64_t>(1, 15 * std::stoll(told));
  Totals totals;
  for (uint64_t seed = 1; totals.lookups < wanted; ++seed) {
    Bench<V> bench(set, seed);
    const std::string found = bench.run(2000, totals);
    if (!found.empty()) FAIL() << "seed " << seed << ", " << found;
  }
  std::cout << totals.lookups << " lookups, " << totals.requests << " requests, " << totals.configurations
            << " configurations:";
  for (const auto& [what, count] : totals.answers) {
    std::cout << ' ' << count << ' ' << what;
    EXPECT_GT(count, totals.lookups / 1000) << what << " were hardly met";
  }
  std::cout << '\n';
}

TEST(HeightL1Rtl, MobileEqualsTheModelUnderRandomLookupsStallsAndFills) {
  compare_all<Vheight_l1_mobile>(kMobile);
}
TEST(HeightL1Rtl, OneWayAndOneMshrEqualTheModel) { compare_all<Vheight_l1_direct>(kDirect); }
TEST(HeightL1Rtl, ThreeWaysFiveMshrsAndTwoBytesATexelEqualTheModel) { compare_all<Vheight_l1_odd>(kOdd); }

}  // namespace
}  // namespace cuesta
