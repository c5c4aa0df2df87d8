#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <string_view>

namespace cuesta::rtl {

class HmtTopPort;
class TraversePort;

/// What the hardware is compiled for: the parameters of rtl/hmt_top.sv, in the order of the columns of rtl/sets.csv.
struct RtlParameters {
  int max_level, height_bits, fraction_bits, direction_bits, mantissa_bits, tile_bits;
  int setup_latency, setup_interval, setup_queue;
  int stages, contexts;
  int size_bytes, line_bytes, ways, mshrs;
};

/// The widths of a set, by the model's formulas (NumberFormat, MapShape; docs/design/numbers.md).
constexpr int index_bits(const RtlParameters& p) { return p.max_level + p.tile_bits; }
constexpr int position_bits(const RtlParameters& p) { return index_bits(p) + p.fraction_bits + 2; }
constexpr int plane_bits(const RtlParameters& p) { return index_bits(p) + 3; }
constexpr int product_bits(const RtlParameters& p) {
  return std::max(index_bits(p) + 2, p.height_bits + 1) + p.fraction_bits + p.mantissa_bits + 2;
}
constexpr int width_of_time(const RtlParameters& p) {
  return std::max(index_bits(p), p.height_bits) + p.fraction_bits + p.mantissa_bits;
}

/// One set of parameters for which there is Verilated hardware. `seed`: of the values that registers without
/// a reset begin with; 0: zeros.
struct RtlSet {
  std::string_view name;
  RtlParameters parameters;
  std::unique_ptr<HmtTopPort> (*make_hmt_top)(int seed);
  std::unique_ptr<TraversePort> (*make_traverse)(int seed);
};

/// The sets of the module cuesta_hardware_sets.so, which the first call loads, in the order of rtl/sets.csv. They are
/// empty where the module is not there, or the program is built with CUESTA_RTL=OFF. Throws Error(kResource) for a
/// module that cannot be loaded or is built from other sources than the program.
std::span<const RtlSet> rtl_sets();

}  // namespace cuesta::rtl
