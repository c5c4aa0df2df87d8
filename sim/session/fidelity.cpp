#include "sim/session/fidelity.h"

#include <iterator>

#include "models/common/error.h"
#include "models/common/words.h"

namespace cuesta {
namespace {

constexpr std::string_view kNames[] = {"functional", "transaction", "cycle", "rtl"};

}  // namespace

std::string_view name_of(Fidelity fidelity) { return kNames[static_cast<size_t>(fidelity)]; }

Fidelity parse_fidelity(const std::string& name) {
  for (size_t k = 0; k < std::size(kNames); ++k) {
    if (name == kNames[k]) return static_cast<Fidelity>(k);
  }
  const std::string near = did_you_mean(name, kNames);
  throw usage_error("There is no fidelity `" + printable(name) + "`; accepted are " + joined(kNames) +
                    (near.empty() ? "." : near));
}

bool runs_every_cycle(Fidelity fidelity) {
  return fidelity == Fidelity::kCycle || fidelity == Fidelity::kRtl;
}

}  // namespace cuesta
