#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "models/oracle/oracle.h"

namespace cuesta {

/// How an answer stands to the exact one. Of hit and cell: the face is counted apart, the time is rounded.
enum class Verdict : uint8_t {
  kExact,      ///< both miss, or both hit the same cell
  kTie,        ///< differs, and is right if touching counts as a hit or edges are closed on the other side
  kMissed,     ///< the oracle hits, the answer does not
  kBehind,     ///< hits another cell, later than the oracle
  kWrongCell,  ///< everything else: a hit that is not there, or one too early
};
inline constexpr int kVerdicts = 5;
std::string_view name_of(Verdict verdict);
/// Ties are right.
constexpr bool is_wrong(Verdict verdict) { return verdict != Verdict::kExact && verdict != Verdict::kTie; }

/// Counts by verdict.
struct VerdictCounts {
  std::array<int64_t, kVerdicts> of{};
  void add(Verdict verdict) { ++of[static_cast<size_t>(verdict)]; }
  int64_t count(Verdict verdict) const { return of[static_cast<size_t>(verdict)]; }
  int64_t total() const;
  int64_t wrong() const { return total() - count(Verdict::kExact) - count(Verdict::kTie); }
};

/// An answer to be judged; `t` in machine time units, any rounding.
struct JudgedAnswer {
  bool hit = false;
  int64_t i = 0, j = 0;
  long double t = 0;
};

/// `truth` is what the leaf walk found for the same ray and map.
template <class Int>
Verdict judge(const ExactRay<Int>& ray, const OracleMap& map, const OracleHit<Int>& truth,
              const JudgedAnswer& answer);

}  // namespace cuesta

#include "models/oracle/verdict_ties.h"
