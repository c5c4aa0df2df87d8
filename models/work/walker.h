#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "models/rays/hit.h"
#include "models/traversal/fetch.h"
#include "models/traversal/step_lines.h"
#include "models/work/workload.h"

namespace cuesta {

/// Some of a workload's rays: ray k is rays[order[k]], or rays[k] where `order` is empty.
struct RayBatch {
  std::span<const MachineRay> rays;
  std::span<const uint32_t> order;

  size_t size() const { return order.empty() ? rays.size() : order.size(); }
  const MachineRay& operator[](size_t k) const { return rays[order.empty() ? k : order[k]]; }
};

/// Walks rays by a workload's algorithm, on its kind of surface: what the functional run and the units in time both get
/// their values from. One class for each kind: texels, patches, and the approximate searches.
class Walker {
 public:
  virtual ~Walker() = default;
  Walker() = default;
  Walker(const Walker&) = delete;
  Walker& operator=(const Walker&) = delete;

  /// Says whether `walk` fills `fetches`; if not, every step of every ray reads one texel.
  virtual bool counts_fetches() const = 0;
  /// Fills a record for each ray of the batch, and where `counts_fetches` what it has read: both as long as the batch.
  /// `recorder`, if not nullptr, gets the lines of memory.
  virtual void walk(const RayBatch& batch, std::span<HitRecord> hits, std::span<FetchCounts> fetches,
                    const LineRecorder* recorder) const = 0;
};

/// Makes the walker of a workload's surface and algorithm; what the workload points to must outlive it, its rays are
/// not looked at.
std::unique_ptr<Walker> make_walker(const Workload& work);

// The kinds that make_walker chooses among.
std::unique_ptr<Walker> make_texel_walker(const Workload& work);
std::unique_ptr<Walker> make_patch_walker(const Workload& work);
std::unique_ptr<Walker> make_search_walker(const Workload& work);

/// Calls walk(k) for each ray of a batch; with a recorder it writes down where the lines that the call appended lie.
template <class Walk>
void for_each_ray(size_t rays, const LineRecorder* recorder, Walk&& walk) {
  for (size_t k = 0; k < rays; ++k) {
    const uint64_t first = recorder == nullptr ? 0 : recorder->lines->size();
    walk(k);
    if (recorder != nullptr) recorder->spans[k] = {first, recorder->lines->size() - first};
  }
}

}  // namespace cuesta
