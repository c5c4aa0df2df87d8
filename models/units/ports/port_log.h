#pragma once

#include <cstdint>
#include <vector>

#include "models/rays/hit.h"
#include "models/units/ports/port_stalls.h"

namespace cuesta {

/// What passed the ports of one pipeline's ray_setup, traverse and height_l1, each port in the order of its cycles:
/// what two versions of them are compared by. Rays are positions in the machine's order. A unit may log a transfer
/// ahead of time: entries of cycles that are still to come are certain, but not complete.
struct PortLog {
  /// A ray enters ray_setup.
  struct Entry {
    Cycle cycle;
    uint32_t ray;
    bool operator==(const Entry&) const = default;
  };
  /// A read request leaves height_l1.
  struct Request {
    Cycle cycle;
    int32_t mshr;
    uint64_t address;  ///< bytes, of the line
    uint32_t owner;    ///< the ray whose miss it is
    bool operator==(const Request&) const = default;
  };
  /// A record passes the hit stream.
  struct Hit {
    Cycle cycle;
    uint32_t ray;
    HitRecord record;
    bool operator==(const Hit&) const = default;
  };

  std::vector<Entry> entries;
  std::vector<Request> requests;
  std::vector<Hit> hits;
};

}  // namespace cuesta
