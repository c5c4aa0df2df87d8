// The words that model and hardware share: values of the configuration registers, with the order of the enums in
// models/algorithms/schedule.h and models/rays/hit.h, held against those when C++ is compiled
// (sim/hardware/tied_constants.h). Every name is prefixed: $unit parameters are seen everywhere.
`ifndef HMT_TRAVERSE_TYPES_SVH
`define HMT_TRAVERSE_TYPES_SVH

localparam logic [1:0] HmtStartRoot /*verilator public*/ = 2'd0;
localparam logic [1:0] HmtStartLeaf /*verilator public*/ = 2'd1;
localparam logic [1:0] HmtStartSpan /*verilator public*/ = 2'd2;

localparam logic [2:0] HmtUpNever /*verilator public*/ = 3'd0;
localparam logic [2:0] HmtUpAlways /*verilator public*/ = 3'd1;
localparam logic [2:0] HmtUpInterval /*verilator public*/ = 3'd2;
localparam logic [2:0] HmtUpEvenAxis /*verilator public*/ = 3'd3;
localparam logic [2:0] HmtUpBothEven /*verilator public*/ = 3'd4;
localparam logic [2:0] HmtUpSelective /*verilator public*/ = 3'd5;
localparam logic [2:0] HmtUpSelectiveEven /*verilator public*/ = 3'd6;
localparam logic [2:0] HmtUpCoherent /*verilator public*/ = 3'd7;

localparam logic [2:0] HmtFaceNone /*verilator public*/ = 3'd0;
localparam logic [2:0] HmtFaceTop /*verilator public*/ = 3'd1;
localparam logic [2:0] HmtFaceWallX /*verilator public*/ = 3'd2;
localparam logic [2:0] HmtFaceWallY /*verilator public*/ = 3'd3;
localparam logic [2:0] HmtFaceInside /*verilator public*/ = 3'd4;

// What a cycle of traverse was.
localparam logic [2:0] HmtSlotBubble /*verilator public*/ = 3'd0;
localparam logic [2:0] HmtSlotStep /*verilator public*/ = 3'd1;     // the texel is there: a node visit
localparam logic [2:0] HmtSlotMiss /*verilator public*/ = 3'd2;     // the lookup missed and has allocated an MSHR
localparam logic [2:0] HmtSlotMerge /*verilator public*/ = 3'd3;    // ... and joined the MSHR of an earlier miss
localparam logic [2:0] HmtSlotRefused /*verilator public*/ = 3'd4;  // ... and found no free MSHR
localparam logic [2:0] HmtSlotDead /*verilator public*/ = 3'd5;     // a ray dead at set-up
localparam logic [2:0] HmtSlotStall /*verilator public*/ = 3'd6;    // the pipe stood still

localparam int HmtLevelBits /*verilator public*/ = 4;  // of a level: root level at most 14

`endif
