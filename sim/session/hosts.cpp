#include "sim/session/hosts.h"

#include <memory>

#include "models/common/error.h"
#include "models/common/words.h"
#include "sim/hosts/systemc/systemc_host.h"

namespace cuesta {
namespace {

void accept_fidelity(Fidelity) {}
void accept_algorithm(const Algorithm&) {}

CycleRunner make_direct(const HostRequest& request, Observer& observer) {
  if (!request.vcd.empty()) {
    throw usage_error(
        "--vcd writes the signals of the machine's SystemC module; accepted with --host systemc.");
  }
  return request.waves.wanted() ? wave_runner(request.waves, observer) : CycleRunner{};
}

void check_systemc_fidelity(Fidelity fidelity) {
  if (runs_every_cycle(fidelity)) return;
  throw usage_error("--host systemc runs the machine in time, and --fidelity " +
                    std::string(name_of(fidelity)) +
                    (fidelity == Fidelity::kFunctional ? " has none" : " runs ahead of it") +
                    "; accepted with it are --fidelity cycle, rtl.");
}

void check_systemc_algorithm(const Algorithm& algorithm) { check_served_by_systemc(algorithm.search); }

CycleRunner make_systemc(const HostRequest& request, Observer&) {
  if (request.waves.wanted()) {
    throw usage_error(
        "--waves and --host systemc: accepted is --host direct, which runs the same cycles, or --vcd "
        "for the signals of the SystemC module.");
  }
  const auto host = std::make_shared<SystemCHost>(request.vcd, request.pipelines, !request.warnings);
  return [host](const Workload& work, std::span<const TracedRay> rays, const Architecture& architecture,
                const Progress& progress) { return host->run(work, rays, architecture, progress); };
}

constexpr Host kHosts[] = {
    {"direct", "the event loop", accept_fidelity, accept_algorithm, make_direct},
    {"systemc", "the machine as a SystemC module, its dram behind a TLM socket", check_systemc_fidelity,
     check_systemc_algorithm, make_systemc},
};

}  // namespace

std::span<const Host> hosts() { return kHosts; }

const Host& find_host(const std::string& name) {
  std::vector<std::string_view> names;
  for (const Host& host : kHosts) {
    if (host.name == name) return host;
    names.push_back(host.name);
  }
  const std::string near = did_you_mean(name, names);
  throw usage_error("There is no host `" + printable(name) + "`; accepted are " + joined(names) +
                    (near.empty() ? "." : near));
}

}  // namespace cuesta

/// libsystemc's main() would call this one; a program's own takes main()'s place, and starts no simulation that is not
/// asked for. Weak: a program of tests has its own.
extern "C" __attribute__((weak)) int sc_main(int, char**) { return 0; }
