// The widths that follow from a set of parameters, as constants that C++ reads: sim/hardware holds its own formulas
// against them when it is compiled. No hardware.

module hmt_widths #(
`include "common/ray_widths.svh"
    parameter int Hardware = 0
) (
    input logic [Hardware:0] unused_i
);

  localparam int HmtPositionBits /*verilator public*/ = PositionBits;
  localparam int HmtPlaneBits /*verilator public*/ = PlaneBits;
  localparam int HmtProductBits /*verilator public*/ = ProductBits;
  localparam int HmtTimeBits /*verilator public*/ = TimeBits;

endmodule
