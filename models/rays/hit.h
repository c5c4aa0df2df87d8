#pragma once

#include <cstdint>

namespace cuesta {

/// kDidNotFinish: the run was ended early (0 steps), or a search as printed gave up after its most steps. kNotANumber:
/// such a search ended at no place. Both have zeros after `status`, except `steps`, as a miss.
enum class HitStatus : uint8_t { kMiss = 0, kHit = 1, kDidNotFinish = 2, kNotANumber = 3 };

enum class HitFace : uint8_t { kNone = 0, kTop = 1, kWallX = 2, kWallY = 3, kInside = 4 };

/// What the machine writes for a ray. A miss has zeros after `status`, except `steps`.
struct HitRecord {
  uint64_t ray_id = 0;
  HitStatus status = HitStatus::kMiss;
  HitFace face = HitFace::kNone;
  uint8_t stop_level = 0;
  int32_t i = 0;  ///< cell of the stop level in the map's own frame, unwrapped, before the address mode
  int32_t j = 0;
  int64_t t = 0;       ///< machine time units (fixed); the bits of the time (float, double)
  uint32_t steps = 0;  ///< node visits

  bool operator==(const HitRecord&) const = default;
};

/// Bytes of a hit record in memory: 8 + 1 + 1 + 1 + 4 + 4 + 8 + 4 = 31, padded to 32.
inline constexpr int kHitRecordBytes = 32;

}  // namespace cuesta
