#pragma once

#include <cstdint>
#include <span>

#include "models/rays/machine_ray.h"
#include "models/units/ports/port_stalls.h"

namespace cuesta {

/// The side of a machine to which rays come. Rays are numbered as they come; their number in the machine's order is
/// that.
class RayIntake {
 public:
  /// Takes a whole trace, there at reset, before any other ray; the machine brings it into the order that its
  /// ray_dispatch wants. `pixels`: y * width + x, as long as rays. Both must outlive the machine.
  virtual void trace_arrives(std::span<const MachineRay> rays, std::span<const uint32_t> pixels) = 0;
  /// Takes one more ray, there from `cycle` on; cycles do not go down. `pixel`: inside the frame.
  virtual void ray_arrives(const MachineRay& ray, uint32_t pixel, Cycle cycle) = 0;
  /// Learns in `cycle` that no ray follows.
  virtual void end_of_rays(Cycle cycle) = 0;

 protected:
  ~RayIntake() = default;
};

/// The contract of where a machine's rays come from: a trace, a host, or hits that ask for rays of their own.
class RaySource {
 public:
  RaySource() = default;
  virtual ~RaySource() = default;
  RaySource(const RaySource&) = delete;
  RaySource& operator=(const RaySource&) = delete;

  /// Tells `machine` every ray and the end, as far as their cycles are below `limit` and it was not told before. Called
  /// before the machine goes on to `limit`; limits do not go down.
  virtual void bring_until(Cycle limit, RayIntake& machine) = 0;
};

/// Rays that are all there at reset.
class TraceRays final : public RaySource {
 public:
  TraceRays(std::span<const MachineRay> rays, std::span<const uint32_t> pixels)
      : rays_(rays), pixels_(pixels) {}

  void bring_until(Cycle, RayIntake& machine) override {
    if (brought_) return;
    brought_ = true;
    machine.trace_arrives(rays_, pixels_);
  }

 private:
  std::span<const MachineRay> rays_;
  std::span<const uint32_t> pixels_;
  bool brought_ = false;
};

}  // namespace cuesta
