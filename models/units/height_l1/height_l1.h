#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "models/common/ring.h"
#include "models/units/height_l1/counters.h"
#include "models/units/height_l1/parameters.h"
#include "models/units/memory/memory_port.h"
#include "models/units/ports/port_log.h"
#include "models/units/ports/port_stalls.h"

namespace cuesta {

/// One fill a cycle: the first cycle from `response` on that is not held back and that no other pending fill has
/// `booked(cycle)`.
template <class Booked>
Cycle first_free_landing(Cycle response, const PortStalls* stalls, int pipeline, Booked booked) {
  for (Cycle lands = response;; ++lands) {
    lands = PortStalls::free_from(stalls, Port::kMemoryResponse, pipeline, lands);
    if (!booked(lands)) return lands;
  }
}

/// Returns a bit for each element of the four: bit k is set where element k equals `line`.
inline unsigned equal_of_four(const uint32_t* four, uint32_t line) {
#if defined(__SSE2__)
  const __m128i lines = _mm_loadu_si128(reinterpret_cast<const __m128i*>(four));
  const __m128i equal = _mm_cmpeq_epi32(lines, _mm_set1_epi32(static_cast<int>(line)));
  return static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(equal)));
#else
  return unsigned{four[0] == line} | unsigned{four[1] == line} << 1 | unsigned{four[2] == line} << 2 |
         unsigned{four[3] == line} << 3;
#endif
}

/// height_l1: the private cache of pyramid texels of one pipeline; non-blocking, misses parked and merged
/// (`accumulate`, after the ray accumulation unit of the T&I engine).
///
/// Ports: one lookup a cycle from traverse; requests to dram; fills from dram; a replay port to traverse. All
/// registered: a lookup in cycle c sees the lines that had landed by c - 1 and everything the lookup of c - 1 did.
/// Timing: a miss allocates the free MSHR of lowest index, or is merged into the pending one of its line, or,
/// with none free, goes to the retry FIFO (a place for every context). A request leaves in the cycle of its
/// allocation (one a cycle). A fill that lands in c is read from c + 1 on; its waiters are replayed from c + 1
/// on, one per slot that traverse has free, with the texel, without another lookup; the MSHR is free in the
/// cycle after its last waiter went. The victim, the least recently used way, is chosen and made most recently
/// used at allocation; its old line can be read until the fill lands.
class HeightL1 final : public MemoryClient {
 public:
  using Counts = HeightL1Counts;

  static constexpr uint32_t kNoLine = ~0u;

  enum class Answer : uint8_t { kHit, kAllocated, kMerged, kRefused };

  HeightL1(const HeightL1Parameters& parameters, int contexts, uint64_t image_bytes, int pipeline,
           MemoryPort& memory, const PortStalls* stalls)
      : line_bytes_(parameters.line_bytes),
        line_shift_(std::countr_zero(static_cast<unsigned>(parameters.line_bytes))),
        pipeline_(pipeline),
        memory_(memory),
        stalls_(stalls),
        lines_(static_cast<size_t>(parameters.size_bytes / parameters.line_bytes), kNoLine),
        used_(lines_.size(), 0),
        sets_(lines_, used_, static_cast<uint32_t>(parameters.ways)),
        mshrs_(static_cast<size_t>(parameters.mshrs)),
        pending_lines_((mshrs_.size() + 3) / 4 * 4, kNoLine),
        free_mshrs_(parameters.mshrs == 64 ? ~uint64_t{0} : (uint64_t{1} << parameters.mshrs) - 1),
        landings_(mshrs_.size()),
        next_waiter_(static_cast<size_t>(contexts), -1),
        landed_(mshrs_.size()),
        retry_(next_waiter_.size()),
        seen_((image_bytes >> line_shift_) / 64 + 1, 0) {}

  HeightL1(const HeightL1&) = delete;  // sets_ looks into this one's lines
  HeightL1& operator=(const HeightL1&) = delete;

  /// Adds requests to `log` from now on.
  void log_ports(PortLog* log) { log_ = log; }

  /// Looks a line up: the context's ray asks for a texel of `line` (address / line_bytes) in `cycle`; `ray` owns the
  /// miss that it may cause.
  Answer lookup(uint32_t line, int context, uint32_t ray, Cycle cycle) {
    if (!touch(line, cycle)) return miss(line, context, ray, cycle);
    count_hits(1);
    return Answer::kHit;
  }

  /// The sets as lookups see them, to be kept at hand while no fill lands.
  class Sets {
   public:
    Sets(std::span<uint32_t> lines, std::span<Cycle> used, uint32_t ways)
        : lines_(lines), used_(used), ways_(ways), mask_(static_cast<uint32_t>(lines.size()) / ways - 1) {}

    /// A lookup for a step of `cycle` that counts only where it hits: by `count_hits`, once for many. False where the
    /// line is not there now.
    bool touch(uint32_t line, Cycle cycle) const {
      const uint32_t hit = find(line);
      if (hit == kNoLine) return false;
      used_[hit] = cycle + 1;
      return true;
    }

   private:
    friend class HeightL1;

    uint32_t first_way(uint32_t line) const { return (line & mask_) * ways_; }
    /// Returns the way that holds the line, or kNoLine. Which one it is is as good as random to a branch predictor:
    /// all are compared, one is selected.
    uint32_t find(uint32_t line) const {
      const uint32_t first = first_way(line);
      uint32_t hit = kNoLine;
      if (ways_ == 4) {
        const unsigned equal = equal_of_four(&lines_[first], line);
        return equal == 0 ? kNoLine : first + static_cast<uint32_t>(std::countr_zero(equal));
      }
      for (uint32_t way = first; way < first + ways_; ++way) hit = lines_[way] == line ? way : hit;
      return hit;
    }

    std::span<uint32_t> lines_;  ///< sets x ways
    std::span<Cycle> used_;      ///< 1 + the cycle of the last use; 0: never
    uint32_t ways_;
    uint32_t mask_;
  };
  Sets sets() const { return sets_; }
  bool touch(uint32_t line, Cycle cycle) { return sets_.touch(line, cycle); }
  void count_hits(int64_t hits) {
    counts_.accesses += hits;
    counts_.hits += hits;
  }

  /// Lets the fills land whose cycle is below `cycle`.
  void land_before(Cycle cycle) {
    while (next_landing_ < cycle) land_one();
  }
  Cycle next_landing() const { return next_landing_; }

  bool replay_waiting() const { return !landed_.empty(); }
  /// Returns the context that `replay` would let go on.
  int replay_context() const { return mshrs_[static_cast<size_t>(landed_.front())].first_waiter; }
  /// Replays, in `cycle`, one waiter of the first landed line; returns its context.
  int replay(Cycle cycle);

  void push_retry(int context) { retry_.push_back(context); }
  /// A slot does one thing a cycle, so an MSHR freed by this cycle's replay is never asked for in this cycle.
  bool retry_possible() const { return !retry_.empty() && free_mshrs_ != 0; }
  int retry_context() const { return retry_.front(); }
  int pop_retry() {
    const int context = retry_.front();
    retry_.pop_front();
    return context;
  }

  void respond(int slot, Cycle response) override;
  Cycle earliest(Cycle response) const override;

  const Counts& counts() const { return counts_; }
  /// At the end of cycle `end` - 1, with the cycles so far of MSHRs that are taken.
  Counts counts_until(Cycle end) const;
  int mshrs_taken() const { return static_cast<int>(mshrs_.size()) - std::popcount(free_mshrs_); }
  size_t retry_fill() const { return retry_.size(); }

 private:
  struct Mshr {
    uint32_t victim_way;
    int first_waiter, last_waiter;
    Cycle allocated;
  };
  struct Landing {
    Cycle cycle;
    int slot;  ///< MSHR
  };

  Answer miss(uint32_t line, int context, uint32_t ray, Cycle cycle);
  void land_one();

  int line_bytes_;
  int line_shift_;
  int pipeline_;
  MemoryPort& memory_;
  const PortStalls* stalls_;
  PortLog* log_ = nullptr;
  std::vector<uint32_t> lines_;  ///< of sets_
  std::vector<Cycle> used_;      ///< of sets_
  Sets sets_;
  std::vector<Mshr> mshrs_;
  std::vector<uint32_t>
      pending_lines_;             ///< per MSHR, to a multiple of four: the line that has not yet landed
  uint64_t free_mshrs_;           ///< bit set: free
  Ring<Landing> landings_;        ///< of the pending ones that were answered, by cycle
  std::vector<int> next_waiter_;  ///< per context
  Ring<int> landed_;              ///< the fill FIFO: MSHRs whose waiters are being replayed
  Ring<int> retry_;
  Cycle next_landing_ = kNever;
  Cycle last_leave_ = -1;
  std::vector<uint64_t> seen_;  ///< lines ever asked for
  Counts counts_;
};

}  // namespace cuesta
