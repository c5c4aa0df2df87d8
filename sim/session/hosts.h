#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "sim/session/fidelity.h"
#include "sim/session/measure.h"
#include "sim/session/progress.h"
#include "sim/session/waves.h"

namespace cuesta {

/// What a host is made with.
struct HostRequest {
  WaveRequest waves;     ///< the hardware's signals
  std::string vcd;       ///< a new file for the signals of the machine's SystemC module; empty: none
  int pipelines = 1;     ///< of the machine with most
  bool warnings = true;  ///< a simulation kernel's own warnings go to stderr
};

/// What runs machines cycle by cycle. A new one: its maker here, and a row in the table of hosts.cpp.
struct Host {
  std::string_view name;     ///< "direct", "systemc"
  std::string_view meaning;  ///< in a few words, for an option's help
  /// Throws usage_error for a fidelity that the host does not run.
  void (*check_fidelity)(Fidelity fidelity);
  /// Throws usage_error for an algorithm that the host does not serve.
  void (*check_algorithm)(const Algorithm& algorithm);
  /// Makes the runner; an empty one is the machine's own loop. What it has to say goes to `observer`, which must
  /// outlive the runner. Throws usage_error for waves that the host does not write.
  CycleRunner (*make)(const HostRequest& request, Observer& observer);
};

/// Gives every host there is; the first is the one that is taken unless another is named.
std::span<const Host> hosts();

/// Finds a host by its name. Throws usage_error naming those there are.
const Host& find_host(const std::string& name);

}  // namespace cuesta
