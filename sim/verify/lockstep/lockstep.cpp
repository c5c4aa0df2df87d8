#include "sim/verify/lockstep/lockstep.h"

#include <algorithm>
#include <memory>

#include "sim/verify/lockstep/comparison.h"
#include "sim/verify/lockstep/rig.h"

namespace cuesta {
namespace {

constexpr Cycle kBlock = 4096;      ///< cycles between two comparisons
constexpr Cycle kShortBlock = 512;  ///< of the small cases that a shrinker tries

/// Both sides from reset on. What they have in common of the value is made once.
class Pair {
 public:
  Pair(const LockstepCase& one, const LockstepSide& left, const LockstepSide& right, Cycle step) {
    std::shared_ptr<const LockstepWork> work;
    auto make = [&](const LockstepSide& side) {
      LockstepMachine machine = one.machine;
      if (side.change) side.change(machine);
      if (work == nullptr || !work->serves(one, machine)) work = std::make_shared<LockstepWork>(one, machine);
      auto rig = std::make_unique<LockstepRig>(one, machine, work);
      rig->step_by(step);
      return rig;
    };
    left_ = make(left);
    right_ = make(right);
    comparison_.emplace(*left_, *right_);
  }

  /// From here on; everything up to here has been compared.
  void cycle_by_cycle() {
    left_->step_by(1);
    right_->step_by(1);
    comparison_->cycle_by_cycle();
  }
  std::vector<Difference> advance(Cycle end) {
    left_->advance(end);
    right_->advance(end);
    return comparison_->until(end);
  }
  std::vector<Difference> at_the_end(Cycle end) { return comparison_->at_the_end(end); }
  bool done() const { return left_->done() && right_->done(); }
  /// Both have given up, where they are equal; nullopt: they go on.
  const std::optional<Error>& stuck() const { return left_->stuck(); }
  uint64_t rays() const { return std::min(left_->machine().completed(), right_->machine().completed()); }
  Cycle cycles() const { return left_->machine().cycles(); }
  uint64_t requests() const { return comparison_->requests(); }

 private:
  std::unique_ptr<LockstepRig> left_, right_;
  std::optional<Comparison> comparison_;
};

/// The differences of the first cycle that has some; it is one of [from, to).
std::vector<Difference> first_differences(const LockstepCase& one, const LockstepSide& left,
                                          const LockstepSide& right, Cycle from, Cycle to) {
  Pair pair(one, left, right, kBlock);
  for (Cycle end = kBlock; end <= from; end += kBlock) pair.advance(end);
  pair.cycle_by_cycle();
  for (Cycle end = from + 1; end <= to; ++end) {
    std::vector<Difference> found = pair.advance(end);
    if (!found.empty()) return found;
  }
  return {};
}

}  // namespace

LockstepResult run_lockstep(const LockstepCase& one, const LockstepSide& left, const LockstepSide& right,
                            LockstepDepth depth, const LockstepWatch& watch) {
  const Cycle block = depth == LockstepDepth::kWhether ? kShortBlock : kBlock;
  Pair pair(one, left, right, block);
  LockstepResult result;
  Cycle end = 0;
  while (!pair.done() && !pair.stuck() && !result.stopped && result.equal()) {
    end += block;
    result.differences = pair.advance(end);
    result.stopped = watch && !watch(pair.rays());
  }
  if (!result.equal() && depth == LockstepDepth::kFirstCycle) {
    std::vector<Difference> first = first_differences(one, left, right, end - block, end);
    if (!first.empty()) result.differences = std::move(first);
  }
  if (result.equal()) result.stuck = pair.stuck();
  if (result.equal() && !result.stuck && !result.stopped) result.differences = pair.at_the_end(end);
  result.rays = pair.rays();
  result.requests = pair.requests();
  result.cycles = pair.done() ? pair.cycles() : end;
  return result;
}

}  // namespace cuesta
