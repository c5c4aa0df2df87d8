#pragma once

#include <string>
#include <vector>

#include "sim/verify/lockstep/difference.h"
#include "sim/verify/lockstep/rig.h"

namespace cuesta {

/// Holds two rigs that stand in the same cycle against each other.
class Comparison {
 public:
  Comparison(LockstepRig& left, LockstepRig& right);

  /// From now on the rigs go on cycle by cycle. Until then the queue in front of ray_setup is left out: a machine
  /// fills it when it looks at it.
  void cycle_by_cycle() { by_cycle_ = true; }

  /// Everything that differs up to `end`, the cycle at which both rigs stand: ports since the last call, counters
  /// and fills as they are now. Sorted by cause. Once something differs the comparison is over.
  std::vector<Difference> until(Cycle end);
  /// The same when both are done: also what is only known at the end.
  std::vector<Difference> at_the_end(Cycle end);

  uint64_t requests() const { return requests_; }

 private:
  static constexpr uint32_t kNoRay = ~0u;

  /// Up to where the logs of a pipeline's ports were compared.
  struct Place {
    size_t entries = 0, requests = 0, hits = 0;
  };

  void compare_entries(size_t pipeline, Cycle end);
  void compare_requests(size_t pipeline, Cycle end);
  void compare_hits(size_t pipeline, Cycle end);
  void compare_fills(int pipeline, Cycle end);
  void compare_counters(bool whole, Cycle end);
  void compare_timing(Cycle end);
  void compare(const std::string& path, Cycle cycle, int64_t left, int64_t right);
  void add(const std::string& path, Cycle cycle, const std::string& left, const std::string& right,
           uint32_t ray = kNoRay);
  std::vector<Difference> found();

  std::string ray_text(uint32_t ray) const;
  std::string address_text(uint64_t address) const;
  std::string request_text(const PortLog::Request& request) const;
  static std::string hit_text(const PortLog::Hit& hit);

  LockstepRig& left_;
  LockstepRig& right_;
  bool by_cycle_ = false;
  std::vector<Place> places_;
  uint64_t requests_ = 0;
  std::vector<Difference> differences_;
};

}  // namespace cuesta
