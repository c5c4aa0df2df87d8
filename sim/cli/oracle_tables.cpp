#include "sim/cli/oracle_tables.h"

#include <fmt/core.h>

#include <string_view>

namespace cuesta {
namespace {

void print_head(std::string_view what) {
  fmt::print("  {:<28}", what);
  for (int v = 0; v < kVerdicts; ++v) fmt::print("{:>12}", name_of(static_cast<Verdict>(v)));
  fmt::print("{:>13}\n", "not exact");
}

/// A tie is right under another reading of edges; what is neither exact nor a tie is wrong.
void print_row(std::string_view name, const VerdictCounts& counts) {
  fmt::print("  {:<28}", name);
  for (const int64_t count : counts.of) fmt::print("{:>12}", count);
  const int64_t wrong = counts.total() - counts.count(Verdict::kExact);
  fmt::print("{:>11.4f} %\n", counts.total() > 0
                                  ? 100.0 * static_cast<double>(wrong) / static_cast<double>(counts.total())
                                  : 0);
}

void print(const BilinearCheck& walks, const BilinearCheck& borders, const BilinearCheck& exact) {
  if (walks.rays > 0) {
    fmt::print("\nbilinear surfaces: {} maps, {} rays (", walks.maps, walks.rays);
    for (const AddressMode mode : {AddressMode::kBorder, AddressMode::kWrap, AddressMode::kClamp}) {
      fmt::print("{} {}{}", name_of(mode), walks.rays_by_mode[static_cast<size_t>(mode)],
                 mode == AddressMode::kClamp ? "" : ", ");
    }
    fmt::print(
        "), {} of them hit\nevery schedule against dda, in float and in double (hit, cell, t, face):\n",
        walks.hits);
    fmt::print("  {} comparisons, {} mismatches, {} endless walks\n", walks.comparisons, walks.mismatches,
               walks.endless);
  }
  if (borders.rays > 0) {
    fmt::print("{} rays in fans across borders and corners of patches, in float and in double:\n",
               borders.rays);
    fmt::print(
        "  {} borders crossed, {} on which the two patches disagree; {} rays fall to the floor, {} find "
        "no surface\n",
        borders.borders, borders.border_differences, borders.falling, borders.gaps);
  }
  for (const BilinearCheck* c : {&walks, &borders}) {
    if (!c->first_failure.empty()) fmt::print("first failure: {}\n", c->first_failure);
  }
  if (exact.rays == 0) return;
  fmt::print("dda over {} rays, {} of them hit, against exact arithmetic:\n", exact.rays, exact.hits);
  print_head("as quantised at the input");
  constexpr std::string_view kNames[] = {"float", "double"};
  for (size_t a = 0; a < exact.exact.size(); ++a) print_row(kNames[a], exact.exact[a].verdicts);
  for (size_t a = 0; a < exact.exact.size(); ++a) {
    const BilinearCheck::Exact& e = exact.exact[a];
    fmt::print(
        "  {}: of {} times {} within 4 ulps, the largest error {:.4g} ulps; the farthest from the surface "
        "{:.3g} LSBs\n",
        kNames[a], e.times, e.within_4, e.largest_ulps, e.largest_height);
  }
}

void print(const TraversalCheck& c) {
  fmt::print("{} maps, {} rays, {} of them hit\n", c.maps, c.rays, c.hits);
  for (size_t mode = 0; mode < c.rays_by_mode.size(); ++mode) {
    fmt::print("  {:<8}{:>10} rays, {} of them over means (stopped above the texels)\n",
               name_of(static_cast<AddressMode>(mode)), c.rays_by_mode[mode], c.stopped_by_mode[mode]);
  }
  fmt::print("every schedule against dda, in the same arithmetic (hit, cell, t, face):\n");
  fmt::print("  {} comparisons, {} mismatches, {} endless walks\n", c.comparisons, c.mismatches, c.endless);
  fmt::print("the same walks through kept 2 x 2 siblings (whole records, steps too):\n");
  fmt::print("  {} comparisons, {} errors\n", c.quad_comparisons, c.quad_errors);
  fmt::print("fixed-point dda against exact arithmetic (hit, cell, t, face, of the ray as set up):\n");
  fmt::print("  {} leaf walks, {} by brute force over all cells, {} errors\n", c.oracle_walks, c.oracle_brute,
             c.oracle_errors);
  fmt::print("fixed-point steps against the same schedule walked exactly:\n");
  fmt::print("  {} comparisons, {} errors\n", c.step_comparisons, c.step_errors);
  if (c.lane_comparisons > 0) {
    fmt::print("many rays at a time (AVX-512) against one at a time (whole records):\n");
    fmt::print("  {} comparisons, {} errors\n", c.lane_comparisons, c.lane_errors);
  }
  if (!c.first_failure.empty()) fmt::print("first failure: {}\n", c.first_failure);
}

void print(const PrecisionCheck& c, std::string_view which) {
  fmt::print("\nprecision: dda over {} rays {}\n", c.rays, which);
  int64_t set_up = 0;
  for (const PrecisionRow& row : c.rows) set_up += row.set_up.total();
  fmt::print("  against the ray as set up (reciprocals rounded): {} fixed-point answers, {} not exact\n",
             set_up, c.errors());
  print_head("as quantised at the input");
  for (size_t k = 0; k < c.rows.size(); ++k) print_row(kPrecisionFormats[k].name, c.rows[k].quantised);
  print_head("as traced, end to end");
  for (size_t k = 0; k < c.rows.size(); ++k) print_row(kPrecisionFormats[k].name, c.rows[k].traced);
  if (!c.first_failure.empty()) fmt::print("first failure: {}\n", c.first_failure);
}

}  // namespace

void print_oracle_part(const OracleCounts& counts, OraclePart part) {
  switch (part) {
    case OraclePart::kTraversal:
      if (counts.traversal.rays > 0) print(counts.traversal);
      return;
    case OraclePart::kPrecision:
      if (counts.free.rays > 0) print(counts.free, "of any place and direction");
      if (counts.lattice.rays > 0)
        print(counts.lattice, "on planes, corners and heights, where the last bit decides");
      return;
    case OraclePart::kBilinear:
      print(counts.walks, counts.borders, counts.exact);
  }
}

}  // namespace cuesta
