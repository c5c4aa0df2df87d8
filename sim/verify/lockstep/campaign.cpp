#include "sim/verify/lockstep/campaign.h"

#include <chrono>
#include <utility>

#include "sim/session/parallel.h"
#include "sim/verify/lockstep/random_rtl_case.h"

namespace cuesta {
namespace {

constexpr int kMostRays = 400;  ///< of a random machine
constexpr const char* kLabel = "verify rtl";

}  // namespace

void LockstepReport::add(const LockstepCase& one, LockstepResult result) {
  ++machines;
  rays += result.rays;
  cycles += static_cast<uint64_t>(result.cycles);
  requests += result.requests;
  if (result.equal() && !result.stuck) return;
  failing = one;
  last = std::move(result);
}

LockstepReport compare_case(const LockstepCase& one, const std::array<LockstepSide, 2>& sides,
                            Observer& observer) {
  LockstepReport report;
  Stage stage(observer, kLabel, "rays", one.rays.size());
  LockstepResult result = run_lockstep(one, sides[0], sides[1], LockstepDepth::kFirstCycle,
                                       [&](uint64_t rays) { return stage.update(rays); });
  report.stopped = result.stopped;
  report.add(one, std::move(result));
  return report;
}

LockstepReport run_campaign(const LockstepCampaign& campaign, const std::array<LockstepSide, 2>& sides,
                            Observer& observer) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::seconds(campaign.seconds);
  LockstepReport report;
  Stage stage(observer, kLabel, "rays", campaign.ray_count.value_or(0));
  uint64_t number = 0;
  const auto next = [&] {
    return std::optional([&, drawn = number++] {
      const rtl::RtlParameters& parameters = campaign.sets[drawn % campaign.sets.size()].parameters;
      LockstepCase one =
          random_rtl_case(structure_of(parameters, campaign.unit), campaign.seed + drawn, kMostRays);
      LockstepResult result = run_lockstep(one, sides[0], sides[1]);
      return std::pair(std::move(one), std::move(result));
    });
  };
  const auto take = [&](std::pair<LockstepCase, LockstepResult> compared) {
    report.add(compared.first, std::move(compared.second));
    return !report.failing;
  };
  ordered_groups(campaign.workers, next, take, [&] {
    if (number > 0) report.stopped = !stage.update(report.rays);
    const bool over = campaign.ray_count ? report.rays >= *campaign.ray_count : Clock::now() >= end;
    return !report.stopped && !over;
  });
  return report;
}

}  // namespace cuesta
