#pragma once

#include <bit>
#include <vector>

#include "models/heightmap/texel_layout.h"
#include "models/traversal/traversal.h"
#include "models/work/step_source.h"
#include "models/work/workload.h"

namespace cuesta {

/// A source of steps that walks a workload's rays in the machine's order: what texels and patches have in common. The
/// references must outlive it.
template <class A, class G>
class WalkSource : public StepSource {
 public:
  WalkSource(const Workload& work, const Architecture& architecture, const TexelLayout& layout,
             const std::vector<uint32_t>& order)
      : StepSource(static_cast<uint32_t>(order.size())),
        work_(work),
        layout_(layout),
        order_(order),
        line_shift_(std::countr_zero(static_cast<unsigned>(architecture.height_l1.line_bytes))),
        walk_(work.map, number_format(architecture.traverse, work.map), work.schedule,
              work.pyramid->highest()) {}

 protected:
  const MachineRay& ray_at(const StepSource::Batch& batch, size_t k) const {
    return work_.rays[order_[batch.first_ray + k]];
  }

  const Workload& work_;
  const TexelLayout& layout_;
  const std::vector<uint32_t>& order_;
  int line_shift_;
  Walk<A, G> walk_;
};

}  // namespace cuesta
