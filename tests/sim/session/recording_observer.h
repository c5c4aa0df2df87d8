#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim/session/progress.h"

namespace cuesta {

/// Keeps what it hears, and wants the work to end once a stage of that name has begun.
class RecordingObserver : public Observer {
 public:
  explicit RecordingObserver(std::string stop_at = "") : stop_at_(std::move(stop_at)) {}

  void on_begin(const std::string& label, const std::string& unit, uint64_t all) override {
    stages.push_back(label + " [" + unit + " " + std::to_string(all) + "]");
    ++open;
    stop_ = stop_ || label == stop_at_;
  }
  void on_progress(uint64_t finished) override { last_finished = finished; }
  void on_end() override { --open; }
  void on_remark(const std::string& sentence) override { remarks.push_back(sentence); }
  bool wants_stop() override { return stop_; }

  std::vector<std::string> stages, remarks;
  uint64_t last_finished = 0;
  int open = 0;  ///< stages that have begun and not ended

 private:
  std::string stop_at_;
  bool stop_ = false;
};

}  // namespace cuesta
