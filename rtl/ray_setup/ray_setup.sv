// ray_setup: clip, three reciprocals, the three lines, start cell and start level.
//
// Ports: rays in (valid/ready) and contexts out (valid/ready), both in order, both registered.
// Timing: a ray enters when IntervalCycles have passed since the one before and fewer than QueueDepth rays have
// entered and were not taken, both at the end of the cycle before; it may be taken LatencyCycles after it entered.
// ray_setup_engine does the set-up; its result waits in a queue, with the next to be taken in registers of its own.
// LatencyCycles is at least the engine's DoneCycles + 1.

`include "traverse/traverse_types.svh"

module ray_setup #(
`include "common/ray_widths.svh"
    parameter int LatencyCycles = 24,
    parameter int IntervalCycles = 4,
    parameter int QueueDepth = 8
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

  localparam int LineBits = 1 + ShiftBits + MantissaBits + 1 + ProductBits;
  localparam int PlaceBits = HmtLevelBits + 2 * PlaneBits;

  // ---- Time: who may enter, who may be taken
  logic [PointerBits:0] fill_q;  // entered, not taken
  logic [IntervalBits-1:0] wait_q;
`ifdef VERILATOR
  // DoneCycles + 1 of ray_setup_engine
  if (LatencyCycles < 5 + (MantissaBits + 1) / 2 + (MaxLevel + 1) / 2 + $clog2(MaxLevel + 1)) begin : gen_too_short
    $error("LatencyCycles is below what the widths need.");
  end
`endif

  logic [LatencyCycles-1:0] age_q;  // [a]: a ray entered a + 1 cycles ago
  logic [PointerBits:0] ripe_q;     // of those that entered longer ago, not taken
  wire ripens = age_q[LatencyCycles-1];
  wire enters = ray_valid_i & ray_ready_o;
  wire taken = out_valid_o & out_ready_i;

  assign ray_ready_o = (fill_q < (PointerBits + 1)'(QueueDepth)) & (wait_q == '0);
  assign empty_o = fill_q == '0;
  assign out_valid_o = ripens | (ripe_q != '0);

  // ---- The queue behind the engine: stored results, and before them the one at the outputs
  logic arrives;
  logic head_valid_q;
  logic [PointerBits-1:0] read_q, write_q;
  logic [PointerBits:0] stored_q;
  function automatic logic [PointerBits-1:0] next_place(input logic [PointerBits-1:0] place);
    next_place = (place == PointerBits'(QueueDepth - 1)) ? '0 : place + 1'b1;
  endfunction

  // ---- The engine
  logic [IdBits-1:0] id;
  logic dead, still_x, still_y, still_z, flip_x, flip_y, rising;
  logic [MantissaBits:0] mx, my, mz;
  logic signed [ProductBits-1:0] ox, oy, oz;
  logic [ShiftBits-1:0] ex, ey, ez;
  logic [TimeBits-1:0] t_start, t_max, t_root;
  logic signed [PlaneBits-1:0] cell_x, cell_y;
  logic [HmtLevelBits-1:0] span_x, span_y;

  ray_setup_engine #(
      .MaxLevel(MaxLevel),
      .HeightBits(HeightBits),
      .FractionBits(FractionBits),
      .DirectionBits(DirectionBits),
      .MantissaBits(MantissaBits),
      .TileBits(TileBits),
      .IdBits(IdBits),
      .IntervalCycles(IntervalCycles)
  ) u_engine (
      .clk_i,
      .rst_ni,
      .cfg_root_level_i,
      .cfg_border_i,
      .cfg_t_end_i,
      .cfg_root_bound_i,
      .enter_i(enters),
      .ray_id_i,
      .ray_x0_i,
      .ray_y0_i,
      .ray_z0_i,
      .ray_dx_i,
      .ray_dy_i,
      .ray_dz_i,
      .ray_t_max_i,
      .ray_dead_i,
      .done_o(arrives),
      .out_id_o(id),
      .out_dead_o(dead),
      .out_mx_o(mx),
      .out_my_o(my),
      .out_mz_o(mz),
      .out_ox_o(ox),
      .out_oy_o(oy),
      .out_oz_o(oz),
      .out_ex_o(ex),
      .out_ey_o(ey),
      .out_ez_o(ez),
      .out_still_x_o(still_x),
      .out_still_y_o(still_y),
      .out_still_z_o(still_z),
      .out_flip_x_o(flip_x),
      .out_flip_y_o(flip_y),
      .out_rising_o(rising),
      .out_t_start_o(t_start),
      .out_t_max_o(t_max),
      .out_t_root_o(t_root),
      .out_cell_x_o(cell_x),
      .out_cell_y_o(cell_y),
      .out_span_x_o(span_x),
      .out_span_y_o(span_y)
  );

  // ---- Results: stored, or straight to the outputs
  logic [IdBits-1:0] id_q[QueueDepth];
  logic [3:0] ways_q[QueueDepth];  // {dead, flip_x, flip_y, rising}
  logic [LineBits-1:0] line_x_q[QueueDepth];  // {still, shift, mantissa, offset}
  logic [LineBits-1:0] line_y_q[QueueDepth];
  logic [LineBits-1:0] line_z_q[QueueDepth];
  logic [TimeBits-1:0] t_start_q[QueueDepth];
  logic [TimeBits-1:0] t_max_q[QueueDepth];
  logic [TimeBits-1:0] t_root_q[QueueDepth];
  logic [PlaceBits-1:0] place_q[QueueDepth];  // {level, node_x, node_y}

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fill_q <= '0;
      wait_q <= '0;
      age_q <= '0;
      ripe_q <= '0;
      head_valid_q <= 1'b0;
      read_q <= '0;
      write_q <= '0;
      stored_q <= '0;
    end else begin
      age_q <= {age_q[LatencyCycles-2:0], enters};
      if (enters) wait_q <= IntervalBits'(IntervalCycles - 1);
      else if (wait_q != '0) wait_q <= wait_q - 1'b1;
      if (enters != taken) fill_q <= enters ? fill_q + 1'b1 : fill_q - 1'b1;
      if (ripens != taken) ripe_q <= ripens ? ripe_q + 1'b1 : ripe_q - 1'b1;
      if (arrives || taken) begin : move
        logic refills, pops, stores;
        logic [HmtLevelBits-1:0] span, first;
        logic [PlaceBits-1:0] place;
        refills = ~head_valid_q | taken;  // the outputs are free for the next
        pops = refills & (stored_q != '0);
        stores = arrives & ~(refills & (stored_q == '0));
        span = (span_x > span_y) ? span_x : span_y;
        if (span < cfg_stop_level_i) span = cfg_stop_level_i;
        case (cfg_start_i)
          HmtStartLeaf: first = cfg_stop_level_i;
          HmtStartSpan: first = span;
          default: first = cfg_root_level_i;
        endcase
        place = {first, cell_x >>> first, cell_y >>> first};
        if (stores) begin
          id_q[write_q] <= id;
          ways_q[write_q] <= {dead, flip_x, flip_y, rising};
          line_x_q[write_q] <= {still_x, ex, mx, ox};
          line_y_q[write_q] <= {still_y, ey, my, oy};
          line_z_q[write_q] <= {still_z, ez, mz, oz};
          t_start_q[write_q] <= t_start;
          t_max_q[write_q] <= t_max;
          t_root_q[write_q] <= t_root;
          place_q[write_q] <= place;
          write_q <= next_place(write_q);
        end
        if (pops) begin
          out_id_o <= id_q[read_q];
          {out_dead_o, out_flip_x_o, out_flip_y_o, out_rising_o} <= ways_q[read_q];
          {out_still_x_o, out_ex_o, out_mx_o, out_ox_o} <= line_x_q[read_q];
          {out_still_y_o, out_ey_o, out_my_o, out_oy_o} <= line_y_q[read_q];
          {out_still_z_o, out_ez_o, out_mz_o, out_oz_o} <= line_z_q[read_q];
          out_t_start_o <= t_start_q[read_q];
          out_t_max_o <= t_max_q[read_q];
          out_t_root_o <= t_root_q[read_q];
          {out_level_o, out_node_x_o, out_node_y_o} <= place_q[read_q];
          read_q <= next_place(read_q);
        end else if (refills && arrives) begin
          out_id_o <= id;
          {out_dead_o, out_flip_x_o, out_flip_y_o, out_rising_o} <= {dead, flip_x, flip_y, rising};
          {out_still_x_o, out_ex_o, out_mx_o, out_ox_o} <= {still_x, ex, mx, ox};
          {out_still_y_o, out_ey_o, out_my_o, out_oy_o} <= {still_y, ey, my, oy};
          {out_still_z_o, out_ez_o, out_mz_o, out_oz_o} <= {still_z, ez, mz, oz};
          out_t_start_o <= t_start;
          out_t_max_o <= t_max;
          out_t_root_o <= t_root;
          {out_level_o, out_node_x_o, out_node_y_o} <= place;
        end
        if (refills) head_valid_q <= pops | arrives;
        if (pops != stores) stored_q <= stores ? stored_q + 1'b1 : stored_q - 1'b1;
      end
    end
  end

endmodule
