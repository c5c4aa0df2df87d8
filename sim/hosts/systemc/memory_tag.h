#pragma once

#include <cstdint>
#include <tlm>

namespace cuesta::systemc {

/// Rides on every payload of memory_out; a memory may ignore it. (pipeline, write, slot) is the identity of a
/// transaction: no two with the same are outstanding.
struct MemoryTag : tlm::tlm_extension<MemoryTag> {
  int pipeline = 0;
  bool write = false;
  int slot = 0;         ///< read: number of the MSHR; write: place among the outstanding bursts
  uint64_t number = 0;  ///< of the request, from 0

  /// What a memory that counts them may leave here before its response.
  int bus_clocks = 0;
  int row_activations = 0;

  tlm::tlm_extension_base* clone() const override { return new MemoryTag(*this); }
  void copy_from(const tlm::tlm_extension_base& other) override {
    *this = static_cast<const MemoryTag&>(other);
  }
};

}  // namespace cuesta::systemc
