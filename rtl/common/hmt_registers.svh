// The register map of hmt_top; sim/hardware/hmt_registers.h has the same, held against this when C++ is compiled. Every
// name is prefixed: $unit parameters are seen everywhere.
`ifndef HMT_REGISTERS_SVH
`define HMT_REGISTERS_SVH

localparam logic [5:0] HmtAtMode /*verilator public*/ = 6'd0;
localparam logic [5:0] HmtAtTimeEnd /*verilator public*/ = 6'd1;
localparam logic [5:0] HmtAtRootBound /*verilator public*/ = 6'd2;
localparam logic [5:0] HmtAtLevelBase /*verilator public*/ = 6'd16;  // and 14 more
localparam logic [5:0] HmtAtCounter /*verilator public*/ = 6'd32;    // and 20 more

// Fields of the mode register: their lowest bits.
localparam int HmtModeRootLevel /*verilator public*/ = 0;
localparam int HmtModeBorder /*verilator public*/ = 4;
localparam int HmtModeStart /*verilator public*/ = 5;
localparam int HmtModeDown /*verilator public*/ = 7;
localparam int HmtModeUp /*verilator public*/ = 9;
localparam int HmtModeStopLevel /*verilator public*/ = 12;
localparam int HmtModeMorton /*verilator public*/ = 16;

`endif
