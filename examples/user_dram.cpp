// A DRAM model of your own on the machine's memory socket.
//
// All it takes is a target socket with b_transport, which says how long an access takes, and transport_dbg, through
// which the machine loads the heights before its first cycle. Here: one open row, 20 ns for it, 50 ns for another.

#include <tlm_utils/simple_target_socket.h>

#include <cstdio>
#include <cstring>
#include <systemc>

#include "sim/config/architecture_file.h"
#include "sim/hosts/systemc/machine_shell.h"
#include "sim/hosts/systemc/ray_feeder.h"
#include "sim/session/job.h"

using namespace cuesta;

struct UserDram : sc_core::sc_module {
  tlm_utils::simple_target_socket<UserDram> socket{"socket"};
  std::vector<unsigned char> bytes = std::vector<unsigned char>(1 << 20);
  uint64_t open_row = 0, reads = 0, writes = 0, row_hits = 0;

  explicit UserDram(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {
    socket.register_b_transport(this, &UserDram::b_transport);
    socket.register_transport_dbg(this, &UserDram::transport_dbg);
  }

  void b_transport(tlm::tlm_generic_payload& access, sc_core::sc_time& delay) {
    if (transport_dbg(access) == 0) return access.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
    const uint64_t row = access.get_address() / 2048;
    delay += sc_core::sc_time(row == open_row ? 20 : 50, sc_core::SC_NS);
    row_hits += row == open_row;
    open_row = row;
    (access.is_read() ? reads : writes) += 1;
    access.set_response_status(tlm::TLM_OK_RESPONSE);
  }

  unsigned transport_dbg(tlm::tlm_generic_payload& access) {
    const uint64_t address = access.get_address();
    const unsigned count = access.get_data_length();
    if (address + count > bytes.size()) return 0;
    if (access.is_read()) std::memcpy(access.get_data_ptr(), &bytes[address], count);
    if (access.is_write()) std::memcpy(&bytes[address], access.get_data_ptr(), count);
    return count;
  }
};

int run() {
  // A built-in scene, small, and a preset machine that traces its rays with one of the algorithms.
  SceneChanges changes;
  changes.size = {64, 64};
  const Job job = prepare_job("default", changes);
  const ResolvedArchitecture resolved = resolve_architecture("mobile", {}, true);
  const Architecture& architecture = resolved.architecture;

  systemc::ShellParameters parameters;
  parameters.memory_protocol = systemc::MemoryProtocol::kBlocking;  // b_transport, many accesses at once
  systemc::MachineShell machine("machine", parameters);
  systemc::RayFeeder rays("rays");
  UserDram dram("dram");
  rays.socket.bind(machine.rays_in);
  machine.memory_out.bind(dram.socket);

  machine.load({&job.pyramid, job.map, find_algorithm("yun2013")->schedule, job.trace.width, job.trace.height,
                &architecture});
  rays.feed(job.trace.rays);
  sc_core::sc_start();

  const Outcome outcome = machine.outcome();
  const Counters& counters = outcome.measurements.counters;
  std::printf("dram:    %llu reads, %llu writes, %llu in the open row\n",
              static_cast<unsigned long long>(dram.reads), static_cast<unsigned long long>(dram.writes),
              static_cast<unsigned long long>(dram.row_hits));
  for (const char* path : {"machine.rays", "machine.hits", "machine.steps", "machine.cycles",
                           "traverse[0].bubble_contexts_full", "height_l1[0].misses", "dram.read_bytes"}) {
    std::printf("machine: %s = %lld\n", path, static_cast<long long>(counters.get(path)));
  }
  return 0;
}

int sc_main(int, char**) {
  try {
    return run();
  } catch (const Error& error) {
    std::fprintf(stderr, "user_dram: %s\n", error.what());
    return static_cast<int>(error.code());
  }
}
