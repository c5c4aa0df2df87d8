#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "models/common/error.h"
#include "tests/sim/hosts/systemc/base_protocol_checker.h"
#include "tests/sim/hosts/systemc/random_memory.h"
#include "tests/sim/hosts/systemc/shell_rig.h"

// One simulation a process: each test is started in a process of its own.

namespace cuesta::systemc {
namespace {

/// Per ray: what no timing may change.
std::string hits_of(const std::vector<HitRecord>& hits) {
  Digest digest;
  for (const HitRecord& hit : hits) {
    add_answer(digest, hit);
    digest.u32(hit.steps);
  }
  return digest.hex();
}

void expect_sound(const ShellRig& rig, const Outcome& outcome) {
  EXPECT_EQ(hits_of(outcome.hits), hits_of(rig.direct().hits));
  for (const std::string& law : rig.laws_broken_by(outcome)) ADD_FAILURE() << law;
}

void expect_fault(MachineShell& machine, ExitCode code, const std::string& part) {
  try {
    machine.outcome();
    ADD_FAILURE() << "no fault, where one is expected: " << part;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(MachineShell, IsTheDirectHostToTheCycleWithItsOwnDram) {
  ShellRig rig("grazing", 24, "desktop", {});
  MachineShell machine("machine");
  RayFeeder feeder("feeder");
  DramTarget dram("dram");
  HitSink sink("sink");
  BaseProtocolChecker checker("checker");
  feeder.socket.bind(machine.rays_in);
  machine.memory_out.bind(checker.from);
  checker.to.bind(dram.socket);
  machine.hits_out.bind(sink.socket);
  machine.load(rig.setup());
  dram.load(rig.architecture(), machine.clock());
  feeder.feed(rig.job.trace.rays);
  sc_core::sc_start();

  std::vector<uint32_t> position(rig.rays.size());
  for (size_t k = 0; k < position.size(); ++k) position[k] = static_cast<uint32_t>(k);
  CycleDetail detail;
  const Outcome direct = run_cycle_detailed(rig.work(), rig.architecture(), {}, {}, &detail);
  const Outcome outcome = machine.outcome(rig.work(), position, &dram.counts());
  EXPECT_EQ(outcome.digest, direct.digest);
  EXPECT_EQ(checker.faults, std::vector<std::string>{});
  EXPECT_EQ(checker.begun, checker.ended);
  EXPECT_EQ(static_cast<int64_t>(checker.begun), outcome.measurements.counters.get("dram.reads") +
                                                     outcome.measurements.counters.get("dram.writes"));

  // Records come at their times: a window after each ray's completion in the direct host.
  std::vector<Cycle> completions;
  for (const RayTiming& ray : detail.timing) completions.push_back(ray.completed);
  std::sort(completions.begin(), completions.end());
  ASSERT_EQ(sink.hits.size(), completions.size());
  const int window =
      rig.architecture().dram.request_latency_cycles + rig.architecture().dram.response_latency_cycles;
  for (size_t k = 0; k < completions.size(); ++k) {
    ASSERT_EQ(sink.times[k], machine.clock().time_of(completions[k] + window)) << k;
  }
  std::vector<HitRecord> by_id = sink.hits;
  std::sort(by_id.begin(), by_id.end(), [](const auto& a, const auto& b) { return a.ray_id < b.ray_id; });
  EXPECT_EQ(hits_of(by_id), hits_of(direct.hits));
}

TEST(MachineShell, IsTheDirectHostToTheCycleByBTransport) {
  ShellRig rig("grazing", 24, "desktop", {});
  ShellParameters parameters;
  parameters.memory_protocol = MemoryProtocol::kBlocking;
  MachineShell machine("machine", parameters);
  RayFeeder feeder("feeder");
  DramTarget dram("dram");
  feeder.socket.bind(machine.rays_in);
  machine.memory_out.bind(dram.socket);
  machine.load(rig.setup());
  dram.load(rig.architecture(), machine.clock());
  feeder.feed(rig.job.trace.rays);
  sc_core::sc_start();
  std::vector<uint32_t> position(rig.rays.size());
  for (size_t k = 0; k < position.size(); ++k) position[k] = static_cast<uint32_t>(k);
  EXPECT_EQ(machine.outcome(rig.work(), position, &dram.counts()).digest, rig.direct().digest);
}

/// A machine on a memory of random behaviour.
void run_on_random_memory(uint64_t seed, const std::string& preset, int most_delay_ns,
                          const std::vector<std::string>& settings) {
  ShellRig rig("default", 20, preset, settings);
  MachineShell machine("machine");
  RayFeeder feeder("feeder");
  RandomMemory memory("memory", seed, most_delay_ns);
  BaseProtocolChecker checker("checker");
  feeder.socket.bind(machine.rays_in);
  machine.memory_out.bind(checker.from);
  checker.to.bind(memory.socket);
  machine.load(rig.setup());
  feeder.feed(rig.job.trace.rays);
  sc_core::sc_start();
  expect_sound(rig, machine.outcome());
  EXPECT_EQ(checker.faults, std::vector<std::string>{});
  EXPECT_EQ(checker.begun, checker.ended);
  EXPECT_GT(checker.most_in_flight, 1u);
}

TEST(MachineShell, KeepsTheBaseProtocolOnASlowRandomMemory) { run_on_random_memory(1, "mobile", 300, {}); }
TEST(MachineShell, KeepsTheBaseProtocolOnAFastRandomMemory) {
  run_on_random_memory(2, "desktop", 2, {"machine.pipelines=4"});
}
TEST(MachineShell, KeepsTheBaseProtocolOnAMemoryThatAcceptsLate) {
  run_on_random_memory(3, "tiny", 40, {"machine.pipelines=6", "height_l1.mshrs=8", "machine.clock_mhz=333"});
}

TEST(MachineShell, TakesRaysThatComeLate) {
  ShellRig rig("default", 20, "mobile", {"machine.pipelines=2"});
  ShellParameters parameters;
  parameters.ray_fifo = 5;
  MachineShell machine("machine", parameters);
  LateRays feeder("feeder", rig.job.trace.rays, 11);
  RandomMemory memory("memory", 11, 60);
  HitSink sink("sink");
  feeder.socket.bind(machine.rays_in);
  machine.memory_out.bind(memory.socket);
  machine.hits_out.bind(sink.socket);
  machine.load(rig.setup());
  sc_core::sc_start();
  EXPECT_EQ(sink.hits.size(), rig.rays.size());
  expect_sound(rig, machine.outcome());
}

TEST(MachineShell, ASlowSinkHoldsTheMachineBack) {
  ShellRig rig("default", 20, "mobile",
               {"machine.pipelines=2", "dram.request_latency_cycles=2", "dram.response_latency_cycles=2"});
  ShellParameters parameters;
  parameters.hit_fifo = 8;
  MachineShell machine("machine", parameters);
  RayFeeder feeder("feeder");
  DramTarget dram("dram");
  HitSink sink("sink");
  sink.each = sc_core::sc_time(1, sc_core::SC_US);
  feeder.socket.bind(machine.rays_in);
  machine.memory_out.bind(dram.socket);
  machine.hits_out.bind(sink.socket);
  machine.load(rig.setup());
  dram.load(rig.architecture(), machine.clock());
  feeder.feed(rig.job.trace.rays);
  sc_core::sc_start();
  const Outcome outcome = machine.outcome();
  expect_sound(rig, outcome);
  EXPECT_EQ(sink.hits.size(), rig.rays.size());
  // At most the FIFO's records may complete before the sink takes them, 1 us = 500 cycles each.
  EXPECT_GE(outcome.measurements.counters.get("machine.cycles"),
            static_cast<int64_t>(rig.rays.size() - 8 - 1) * 500);
  EXPECT_GT(outcome.measurements.counters.sum("traverse", "stall_hit_queue"), 0);
}

/// A run that ends in a fault.
void expect_fault_on(ExitCode code, const std::string& part, void (*spoil)(RandomMemory&)) {
  ShellRig rig("default", 16, "mobile", {"machine.no_progress_cycles=5000"});
  MachineShell machine("machine");
  RayFeeder feeder("feeder");
  RandomMemory memory("memory", 5, 40);
  spoil(memory);
  feeder.socket.bind(machine.rays_in);
  machine.memory_out.bind(memory.socket);
  machine.load(rig.setup());
  feeder.feed(rig.job.trace.rays);
  sc_core::sc_start();
  expect_fault(machine, code, part);
}

TEST(MachineShell, NamesTheReadThatAMemoryAnswersWithWrongBytes) {
  expect_fault_on(ExitCode::kMismatch, "bytes that are not the pyramid's",
                  [](RandomMemory& m) { m.corrupt_read = 20; });
}
TEST(MachineShell, NamesTheRequestThatAMemoryRefuses) {
  expect_fault_on(ExitCode::kMismatch, "TLM_GENERIC_ERROR_RESPONSE", [](RandomMemory& m) { m.refuse = 20; });
}
TEST(MachineShell, GivesUpOnAMemoryThatFallsSilent) {
  expect_fault_on(ExitCode::kNoProgress, "MSHRs taken, wait for dram",
                  [](RandomMemory& m) { m.silent_from = 20; });
}

TEST(MachineShell, SaysThatTheRaysNeverEnded) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "The sanitizer does not know the stack of an SC_THREAD, which the error leaves.";
#endif
  ShellRig rig("default", 16, "mobile", {});
  MachineShell machine("machine");
  LateRays feeder("feeder", rig.job.trace.rays, 3);
  feeder.ends = false;
  RandomMemory memory("memory", 5, 40);
  feeder.socket.bind(machine.rays_in);
  machine.memory_out.bind(memory.socket);
  machine.load(rig.setup());
  sc_core::sc_start();
  expect_fault(machine, ExitCode::kNoProgress, "the end of the rays was never written");
}

TEST(MachineShell, RefusesARayThatCannotBeUsed) {
  ShellRig rig("default", 16, "mobile", {});
  std::vector<TracedRay> rays = rig.job.trace.rays;
  rays[7].direction[0] = rays[7].direction[1] = rays[7].direction[2] = 0;
  MachineShell machine("machine");
  RayFeeder feeder("feeder");
  RandomMemory memory("memory", 5, 40);
  feeder.socket.bind(machine.rays_in);
  machine.memory_out.bind(memory.socket);
  machine.load(rig.setup());
  feeder.feed(rays);
  sc_core::sc_start();
  expect_fault(machine, ExitCode::kInput, "number 7 at machine.rays_in");
}

/// Writes to rays_in what it does not take.
struct Misuser : sc_core::sc_module {
  SC_HAS_PROCESS(Misuser);
  tlm_utils::simple_initiator_socket<Misuser> socket{"socket"};
  std::vector<tlm::tlm_response_status> answers;
  explicit Misuser(const sc_core::sc_module_name& name) : sc_core::sc_module(name) { SC_THREAD(run); }
  void send(bool write, uint64_t address, unsigned count) {
    std::vector<unsigned char> bytes(256, 0);
    tlm::tlm_generic_payload payload;
    payload.set_command(write ? tlm::TLM_WRITE_COMMAND : tlm::TLM_READ_COMMAND);
    payload.set_address(address);
    payload.set_data_ptr(bytes.data());
    payload.set_data_length(count);
    payload.set_streaming_width(count);
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    socket->b_transport(payload, delay);
    answers.push_back(payload.get_response_status());
  }
  void run() {
    send(true, 0x2000, 4);
    send(false, kRayRecords, 112);
    send(true, kRayRecords, 111);
    send(false, kStatus, 4);
    send(true, kEndOfRays, 4);
    send(true, kEndOfRays, 4);
  }
};

TEST(MachineShell, AnswersMisuseOfRaysInAsTlmHasIt) {
  ShellRig rig("default", 16, "mobile", {});
  MachineShell machine("machine");
  Misuser misuser("misuser");
  RandomMemory memory("memory", 5, 40);
  misuser.socket.bind(machine.rays_in);
  machine.memory_out.bind(memory.socket);
  machine.load(rig.setup());
  sc_core::sc_start();
  using tlm::tlm_response_status;
  const std::vector<tlm_response_status> expected = {tlm::TLM_ADDRESS_ERROR_RESPONSE,
                                                     tlm::TLM_COMMAND_ERROR_RESPONSE,
                                                     tlm::TLM_BURST_ERROR_RESPONSE,
                                                     tlm::TLM_OK_RESPONSE,
                                                     tlm::TLM_OK_RESPONSE,
                                                     tlm::TLM_GENERIC_ERROR_RESPONSE};
  EXPECT_EQ(misuser.answers, expected);
  EXPECT_TRUE(machine.done());
  EXPECT_EQ(machine.outcome().hits.size(), 0u);
}

/// Breaks the exclusion rule and the rule of stability.
struct BadInitiator : sc_core::sc_module, tlm::tlm_mm_interface {
  SC_HAS_PROCESS(BadInitiator);
  tlm_utils::simple_initiator_socket<BadInitiator> socket{"socket"};
  explicit BadInitiator(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {
    socket.register_nb_transport_bw(this, &BadInitiator::backward);
    SC_THREAD(run);
  }
  tlm::tlm_sync_enum backward(tlm::tlm_generic_payload&, tlm::tlm_phase&, sc_core::sc_time&) {
    return tlm::TLM_COMPLETED;
  }
  void free(tlm::tlm_generic_payload*) override {}
  void run() {
    unsigned char bytes[64] = {};
    tlm::tlm_generic_payload payloads[2] = {tlm::tlm_generic_payload(this), tlm::tlm_generic_payload(this)};
    for (int k = 0; k < 2; ++k) {
      MemoryTag tag;
      tag.slot = k;
      payloads[k].set_auto_extension(new MemoryTag(tag));
      payloads[k].acquire();
      payloads[k].set_read();
      payloads[k].set_data_ptr(bytes);
      payloads[k].set_data_length(64);
      tlm::tlm_phase phase = tlm::BEGIN_REQ;
      sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
      socket->nb_transport_fw(payloads[k], phase, delay);
    }
    payloads[0].set_address(64);
    wait(1, sc_core::SC_US);
  }
};
struct LateTarget : sc_core::sc_module {
  SC_HAS_PROCESS(LateTarget);
  tlm_utils::simple_target_socket<LateTarget> socket{"socket"};
  tlm::tlm_generic_payload* first = nullptr;
  explicit LateTarget(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {
    socket.register_nb_transport_fw(this, &LateTarget::forward);
    SC_THREAD(run);
  }
  tlm::tlm_sync_enum forward(tlm::tlm_generic_payload& p, tlm::tlm_phase&, sc_core::sc_time&) {
    if (first == nullptr) first = &p;
    return tlm::TLM_ACCEPTED;
  }
  void run() {
    wait(100, sc_core::SC_NS);
    first->set_response_status(tlm::TLM_OK_RESPONSE);
    tlm::tlm_phase phase = tlm::BEGIN_RESP;
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    socket->nb_transport_bw(*first, phase, delay);
  }
};

TEST(BaseProtocolChecker, NamesTheRulesThatABadInitiatorBreaks) {
  BadInitiator initiator("initiator");
  LateTarget target("target");
  BaseProtocolChecker checker("checker");
  initiator.socket.bind(checker.from);
  checker.to.bind(target.socket);
  sc_core::sc_start();
  const std::vector<std::string> expected = {"BEGIN_REQ before the request before it was accepted",
                                             "attributes of a payload change in flight"};
  EXPECT_EQ(checker.faults, expected);
}

}  // namespace
}  // namespace cuesta::systemc
