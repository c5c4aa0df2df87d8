#include "sim/hosts/systemc/systemc_host.h"

#include <filesystem>
#include <fstream>
#include <systemc>

#include "models/common/error.h"
#include "models/units/ray_dispatch/dispatch_order.h"
#include "sim/hosts/systemc/dram_target.h"
#include "sim/hosts/systemc/machine_shell.h"
#include "sim/hosts/systemc/ray_feeder.h"
#include "sim/hosts/systemc/reports.h"

namespace cuesta {

using namespace systemc;

struct SystemCHost::Modules {
  RayFeeder feeder{"rays"};
  MachineShell machine{"machine"};
  DramTarget dram{"dram"};
  sc_core::sc_trace_file* waves = nullptr;

  Modules() {
    feeder.socket.bind(machine.rays_in);
    machine.memory_out.bind(dram.socket);
  }
  ~Modules() {
    if (waves != nullptr) sc_core::sc_close_vcd_trace_file(waves);
  }
};

SystemCHost::SystemCHost(const std::string& vcd, int pipelines, bool quiet) {
  install_report_handler(quiet);
  modules_ = std::make_unique<Modules>();
  if (vcd.empty()) return;
  if (!vcd.ends_with(".vcd")) {  // SystemC would choose another name
    throw usage_error("--vcd " + vcd + ": accepted is a file whose name ends in .vcd.");
  }
  std::error_code ignored;
  if (std::filesystem::symlink_status(vcd, ignored).type() != std::filesystem::file_type::not_found) {
    throw usage_error("--vcd " + vcd + ": it exists, or its folder cannot be read; accepted is a new file.");
  }
  const std::string stem = vcd.substr(0, vcd.size() - 4);
  if (!std::ofstream(stem + ".vcd")) {  // SystemC's own complaint comes too late to be caught
    throw usage_error("The waves cannot be written into " + stem +
                      ".vcd; accepted is a file in a folder that may be written.");
  }
  modules_->waves = sc_core::sc_create_vcd_trace_file(stem.c_str());
  modules_->waves->set_time_unit(1, sc_core::SC_PS);
  modules_->machine.trace(modules_->waves, pipelines);
}

SystemCHost::~SystemCHost() = default;

void check_served_by_systemc(const std::optional<Search>& search) {
  if (!search) return;
  throw usage_error("--host systemc serves the bytes of the pyramid's image, and " + name_of(*search) +
                    " is a search, which reads records of its own; accepted with it are exact algorithms.");
}

Outcome SystemCHost::run(const Workload& work, std::span<const TracedRay> rays,
                         const Architecture& architecture, const Progress& progress) {
  check_served_by_systemc(work.search);
  const std::vector<uint32_t> order = dispatch_order(
      work.pixel_of_ray, work.width, architecture.ray_dispatch.order, architecture.ray_dispatch.tile_size);
  std::vector<TracedRay> in_order;
  in_order.reserve(order.size());
  for (const uint32_t k : order) in_order.push_back(rays[k]);

  Modules& m = *modules_;
  try {
    m.machine.load({work.pyramid, work.map, work.schedule, work.width, work.height, &architecture}, progress);
    m.dram.load(architecture, m.machine.clock());
    m.feeder.feed(std::move(in_order));
    sc_core::sc_start();
  } catch (const sc_core::sc_report& report) {
    throw error_of(report);
  }
  return m.machine.outcome(work, order, &m.dram.counts());
}

}  // namespace cuesta
