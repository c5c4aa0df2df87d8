// A bus master of your own that feeds rays over time and receives the hits.
//
// bus_rays [FILE.rays]: the rays of a file, or of the built-in scene `default`, 16 of them every microsecond.

#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>

#include <cstdio>
#include <systemc>

#include "models/rays/hit_bytes.h"
#include "sim/config/architecture_file.h"
#include "sim/hosts/systemc/dram_target.h"
#include "sim/hosts/systemc/machine_shell.h"
#include "sim/session/job.h"
#include "traces/rays_format.h"

using namespace cuesta;

struct BusMaster : sc_core::sc_module {
  SC_HAS_PROCESS(BusMaster);
  tlm_utils::simple_initiator_socket<BusMaster> rays{"rays"};
  tlm_utils::simple_target_socket<BusMaster> hits{"hits"};
  const std::vector<TracedRay>& trace;
  uint64_t found = 0, records = 0;
  sc_core::sc_time first_hit, last_record;

  BusMaster(const sc_core::sc_module_name& name, const std::vector<TracedRay>& all)
      : sc_core::sc_module(name), trace(all) {
    hits.register_b_transport(this, &BusMaster::take_hit);
    SC_THREAD(feed);
  }

  void feed() {
    std::vector<unsigned char> bytes;
    for (size_t k = 0; k < trace.size(); ++k) {
      bytes.resize(bytes.size() + rays_format::kRecordBytes);
      rays_format::encode_record(trace[k], &bytes[bytes.size() - rays_format::kRecordBytes]);
      if ((k + 1) % 16 != 0 && k + 1 != trace.size()) continue;
      write(systemc::kRayRecords, bytes);  // several whole records in one transaction
      wait(1, sc_core::SC_US);
    }
    bytes.assign(4, 1);
    write(systemc::kEndOfRays, bytes);
  }

  void write(uint64_t address, std::vector<unsigned char>& bytes) {
    tlm::tlm_generic_payload payload;
    payload.set_write();
    payload.set_address(address);
    payload.set_data_ptr(bytes.data());
    payload.set_data_length(static_cast<unsigned>(bytes.size()));
    payload.set_streaming_width(static_cast<unsigned>(bytes.size()));
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    rays->b_transport(payload, delay);
    if (payload.is_response_error()) SC_REPORT_ERROR("bus_rays", payload.get_response_string().c_str());
    bytes.clear();
  }

  void take_hit(tlm::tlm_generic_payload& payload, sc_core::sc_time&) {
    const HitRecord hit = decode_hit(payload.get_data_ptr());
    if (hit.status == HitStatus::kHit && found++ == 0) first_hit = sc_core::sc_time_stamp();
    ++records;
    last_record = sc_core::sc_time_stamp();
    payload.set_response_status(tlm::TLM_OK_RESPONSE);
  }
};

int sc_main(int count, char** arguments) {
  try {
    SceneChanges changes;
    if (count > 1) changes.rays_file = arguments[1];
    if (count == 1) changes.size = {64, 64};
    const Job job = prepare_job("default", changes);
    const ResolvedArchitecture resolved = resolve_architecture("mobile", {}, true);
    systemc::MachineShell machine("machine");
    systemc::DramTarget dram("dram");  // the machine's own
    BusMaster master("master", job.trace.rays);
    master.rays.bind(machine.rays_in);
    machine.hits_out.bind(master.hits);
    machine.memory_out.bind(dram.socket);

    const Architecture& architecture = resolved.architecture;
    machine.load({&job.pyramid, job.map, find_algorithm("yun2013")->schedule, job.trace.width,
                  job.trace.height, &architecture});
    dram.load(architecture, machine.clock());
    sc_core::sc_start();
    const int64_t cycles = machine.outcome().measurements.counters.get("machine.cycles");
    std::printf(
        "%zu rays, %llu records, %llu hits; the first hit at %s, the last record at %s; %lld cycles\n",
        job.trace.rays.size(), static_cast<unsigned long long>(master.records),
        static_cast<unsigned long long>(master.found), master.first_hit.to_string().c_str(),
        master.last_record.to_string().c_str(), static_cast<long long>(cycles));
    return 0;
  } catch (const Error& error) {
    std::fprintf(stderr, "bus_rays: %s\n", error.what());
    return static_cast<int>(error.code());
  }
}
