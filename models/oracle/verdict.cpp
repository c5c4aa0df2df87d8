#include "models/oracle/verdict.h"

#include <numeric>

namespace cuesta {

std::string_view name_of(Verdict verdict) {
  constexpr std::string_view kNames[kVerdicts] = {"exact", "tie", "missed", "behind", "wrong cell"};
  return kNames[static_cast<size_t>(verdict)];
}

int64_t VerdictCounts::total() const { return std::accumulate(of.begin(), of.end(), int64_t{0}); }

}  // namespace cuesta
