#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "models/oracle/verdict.h"

namespace cuesta {

/// One set of numbers that traversal may compute with.
struct PrecisionFormat {
  std::string_view name;
  Arithmetic arithmetic;
  int mantissa_over_bits;  ///< M - B
  int fraction_bits;
  int direction_bits;
};

/// The default format, others that differ in one width, float and double.
inline constexpr std::array<PrecisionFormat, 11> kPrecisionFormats = {{
    {"fixed, M = B", Arithmetic::kFixed, 0, 8, 32},
    {"fixed, M = B + 2", Arithmetic::kFixed, 2, 8, 32},
    {"fixed, M = B + 4 (default)", Arithmetic::kFixed, 4, 8, 32},
    {"fixed, M = B + 6", Arithmetic::kFixed, 6, 8, 32},
    {"fixed, M = B + 8", Arithmetic::kFixed, 8, 8, 32},
    {"fixed, f = 4", Arithmetic::kFixed, 4, 4, 32},
    {"fixed, f = 12", Arithmetic::kFixed, 4, 12, 32},
    {"fixed, D = 16", Arithmetic::kFixed, 4, 8, 16},
    {"fixed, D = 24", Arithmetic::kFixed, 4, 8, 24},
    {"float", Arithmetic::kFloat, 4, 8, 32},
    {"double", Arithmetic::kDouble, 4, 8, 32},
}};

/// Which rays are asked about.
enum class PrecisionRays : uint8_t {
  kFree,  ///< uniform places and directions, from front to grazing, falling and rising, two tiles at most
  kLattice,  ///< `random_ray`: on planes, corners and heights, where the exact answer is a matter of the last bit
};

/// Counts of one format.
struct PrecisionRow {
  VerdictCounts set_up;     ///< fixed: against the ray with its rounded reciprocals, which must be exact
  VerdictCounts quantised;  ///< against the machine's input
  VerdictCounts traced;     ///< against the ray as traced: end to end
};

struct PrecisionCheck {
  int64_t rays = 0;
  std::array<PrecisionRow, kPrecisionFormats.size()> rows;
  std::string first_failure;  ///< the first fixed-point answer that is not exact for the ray as set up

  /// Fixed-point answers that are not exact for the ray as set up: 0, or there is a fault.
  int64_t errors() const;
  void add(const PrecisionCheck& other);
};

/// `rays` rays on random maps of 8 to 16 bits in every address mode, leaf walk, in every format. The same seed gives
/// the same counts.
PrecisionCheck check_precision(uint64_t seed, int64_t rays, int max_side, PrecisionRays kind);

}  // namespace cuesta
