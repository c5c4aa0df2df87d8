// The words that model and hardware share: values of the configuration registers, with the order of the enums in
// models/traversal/schedule.h and machine_ray.h. Every name is prefixed: $unit parameters are seen everywhere.
`ifndef HMT_TRAVERSE_TYPES_SVH
`define HMT_TRAVERSE_TYPES_SVH

localparam logic [1:0] HmtStartRoot = 2'd0;
localparam logic [1:0] HmtStartLeaf = 2'd1;
localparam logic [1:0] HmtStartSpan = 2'd2;

localparam logic [2:0] HmtUpNever = 3'd0;
localparam logic [2:0] HmtUpAlways = 3'd1;
localparam logic [2:0] HmtUpInterval = 3'd2;
localparam logic [2:0] HmtUpEvenAxis = 3'd3;
localparam logic [2:0] HmtUpBothEven = 3'd4;
localparam logic [2:0] HmtUpSelective = 3'd5;
localparam logic [2:0] HmtUpSelectiveEven = 3'd6;
localparam logic [2:0] HmtUpCoherent = 3'd7;

localparam logic [2:0] HmtFaceNone = 3'd0;
localparam logic [2:0] HmtFaceTop = 3'd1;
localparam logic [2:0] HmtFaceWallX = 3'd2;
localparam logic [2:0] HmtFaceWallY = 3'd3;
localparam logic [2:0] HmtFaceInside = 3'd4;

// What a cycle of traverse was.
localparam logic [2:0] HmtSlotBubble = 3'd0;
localparam logic [2:0] HmtSlotStep = 3'd1;     // the texel is there: a node visit
localparam logic [2:0] HmtSlotMiss = 3'd2;     // the lookup missed and has allocated an MSHR
localparam logic [2:0] HmtSlotMerge = 3'd3;    // ... and joined the MSHR of an earlier miss
localparam logic [2:0] HmtSlotRefused = 3'd4;  // ... and found no free MSHR
localparam logic [2:0] HmtSlotDead = 3'd5;     // a ray dead at set-up
localparam logic [2:0] HmtSlotStall = 3'd6;    // the pipe stood still

localparam int HmtLevelBits = 4;  // of a level: root level at most 14

`endif
