#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <optional>
#include <set>
#include <vector>

#include "models/units/architecture.h"
#include "models/units/ports/port_stalls.h"

namespace cuesta::twins {

/// height_l1: exact LRU, misses merged in MSHRs, a retry FIFO for those that find none, a fill FIFO from which
/// parked rays are replayed. At most one lookup, one replay or retry and one fill in a cycle.
class HeightL1Twin {
 public:
  enum class Answer { kHit, kMerged, kAllocated, kRefused };

  struct Request {
    int mshr;
    uint64_t line;
    int owner;  ///< the ray whose miss allocated the MSHR
  };

  HeightL1Twin(const HeightL1Parameters& parameters, int pipeline, const PortStalls& stalls)
      : pipeline_(pipeline),
        stalls_(stalls),
        set_count_(static_cast<uint64_t>(parameters.size_bytes / (parameters.line_bytes * parameters.ways))),
        sets_(set_count_, std::vector<Way>(static_cast<size_t>(parameters.ways))),
        mshrs_(static_cast<size_t>(parameters.mshrs)) {}

  /// A ray can be replayed in this cycle.
  bool replay_ready() const { return !fill_fifo_.empty(); }
  /// A refused ray can be looked up again in this cycle.
  bool retry_ready() const { return !retry_fifo_.empty() && free_mshr() >= 0; }

  int take_replay() {
    replayed_ = true;
    return mshrs_[fill_fifo_.front()].waiters.front();
  }
  int take_retry() {
    retried_ = true;
    return retry_fifo_.front();
  }

  Answer lookup(int ray, uint64_t line) {
    std::vector<Way>& set = sets_[line % set_count_];
    looked_up_ = Lookup{ray, line, Answer::kRefused, 0, 0};
    Lookup& now = *looked_up_;
    for (size_t w = 0; w < set.size(); ++w) {
      if (set[w].valid && set[w].line == line) {
        now.answer = Answer::kHit;
        now.way = static_cast<int>(w);
        return now.answer;
      }
    }
    for (size_t m = 0; m < mshrs_.size(); ++m) {
      if (mshrs_[m].allocated && !mshrs_[m].landed && mshrs_[m].line == line) {
        now.answer = Answer::kMerged;
        now.mshr = static_cast<int>(m);
        return now.answer;
      }
    }
    now.mshr = free_mshr();
    if (now.mshr < 0) return now.answer;
    now.answer = Answer::kAllocated;
    now.way = victim(set);
    return now.answer;
  }

  /// The request that leaves for dram in `cycle`; asked once a cycle, after the cycle's lookup.
  std::optional<Request> evaluate_request(Cycle cycle) {
    if (stalls_.blocked(Port::kMemoryRequest, pipeline_, cycle)) return {};
    if (!requests_.empty()) {
      request_sent_ = true;
      return requests_.front();
    }
    if (looked_up_ && looked_up_->answer == Answer::kAllocated) {
      request_sent_ = true;
      return Request{looked_up_->mshr, looked_up_->line, looked_up_->ray};
    }
    return {};
  }

  /// The fill of an MSHR lands in this cycle.
  void land(int mshr) { landing_ = mshr; }

  void commit() {
    ++time_;
    if (looked_up_) commit_lookup(*looked_up_);
    if (request_sent_) requests_.pop_front();
    if (replayed_) {
      Mshr& head = mshrs_[fill_fifo_.front()];
      head.waiters.pop_front();
      if (head.waiters.empty()) {
        head = Mshr{};
        fill_fifo_.pop_front();
      }
    }
    if (landing_) {
      Mshr& mshr = mshrs_[*landing_];
      Way& way = sets_[mshr.line % set_count_][mshr.way];
      evictions_ += way.valid ? 1 : 0;
      way.valid = true;
      way.line = mshr.line;
      mshr.landed = true;
      fill_fifo_.push_back(*landing_);
    }
    looked_up_.reset();
    landing_.reset();
    request_sent_ = replayed_ = retried_ = false;
    mshr_cycles_ += std::count_if(mshrs_.begin(), mshrs_.end(), [](const Mshr& m) { return m.allocated; });
  }

  int64_t mshr_cycles() const { return mshr_cycles_; }  ///< sum over cycles of MSHRs taken at their end
  int64_t evictions() const { return evictions_; }      ///< fills that replaced a line
  int64_t unique_lines() const { return static_cast<int64_t>(lines_requested_.size()); }

 private:
  struct Way {
    bool valid = false;
    bool in_use = false;  ///< valid, or chosen as a victim
    uint64_t line = 0;
    int64_t last_use = 0;
  };
  struct Mshr {
    bool allocated = false;
    bool landed = false;
    uint64_t line = 0;
    int way = 0;
    std::deque<int> waiters;
  };
  struct Lookup {
    int ray;
    uint64_t line;
    Answer answer;
    int mshr;
    int way;
  };

  int free_mshr() const {
    for (size_t m = 0; m < mshrs_.size(); ++m) {
      if (!mshrs_[m].allocated) return static_cast<int>(m);
    }
    return -1;
  }

  static int victim(const std::vector<Way>& set) {
    for (size_t w = 0; w < set.size(); ++w) {
      if (!set[w].in_use) return static_cast<int>(w);
    }
    size_t oldest = 0;
    for (size_t w = 1; w < set.size(); ++w) {
      if (set[w].last_use < set[oldest].last_use) oldest = w;
    }
    return static_cast<int>(oldest);
  }

  void commit_lookup(const Lookup& now) {
    if (retried_) retry_fifo_.pop_front();
    if (now.answer == Answer::kRefused) {
      retry_fifo_.push_back(now.ray);
      return;
    }
    if (now.answer == Answer::kMerged) {
      mshrs_[now.mshr].waiters.push_back(now.ray);
      return;
    }
    Way& way = sets_[now.line % set_count_][now.way];
    way.last_use = time_;
    if (now.answer == Answer::kHit) return;
    way.in_use = true;
    mshrs_[now.mshr] = Mshr{true, false, now.line, now.way, {now.ray}};
    requests_.push_back({now.mshr, now.line, now.ray});
    lines_requested_.insert(now.line);
  }

  int pipeline_;
  const PortStalls& stalls_;
  uint64_t set_count_;
  std::vector<std::vector<Way>> sets_;
  std::vector<Mshr> mshrs_;
  std::deque<int> fill_fifo_;     ///< MSHRs
  std::deque<int> retry_fifo_;    ///< rays
  std::deque<Request> requests_;  ///< allocated, not left
  int64_t time_ = 0;
  int64_t mshr_cycles_ = 0, evictions_ = 0;
  std::set<uint64_t> lines_requested_;

  std::optional<Lookup> looked_up_;
  std::optional<int> landing_;
  bool request_sent_ = false, replayed_ = false, retried_ = false;
};

}  // namespace cuesta::twins
