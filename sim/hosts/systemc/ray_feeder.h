#pragma once

#include <tlm_utils/simple_initiator_socket.h>
#include <systemc>
#include <tlm>
#include <vector>

#include "models/rays/traced_ray.h"

namespace cuesta::systemc {

/// A bus initiator that writes a trace's rays into rays_in, as many as there are in one transaction after the other
/// without time between them, and then the end of the trace.
class RayFeeder : public sc_core::sc_module {
 public:
  SC_HAS_PROCESS(RayFeeder);
  tlm_utils::simple_initiator_socket<RayFeeder> socket{"socket"};

  explicit RayFeeder(const sc_core::sc_module_name& name);
  /// Starts to write `rays`, now.
  void feed(std::vector<TracedRay> rays);

 private:
  void run();
  /// Writes at an offset of rays_in. Reports an error when the target refuses.
  void write(uint64_t address, std::vector<uint8_t>& bytes);

  std::vector<TracedRay> rays_;
  bool waiting_ = false;  ///< rays_ is there to be written
  sc_core::sc_event start_;
};

}  // namespace cuesta::systemc
