// ray_setup: clip, three reciprocals, the three lines, start cell and start level.
//
// Ports: rays in (valid/ready) and contexts out (valid/ready), both in order, both registered.
// Timing: a ray enters when IntervalCycles have passed since the one before and fewer than QueueDepth rays have
// entered and were not taken, both at the end of the cycle before; it may be taken LatencyCycles after it entered.
// Each of QueueDepth engines (ray_setup_engine) holds one ray from its entry until it is taken.

`include "traversal/traverse_types.svh"

module ray_setup #(
    parameter int MaxLevel = 10,       // n of the largest map
    parameter int HeightBits = 8,      // B
    parameter int FractionBits = 8,    // f
    parameter int DirectionBits = 32,  // D
    parameter int MantissaBits = 12,   // M
    parameter int TileBits = 4,        // w2
    parameter int IdBits = 32,
    parameter int LatencyCycles = 24,
    parameter int IntervalCycles = 4,
    parameter int QueueDepth = 8,
    // Widths that follow.
    parameter int IndexBits = MaxLevel + TileBits,
    parameter int PositionBits = IndexBits + FractionBits + 2,
    parameter int PlaneBits = IndexBits + 3,
    parameter int SpaceBits = (IndexBits + 2 > HeightBits + 1) ? IndexBits + 2 : HeightBits + 1,
    parameter int ProductBits = SpaceBits + FractionBits + MantissaBits + 2,
    parameter int TimeBits =
        ((IndexBits > HeightBits) ? IndexBits : HeightBits) + FractionBits + MantissaBits,
    parameter int ShiftBits = $clog2(DirectionBits)
) (
    input logic clk_i,
    input logic rst_ni,

    input logic [HmtLevelBits-1:0] cfg_root_level_i,
    input logic                    cfg_border_i,
    input logic [             1:0] cfg_start_i,
    input logic [HmtLevelBits-1:0] cfg_stop_level_i,
    input logic [    TimeBits-1:0] cfg_t_end_i,
    input logic [  HeightBits-1:0] cfg_root_bound_i,

    input  logic                                      ray_valid_i,
    output logic                                      ray_ready_o,
    input  logic        [                 IdBits-1:0] ray_id_i,
    input  logic signed [           PositionBits-1:0] ray_x0_i,
    input  logic signed [           PositionBits-1:0] ray_y0_i,
    input  logic        [HeightBits+FractionBits-1:0] ray_z0_i,
    input  logic signed [            DirectionBits:0] ray_dx_i,
    input  logic signed [            DirectionBits:0] ray_dy_i,
    input  logic signed [            DirectionBits:0] ray_dz_i,
    input  logic        [               TimeBits-1:0] ray_t_max_i,
    input  logic                                      ray_dead_i,

    output logic                             empty_o,  // no ray inside
    output logic                             out_valid_o,
    input  logic                             out_ready_i,
    output logic        [        IdBits-1:0] out_id_o,
    output logic                             out_dead_o,
    output logic        [    MantissaBits:0] out_mx_o,
    output logic        [    MantissaBits:0] out_my_o,
    output logic        [    MantissaBits:0] out_mz_o,
    output logic signed [   ProductBits-1:0] out_ox_o,
    output logic signed [   ProductBits-1:0] out_oy_o,
    output logic signed [   ProductBits-1:0] out_oz_o,
    output logic        [     ShiftBits-1:0] out_ex_o,
    output logic        [     ShiftBits-1:0] out_ey_o,
    output logic        [     ShiftBits-1:0] out_ez_o,
    output logic                             out_still_x_o,  // dx = 0
    output logic                             out_still_y_o,
    output logic                             out_still_z_o,
    output logic                             out_flip_x_o,
    output logic                             out_flip_y_o,
    output logic                             out_rising_o,
    output logic        [      TimeBits-1:0] out_t_start_o,
    output logic        [      TimeBits-1:0] out_t_max_o,
    output logic        [      TimeBits-1:0] out_t_root_o,
    output logic        [HmtLevelBits-1:0]   out_level_o,
    output logic signed [     PlaneBits-1:0] out_node_x_o,
    output logic signed [     PlaneBits-1:0] out_node_y_o
);

  localparam int IntervalBits = $clog2(IntervalCycles + 1);
  localparam int PointerBits = (QueueDepth > 1) ? $clog2(QueueDepth) : 1;

  logic [PointerBits-1:0] enter_q, take_q;  // next engine to enter, next to be taken
  logic [PointerBits:0] fill_q;
  logic [IntervalBits-1:0] wait_q;
  logic [QueueDepth-1:0] ready;

  wire enters = ray_valid_i & ray_ready_o;
  wire taken = out_valid_o & out_ready_i;

  assign ray_ready_o = (fill_q < (PointerBits + 1)'(QueueDepth)) & (wait_q == '0);
  assign empty_o = fill_q == '0;
  assign out_valid_o = ready[take_q];

  function automatic logic [PointerBits-1:0] next_engine(input logic [PointerBits-1:0] engine);
    next_engine = (engine == PointerBits'(QueueDepth - 1)) ? '0 : engine + 1'b1;
  endfunction

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      enter_q <= '0;
      take_q <= '0;
      fill_q <= '0;
      wait_q <= '0;
    end else begin
      if (wait_q != '0) wait_q <= wait_q - 1'b1;
      if (enters) begin
        enter_q <= next_engine(enter_q);
        wait_q <= IntervalBits'(IntervalCycles - 1);
      end
      if (taken) take_q <= next_engine(take_q);
      fill_q <= fill_q + {{PointerBits{1'b0}}, enters} - {{PointerBits{1'b0}}, taken};
    end
  end

  logic [IdBits-1:0] id[QueueDepth];
  logic dead[QueueDepth];
  logic [MantissaBits:0] mx[QueueDepth];
  logic [MantissaBits:0] my[QueueDepth];
  logic [MantissaBits:0] mz[QueueDepth];
  logic signed [ProductBits-1:0] ox[QueueDepth];
  logic signed [ProductBits-1:0] oy[QueueDepth];
  logic signed [ProductBits-1:0] oz[QueueDepth];
  logic [ShiftBits-1:0] ex[QueueDepth];
  logic [ShiftBits-1:0] ey[QueueDepth];
  logic [ShiftBits-1:0] ez[QueueDepth];
  logic still_x[QueueDepth];
  logic still_y[QueueDepth];
  logic still_z[QueueDepth];
  logic flip_x[QueueDepth];
  logic flip_y[QueueDepth];
  logic rising[QueueDepth];
  logic [TimeBits-1:0] t_start[QueueDepth];
  logic [TimeBits-1:0] t_max[QueueDepth];
  logic [TimeBits-1:0] t_root[QueueDepth];
  logic [HmtLevelBits-1:0] level[QueueDepth];
  logic signed [PlaneBits-1:0] node_x[QueueDepth];
  logic signed [PlaneBits-1:0] node_y[QueueDepth];

  for (genvar e = 0; e < QueueDepth; e++) begin : gen_engine
    ray_setup_engine #(
        .MaxLevel(MaxLevel),
        .HeightBits(HeightBits),
        .FractionBits(FractionBits),
        .DirectionBits(DirectionBits),
        .MantissaBits(MantissaBits),
        .TileBits(TileBits),
        .IdBits(IdBits),
        .LatencyCycles(LatencyCycles)
    ) u_engine (
        .clk_i,
        .rst_ni,
        .cfg_root_level_i,
        .cfg_border_i,
        .cfg_start_i,
        .cfg_stop_level_i,
        .cfg_t_end_i,
        .cfg_root_bound_i,
        .ray_id_i,
        .ray_x0_i,
        .ray_y0_i,
        .ray_z0_i,
        .ray_dx_i,
        .ray_dy_i,
        .ray_dz_i,
        .ray_t_max_i,
        .ray_dead_i,
        .enter_i(enters && enter_q == PointerBits'(e)),
        .free_i(taken && take_q == PointerBits'(e)),
        .ready_o(ready[e]),
        .out_id_o(id[e]),
        .out_dead_o(dead[e]),
        .out_mx_o(mx[e]),
        .out_my_o(my[e]),
        .out_mz_o(mz[e]),
        .out_ox_o(ox[e]),
        .out_oy_o(oy[e]),
        .out_oz_o(oz[e]),
        .out_ex_o(ex[e]),
        .out_ey_o(ey[e]),
        .out_ez_o(ez[e]),
        .out_still_x_o(still_x[e]),
        .out_still_y_o(still_y[e]),
        .out_still_z_o(still_z[e]),
        .out_flip_x_o(flip_x[e]),
        .out_flip_y_o(flip_y[e]),
        .out_rising_o(rising[e]),
        .out_t_start_o(t_start[e]),
        .out_t_max_o(t_max[e]),
        .out_t_root_o(t_root[e]),
        .out_level_o(level[e]),
        .out_node_x_o(node_x[e]),
        .out_node_y_o(node_y[e])
    );
  end

  assign out_id_o = id[take_q];
  assign out_dead_o = dead[take_q];
  assign out_mx_o = mx[take_q];
  assign out_my_o = my[take_q];
  assign out_mz_o = mz[take_q];
  assign out_ox_o = ox[take_q];
  assign out_oy_o = oy[take_q];
  assign out_oz_o = oz[take_q];
  assign out_ex_o = ex[take_q];
  assign out_ey_o = ey[take_q];
  assign out_ez_o = ez[take_q];
  assign out_still_x_o = still_x[take_q];
  assign out_still_y_o = still_y[take_q];
  assign out_still_z_o = still_z[take_q];
  assign out_flip_x_o = flip_x[take_q];
  assign out_flip_y_o = flip_y[take_q];
  assign out_rising_o = rising[take_q];
  assign out_t_start_o = t_start[take_q];
  assign out_t_max_o = t_max[take_q];
  assign out_t_root_o = t_root[take_q];
  assign out_level_o = level[take_q];
  assign out_node_x_o = node_x[take_q];
  assign out_node_y_o = node_y[take_q];

endmodule
