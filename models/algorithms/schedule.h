#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "models/algorithms/search.h"

namespace cuesta {

/// Where a ray enters the pyramid.
enum class StartRule : uint8_t { kRoot, kLeaf, kSpan };
inline constexpr std::string_view kStartNames[] = {"root", "leaf", "span"};

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
inline constexpr std::string_view kUpNames[] = {"never",     "always",    "interval",       "even-axis",
                                                "both-even", "selective", "selective-even", "coherent"};

/// What a visit reads: the node's texel; or its 2 x 2 siblings, which the ray keeps until it reads others. A visit
/// whose siblings are kept reads nothing; steps, hits and the order of visits are those of kTexel.
enum class FetchRule : uint8_t { kTexel, kQuad };
inline constexpr std::string_view kFetchNames[] = {"texel", "quad"};

/// `Schedule::down`: straight to the smallest node that holds the ray's cell and the cell where the ray must have
/// ended, one level at least.
inline constexpr int kDownCommon = 64;
/// The values of `Schedule::down`, and how each is written.
inline constexpr int kDownValues[] = {1, 2, 3, kDownCommon};
inline constexpr std::string_view kDownNames[] = {"1", "2", "3", "common"};

inline constexpr int kMostStopLevel = 14;  ///< the root of the largest map, 16384 on a side

/// A traversal algorithm is a schedule: which nodes it looks at, never what it finds (why: docs/design/time-space.md).
/// Pure data.
struct Schedule {
  StartRule start = StartRule::kRoot;
  int down = 1;  ///< levels per descent before the first crossing, 1 to 3 or kDownCommon; afterwards 1
  UpRule up = UpRule::kNever;
  int stop_level = 0;  ///< of the leaves; > 0: texels of the mean pyramid
  FetchRule fetch = FetchRule::kTexel;

  bool operator==(const Schedule&) const = default;
};

enum class AlgorithmKind : uint8_t {
  kPublished,  ///< an algorithm out of the literature
  kPart,       ///< one part of a published one alone, over the root-to-leaf walk of oh2006
  kComposed,   ///< the user's own choices
  kSearch,     ///< approximate: `search` in the place of the schedule
};

struct Algorithm {
  std::string id;
  Schedule schedule;
  AlgorithmKind kind = AlgorithmKind::kPublished;
  std::string source;   ///< author, year
  std::string meaning;  ///< one sentence
  std::optional<Search> search = {};

  /// Finds what every exact algorithm finds; an approximate one may miss a hit or misplace it.
  bool exact() const { return !search; }
};

/// The published exact algorithms, `dda` first.
std::span<const Algorithm> algorithms();
/// The parts of yun2013 and yun2013-coherent, each alone: oh2006 with one thing changed.
std::span<const Algorithm> algorithm_parts();

/// The approximate algorithms with their default parameters, in the order of SearchKind: those that are meant to be
/// right, and those as printed.
std::span<const Algorithm> searches();
std::span<const Algorithm> printed_searches();

/// A published algorithm, a part or a search; nullptr when there is none of that name.
const Algorithm* find_algorithm(std::string_view id);

/// How a schedule is written, in one line, for messages and lists.
inline constexpr std::string_view kScheduleSyntax =
    "START:DOWN:UP or a named algorithm, then :stop=N and :quad";

/// The canonical name: the id of the named row with these choices, else START:DOWN:UP; then `:stop=N` where N > 0
/// and `:quad`. `parse_algorithm` reads it back.
std::string name_of(const Schedule& schedule);

/// Reads what `name_of` writes, and other spellings of the same: "yun2013", "span:2:selective-even" (which is
/// yun2013), "root:common:never:stop=2:quad", "oh2006:quad"; from the leaves DOWN never matters and is read as 1. The
/// `id` is the canonical name. Throws usage_error with what is accepted and the nearest name. A text whose first word
/// names a search is read by `parse_search`.
Algorithm parse_algorithm(std::string_view text);

std::string_view name_of(StartRule rule);
std::string_view name_of(UpRule rule);
std::string_view name_of(FetchRule rule);
std::string_view name_of_down(int down);  ///< "1", "2", "3" or "common"

}  // namespace cuesta
