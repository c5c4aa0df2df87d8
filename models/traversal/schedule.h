#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace cuesta {

/// Where a ray enters the pyramid.
enum class StartRule : uint8_t { kRoot, kLeaf, kSpan };

/// When a ray that has crossed into a neighbour node goes up one level.
enum class UpRule : uint8_t {
  kNever,
  kAlways,
  kInterval,       ///< the level just crossed is even
  kEvenAxis,       ///< a crossed axis has an even new index
  kBothEven,       ///< both new indices are even
  kSelective,      ///< the neighbour, tested with the current node's bound, would be skipped
  kSelectiveEven,  ///< kSelective and kEvenAxis
  kCoherent,       ///< the previous step was also a crossing on this level
};

/// A traversal algorithm is a schedule: which nodes it looks at, never what it finds (reference: the T-space
/// formulation in README). Pure data.
struct Schedule {
  StartRule start = StartRule::kRoot;
  int down = 1;  ///< levels per descent before the first crossing, 1 to 3; afterwards 1
  UpRule up = UpRule::kNever;
  int stop_level = 0;
};

struct Algorithm {
  std::string_view id;
  Schedule schedule;
  std::string_view source;   ///< author, year
  std::string_view meaning;  ///< one sentence
};

/// All exact algorithms, `dda` first.
std::span<const Algorithm> algorithms();

/// nullptr when there is none of that name.
const Algorithm* find_algorithm(std::string_view id);

std::string_view name_of(StartRule rule);
std::string_view name_of(UpRule rule);

}  // namespace cuesta
