#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace cuesta {

/// How an approximate algorithm looks for the surface. What each does in a step: search_walk.h.
enum class SearchKind : uint8_t {
  kNormal,
  kParallax,
  kParallaxLimited,
  kSteep,
  kPomPrinted,
  kPom,
  kPomTatarchuk,
  kRelief,
  kInterval,
  kCone,
  kRelaxedCone,
  kDistance,
  kSafetyRadius,
  kKi2007Printed,
  kDrobot2009Printed,
};

/// Algorithms on the max pyramid as their listings have them, faults and all: printed_search.h.
inline bool is_printed(SearchKind kind) { return kind >= SearchKind::kKi2007Printed; }

/// The surface that samples are taken from: constant texels, as the exact algorithms have it; or bilinear between the
/// texels' centres, as a texture unit filters it.
enum class SearchFilter : uint8_t { kTexel, kBilinear };

/// An approximate algorithm with its parameters. Pure data.
struct Search {
  SearchKind kind = SearchKind::kNormal;
  int steps = 0;  ///< of the first search (linear, along cones, through spheres), at most; 0: it has none
  int least_steps =
      0;  ///< parallax occlusion mapping: of a view along the normal; 0: the kind has no such choice
  int refinements = 0;  ///< binary steps or secants after it
  SearchFilter filter = SearchFilter::kTexel;

  // Of the printed kinds, whose `steps` are passes of their loop, after which a ray is given up.
  int delta = 0;        ///< thousandths of a leaf texel, to be scaled by the slab's depth in tile widths
  bool linear = false;  ///< Ki & Oh's linear filtering
  bool slope = false;   ///< a boundary's distance by the ray's slope, without 0 / 0

  bool operator==(const Search&) const = default;
};

inline constexpr int kMostSearchSteps = 4096;
inline constexpr int kMostRefinements = 64;
inline constexpr int kMostDelta = 64000;

/// One kind with the parameters that it has by default.
struct SearchRow {
  std::string_view id;
  Search search;
  bool refines;  ///< `refine=N` is accepted
  std::string_view source;
  std::string_view meaning;
};

/// One row per SearchKind, in its order: the printed kinds last.
std::span<const SearchRow> search_rows();
const SearchRow& row_of(const Search& search);
/// nullptr when there is none of that name.
const SearchRow* find_search(std::string_view id);

/// How a search is written, in one line, for messages and lists.
inline constexpr std::string_view kSearchSyntax =
    "a named search, then :steps=N, :least=N, :refine=N, :bilinear; of those as printed :steps=N, "
    ":delta=TEXELS, "
    ":linear, :slope; as far as it has them";

/// The canonical name: the row's id, then what differs from the row. `parse_search` reads it back.
std::string name_of(const Search& search);

/// Reads "relief", "relief:steps=64:refine=5", "cone:bilinear", "ki2007-printed:delta=0.005:slope". The first word
/// names a row. Throws usage_error with what is accepted and the nearest name.
Search parse_search(std::string_view text);

}  // namespace cuesta
