#pragma once

#include <string>
#include <vector>

#include "models/common/random.h"
#include "models/rays/hit_bytes.h"
#include "models/work/outcome.h"
#include "sim/config/architecture_file.h"
#include "sim/config/on_architecture.h"
#include "sim/hosts/systemc/dram_target.h"
#include "sim/hosts/systemc/machine_shell.h"
#include "sim/hosts/systemc/ray_feeder.h"
#include "sim/session/job.h"
#include "traces/rays_format.h"

namespace cuesta::systemc {

/// A small scene on a machine, and what the direct host makes of it.
struct ShellRig {
  Job job;
  ResolvedArchitecture resolved;
  std::vector<MachineRay> rays;

  ShellRig(const std::string& scene, int size, const std::string& preset, std::vector<std::string> settings) {
    SceneChanges changes;
    changes.size = {size, size};
    job = prepare_job(scene, changes);
    settings.emplace_back("ray_dispatch.order=scanline");
    resolved = resolve_architecture(preset, settings, true);
    for (const TracedRay& ray : job.trace.rays) {
      rays.push_back(quantise(ray, job.map, number_format(architecture().traverse, job.map)));
    }
  }

  const Architecture& architecture() const { return resolved.architecture; }
  MachineSetup setup() const {
    return {&job.pyramid,    job.map,          find_algorithm("yun2013")->schedule,
            job.trace.width, job.trace.height, &architecture()};
  }
  Workload work() const { return workload_of(job, architecture(), rays, *find_algorithm("yun2013")); }
  Outcome direct() const { return run_cycle(work(), architecture()); }
  std::vector<std::string> laws_broken_by(const Outcome& outcome) const {
    return broken_laws(work(), architecture(), Fidelity::kCycle, outcome);
  }
};

/// Takes hit records, as slowly as one likes.
struct HitSink : sc_core::sc_module {
  tlm_utils::simple_target_socket<HitSink> socket{"socket"};
  std::vector<HitRecord> hits;
  std::vector<sc_core::sc_time> times;
  sc_core::sc_time each = sc_core::SC_ZERO_TIME;

  explicit HitSink(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {
    socket.register_b_transport(this, &HitSink::take);
  }
  void take(tlm::tlm_generic_payload& payload, sc_core::sc_time&) {
    times.push_back(sc_core::sc_time_stamp());
    if (payload.get_address() == 32 * hits.size() && payload.get_data_length() == 32) {
      hits.push_back(decode_hit(payload.get_data_ptr()));
      payload.set_response_status(tlm::TLM_OK_RESPONSE);
    }
    if (each != sc_core::SC_ZERO_TIME) wait(each);
  }
};

/// Writes rays a few at a time, with pauses.
struct LateRays : sc_core::sc_module {
  SC_HAS_PROCESS(LateRays);
  tlm_utils::simple_initiator_socket<LateRays> socket{"socket"};
  const std::vector<TracedRay>& rays;
  Random random;
  bool ends = true;

  LateRays(const sc_core::sc_module_name& name, const std::vector<TracedRay>& all, uint64_t seed)
      : sc_core::sc_module(name), rays(all), random(seed) {
    SC_THREAD(run);
  }
  tlm::tlm_response_status write(uint64_t address, std::vector<uint8_t> bytes) {
    tlm::tlm_generic_payload payload;
    payload.set_write();
    payload.set_address(address);
    payload.set_data_ptr(bytes.data());
    payload.set_data_length(static_cast<unsigned>(bytes.size()));
    payload.set_streaming_width(static_cast<unsigned>(bytes.size()));
    sc_core::sc_time delay(static_cast<double>(random.below(50)), sc_core::SC_NS);
    socket->b_transport(payload, delay);
    wait(delay);
    return payload.get_response_status();
  }
  void run() {
    for (size_t k = 0; k < rays.size();) {
      std::vector<uint8_t> bytes;
      for (uint64_t n = 1 + random.below(7); n > 0 && k < rays.size(); --n, ++k) {
        bytes.resize(bytes.size() + rays_format::kRecordBytes);
        rays_format::encode_record(rays[k], &bytes[bytes.size() - rays_format::kRecordBytes]);
      }
      write(kRayRecords, bytes);
      if (random.chance(0.3)) wait(static_cast<double>(random.below(3000)), sc_core::SC_NS);
    }
    wait(random.chance(0.5) ? 20000 : 1, sc_core::SC_NS);
    if (ends) write(kEndOfRays, std::vector<uint8_t>(4));
  }
};

}  // namespace cuesta::systemc
