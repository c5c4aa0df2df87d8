#include "sim/cli/cycle_host.h"

#include <algorithm>
#include <memory>

#include "sim/hosts/systemc/systemc_host.h"

namespace cuesta {

CycleRunner make_cycle_runner(const Session& session, Host host, const std::string& vcd,
                              const WaveOptions& waves, const std::vector<ResolvedArchitecture>& machines) {
  if (host == Host::kDirect) {
    if (vcd.empty()) return waves.wanted() ? wave_runner(waves, session.quiet) : CycleRunner{};
    throw usage_error(
        "--vcd writes the signals of the machine's SystemC module; accepted with --host systemc.");
  }
  if (waves.wanted()) {
    throw usage_error(
        "--waves and --host systemc: accepted is --host direct, which runs the same cycles, or --vcd "
        "for the signals of the SystemC module.");
  }
  int pipelines = 1;
  for (const ResolvedArchitecture& machine : machines) {
    pipelines = std::max(pipelines, machine.architecture.machine.pipelines);
  }
  const auto systemc = std::make_shared<SystemCHost>(vcd, pipelines, session.quiet);
  return [systemc](const Workload& work, std::span<const TracedRay> rays, const Architecture& architecture,
                   const Progress& progress) { return systemc->run(work, rays, architecture, progress); };
}

}  // namespace cuesta

/// libsystemc's main() would call this one; ours takes main()'s place, and starts no simulation that is not asked for.
extern "C" int sc_main(int, char**) { return 0; }
