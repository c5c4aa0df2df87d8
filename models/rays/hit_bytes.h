#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include "models/rays/hit.h"

namespace cuesta {

static_assert(std::endian::native == std::endian::little, "hit records are copied as they are");

/// A hit record as it lies in memory, little-endian, 32 bytes: ray id at 0 (8 bytes), status 8, face 9, stop level
/// 10, a zero 11, i 12 (4), j 16 (4), t 20 (8), steps 28 (4).
inline void encode_hit(const HitRecord& hit, uint8_t* bytes) {
  std::memcpy(bytes, &hit.ray_id, 8);
  bytes[8] = static_cast<uint8_t>(hit.status);
  bytes[9] = static_cast<uint8_t>(hit.face);
  bytes[10] = hit.stop_level;
  bytes[11] = 0;
  std::memcpy(bytes + 12, &hit.i, 4);
  std::memcpy(bytes + 16, &hit.j, 4);
  std::memcpy(bytes + 20, &hit.t, 8);
  std::memcpy(bytes + 28, &hit.steps, 4);
}

inline HitRecord decode_hit(const uint8_t* bytes) {
  HitRecord hit;
  std::memcpy(&hit.ray_id, bytes, 8);
  hit.status = static_cast<HitStatus>(bytes[8]);
  hit.face = static_cast<HitFace>(bytes[9]);
  hit.stop_level = bytes[10];
  std::memcpy(&hit.i, bytes + 12, 4);
  std::memcpy(&hit.j, bytes + 16, 4);
  std::memcpy(&hit.t, bytes + 20, 8);
  std::memcpy(&hit.steps, bytes + 28, 4);
  return hit;
}

}  // namespace cuesta
