#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/units/height_l1/height_l1.h"
#include "models/units/hmt/hmt_site.h"
#include "models/units/hmt/hmt_unit.h"
#include "models/units/ray_setup/ray_setup_unit.h"
#include "models/units/traverse/traverse_unit.h"

namespace cuesta {

/// The model's own units; `Traverse`: TraverseUnit, or RunAheadTraverse, which is loosely timed.
template <class Traverse>
class HmtModel final : public HmtUnit {
 public:
  explicit HmtModel(const HmtSite& site)
      : l1_(site.architecture.height_l1, site.architecture.traverse.contexts, site.image_bytes, site.pipeline,
            site.memory, site.stalls),
        setup_(site.architecture.ray_setup, site.architecture.ray_dispatch, site.pipeline, site.dispatch,
               site.stalls),
        traverse_(site, setup_, l1_) {
    l1_.log_ports(site.log);
    setup_.log_ports(site.log);
  }

  void advance(Cycle limit) override { traverse_.advance(limit); }
  Cycle cycle() const override { return traverse_.cycle(); }
  bool finished() const override { return traverse_.finished(); }
  bool starved() const override { return traverse_.starved(); }
  void drain_until(Cycle end) override { traverse_.drain_until(end); }
  void hold_hits_until(Cycle cycle) override { traverse_.hold_hits_until(cycle); }
  void log_completions(std::vector<uint32_t>* rays) override { traverse_.log_completions(rays); }
  int64_t completed() const override { return traverse_.counts().rays; }
  Counts counts(Cycle end) override {
    return {setup_.counts(), traverse_.counts_until(end), l1_.counts_until(end)};
  }
  Fill fill() const override {
    return {static_cast<int>(setup_.queued() + setup_.waiting()), traverse_.resident(), l1_.mshrs_taken(),
            static_cast<int>(l1_.retry_fill())};
  }
  std::string who_waits() const override { return traverse_.who_waits(); }

 private:
  HeightL1 l1_;
  RaySetupUnit setup_;
  Traverse traverse_;
};

}  // namespace cuesta
