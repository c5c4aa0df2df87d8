#include "sim/verify/lockstep/lockstep_case.h"

#include <fmt/core.h>

#include "sim/config/parameters.h"

namespace cuesta {

std::string describe(const LockstepCase& one) {
  const MapShape map = one.map();
  const LockstepMachine& machine = one.machine;
  std::string text =
      fmt::format("seed {}: {}, map {} x {}, {} bits, {}, {} ray{} on {} x {} pixels\n", one.seed,
                  name_of(machine.schedule), map.width, map.height, map.bits, name_of(map.address_mode),
                  one.rays.size(), one.rays.size() == 1 ? "" : "s", one.width, one.height);
  text += "stalls: " + text_of(machine.stalls) + "\n";
  text += fmt::format("register seed: {}\n", machine.register_seed);
  text += "memory: " + (machine.memory ? text_of(*machine.memory) : "the machine's dram") + "\n";
  for (const Parameter& parameter : parameters()) {
    text += fmt::format("{} = {}\n", parameter.path, parameter.text(parameter.get(machine.architecture)));
  }
  return text;
}

std::string text_of(const PortStalls& stalls) {
  std::string text = fmt::format("{}:", stalls.seed);
  for (int port = 0; port < kPortCount; ++port)
    text += fmt::format("{}{}", port == 0 ? "" : ",", stalls.per_mille[port]);
  return text;
}

std::string text_of(const MemoryTiming& timing) {
  return fmt::format("{}:{},{},{}", timing.seed, timing.least_cycles, timing.most_cycles,
                     timing.most_gap_cycles);
}

}  // namespace cuesta
