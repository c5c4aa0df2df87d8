#include "sim/session/hosts.h"

#include <gtest/gtest.h>

#include "models/common/error.h"
#include "tests/sim/session/recording_observer.h"

// One simulation a process: each test is started in a process of its own.

namespace cuesta {
namespace {

TEST(Hosts, EveryNameFindsItsHostAndOthersAreRefused) {
  ASSERT_GE(hosts().size(), 2u);
  EXPECT_EQ(hosts()[0].name, "direct");
  for (const Host& host : hosts()) EXPECT_EQ(find_host(std::string(host.name)).name, host.name);
  try {
    find_host("sistemc");
    FAIL() << "a host that is not there was found";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("accepted are direct, systemc; did you mean `systemc`?"),
              std::string::npos)
        << error.what();
  }
}

TEST(Hosts, SystemcRunsTheMachineToTheSameDigest) {
  const Job job = prepare_job("default", [] {
    SceneChanges changes;
    changes.size = {16, 16};
    return changes;
  }());
  RecordingObserver observer;
  std::string digest;
  for (const Host& host : hosts()) {
    const Architecture machine;
    const HostRequest request;
    Measurer measurer(job, host.make(request, observer));
    const RunEntry run = measurer.run(*find_algorithm("yun2013"), machine, Fidelity::kCycle);
    ASSERT_EQ(run.digest.size(), 64u) << host.name;
    if (digest.empty()) digest = run.digest;
    EXPECT_EQ(run.digest, digest) << host.name;
  }
  EXPECT_TRUE(observer.remarks.empty());
}

TEST(Hosts, EachRefusesWhatItDoesNotRun) {
  Observer observer;
  HostRequest request;
  request.vcd = "w.vcd";
  EXPECT_THROW(find_host("direct").make(request, observer), Error);
  request = {};
  request.waves.file = "w.fst";
  EXPECT_THROW(find_host("systemc").make(request, observer), Error);
  EXPECT_TRUE(static_cast<bool>(find_host("direct").make(request, observer)));
  EXPECT_FALSE(static_cast<bool>(find_host("direct").make({}, observer))) << "the machine's own loop";
  EXPECT_THROW(find_host("systemc").check_fidelity(Fidelity::kFunctional), Error);
  EXPECT_THROW(find_host("systemc").check_algorithm(parse_algorithm("relief")), Error);
  find_host("direct").check_fidelity(Fidelity::kFunctional);
  find_host("direct").check_algorithm(parse_algorithm("relief"));
}

}  // namespace
}  // namespace cuesta
