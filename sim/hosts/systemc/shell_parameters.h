#pragma once

#include <cstdint>

namespace cuesta::systemc {

/// How memory_out speaks to its target.
enum class MemoryProtocol : uint8_t {
  kFourPhase,  ///< nb_transport: BEGIN_REQ, END_REQ, BEGIN_RESP, END_RESP; many transactions at once, one request
               ///< phase at a time
  kBlocking,  ///< b_transport, one call per outstanding request at once: for a target with b_transport alone, which
              ///< behind nb_transport would serve one request after the other
};

/// Who cares for the bytes of the pyramid image.
enum class MemoryBytes : uint8_t {
  kLoadAndCheck,  ///< written by the debug transport before cycle 0; every fill is compared
  kCheck,         ///< the memory holds the image already; every fill is compared
  kIgnore,        ///< the memory has timing only
};

struct ShellParameters {
  uint64_t memory_base = 0;  ///< address of the machine's first byte in the memory's address map
  MemoryProtocol memory_protocol = MemoryProtocol::kFourPhase;
  MemoryBytes memory_bytes = MemoryBytes::kLoadAndCheck;
  uint32_t ray_fifo = 0;  ///< rays in front of ray_dispatch from which on rays_in blocks; 0: never
  uint32_t hit_fifo = 0;  ///< places for records that hits_out has not delivered; 0: 4 x pipelines x window
};

/// Registers of rays_in; offsets.
inline constexpr uint64_t kRayRecords = 0x0000;  ///< write: whole records of 112 bytes, as many as one likes
inline constexpr uint64_t kEndOfRays = 0x1000;   ///< write, 4 bytes of any value: no ray follows
inline constexpr uint64_t kStatus =
    0x1004;  ///< read, 4 bytes: 1 when everything is finished and written, else 0

}  // namespace cuesta::systemc
