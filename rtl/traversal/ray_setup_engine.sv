// ray_setup_engine: one ray's set-up, from its entry until traverse has taken it.
//
// Ports: `enter_i` takes the ray at the inputs (the engine must be idle), `ready_o` says that LatencyCycles have
// passed since, `free_i` that the ray was taken. All registered.
// Timing, in cycles since the entry:
//   1 normalise | DivCycles reciprocal, 2 bits a cycle | 1 offsets | 2 clip | CellCycles start cell, 2 bits a cycle
//   | SpanCycles start level, a binary search
// A line is p(k) = k * slope - offset, slope = mantissa << FractionBits; its time is p << shift, saturated.

`include "traversal/traverse_types.svh"

module ray_setup_engine #(
    parameter int MaxLevel = 10,       // n of the largest map
    parameter int HeightBits = 8,      // B
    parameter int FractionBits = 8,    // f
    parameter int DirectionBits = 32,  // D
    parameter int MantissaBits = 12,   // M
    parameter int TileBits = 4,        // w2
    parameter int IdBits = 32,
    parameter int LatencyCycles = 24,
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

    input  logic                                      enter_i,
    input  logic                                      free_i,
    output logic                                      ready_o,
    input  logic        [                 IdBits-1:0] ray_id_i,
    input  logic signed [           PositionBits-1:0] ray_x0_i,
    input  logic signed [           PositionBits-1:0] ray_y0_i,
    input  logic        [HeightBits+FractionBits-1:0] ray_z0_i,
    input  logic signed [            DirectionBits:0] ray_dx_i,
    input  logic signed [            DirectionBits:0] ray_dy_i,
    input  logic signed [            DirectionBits:0] ray_dz_i,
    input  logic        [               TimeBits-1:0] ray_t_max_i,
    input  logic                                      ray_dead_i,


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

  localparam int DivCycles = (MantissaBits + 1) / 2;
  localparam int ExtraBits = 2 * DivCycles - MantissaBits;
  localparam int CellCycles = (MaxLevel + 1) / 2;
  localparam int SpanCycles = $clog2(MaxLevel + 1);
  localparam int AtDiv = 2;
  localparam int AtOffset = AtDiv + DivCycles;
  localparam int AtClip = AtOffset + 1;
  localparam int AtTest = AtClip + 1;
  localparam int AtCell = AtTest + 1;
  localparam int AtSpan = AtCell + CellCycles;
  localparam int NeedsCycles = AtSpan + SpanCycles;
  localparam int AgeBits = $clog2(LatencyCycles + 1);
  localparam int ZBits = HeightBits + FractionBits;
  localparam int DivBits = DirectionBits + 2;
  localparam int QuotientBits = 2 * DivCycles + 2;
  localparam int DivideBits = QuotientBits + DivBits;
  localparam int SearchBits = ProductBits + PlaneBits;

  logic                               busy_q;
  logic        [         AgeBits-1:0] age_q;  // cycles since the ray entered, up to LatencyCycles
  logic        [          IdBits-1:0] id_q;
  logic                               dead_q;
  logic                               flip_x_q;
  logic                               flip_y_q;
  logic                               rising_q;
  logic                               falling_q;
  logic signed [    PositionBits-1:0] x0_q;  // mirrored from age 2 on
  logic signed [    PositionBits-1:0] y0_q;
  logic        [           ZBits-1:0] z0_q;
  logic signed [     DirectionBits:0] dx_q;  // normalised from age 2 on
  logic signed [     DirectionBits:0] dy_q;
  logic signed [     DirectionBits:0] dz_q;
  logic                               still_x_q;
  logic                               still_y_q;
  logic                               still_z_q;
  logic        [       ShiftBits-1:0] ex_q;
  logic        [       ShiftBits-1:0] ey_q;
  logic        [       ShiftBits-1:0] ez_q;
  logic        [      DivideBits-1:0] div_x_q;  // {quotient, remainder}
  logic        [      DivideBits-1:0] div_y_q;
  logic        [      DivideBits-1:0] div_z_q;
  logic        [      MantissaBits:0] mx_q;
  logic        [      MantissaBits:0] my_q;
  logic        [      MantissaBits:0] mz_q;
  logic signed [     ProductBits-1:0] ox_q;
  logic signed [     ProductBits-1:0] oy_q;
  logic signed [     ProductBits-1:0] oz_q;
  logic        [        TimeBits-1:0] t_start_q;
  logic        [        TimeBits-1:0] t_max_q;
  logic        [        TimeBits-1:0] t_root_q;
  logic        [        TimeBits-1:0] t_end_q;  // the time at which the end cell is asked for
  logic        [      SearchBits-1:0] cell_x_q;  // {product, start cell}
  logic        [      SearchBits-1:0] cell_y_q;
  logic        [    HmtLevelBits-1:0] low_x_q;  // start level: between low and high
  logic        [    HmtLevelBits-1:0] low_y_q;
  logic        [    HmtLevelBits-1:0] high_x_q;
  logic        [    HmtLevelBits-1:0] high_y_q;


  // Left shift that brings the top bit of d to bit DirectionBits - 1; 0 for d = 0.
  function automatic logic [ShiftBits-1:0] normalising_shift(input logic [DirectionBits-1:0] d);
    normalising_shift = '0;
    for (int unsigned b = 0; b < DirectionBits; b++) begin
      if (d[b]) normalising_shift = ShiftBits'(DirectionBits - 1 - b);
    end
  endfunction

  // 1 / d, normalised: {quotient, remainder}, two bits of quotient later.
  function automatic logic [DivideBits-1:0] divide_2(input logic [DivideBits-1:0] state,
                                                     input logic [DirectionBits:0] d);
    logic [DivideBits-1:0] next;
    next = state;
    for (int unsigned k = 0; k < 2; k++) begin
      next = next << 1;
      next[DivBits] = next[DivBits-1:0] >= DivBits'(d);  // the quotient's new bit
      if (next[DivBits]) next[DivBits-1:0] = next[DivBits-1:0] - DivBits'(d);
    end
    divide_2 = next;
  endfunction

  // 2^D / d is 1, or 2 for d = 2^(D - 1): where the division begins.
  function automatic logic [DivideBits-1:0] divide_from(input logic [DirectionBits-1:0] d);
    divide_from = (d << 1 == '0) ? {QuotientBits'(2), DivBits'(0)}
        : {QuotientBits'(1), (DivBits'(1) << DirectionBits) - DivBits'(d)};
  endfunction

  function automatic logic [DirectionBits-1:0] magnitude(input logic signed [DirectionBits:0] d);
    magnitude = DirectionBits'(d[DirectionBits] ? -d : d);
  endfunction

  function automatic logic [DirectionBits-1:0] normalised(input logic [DirectionBits-1:0] d);
    normalised = d << normalising_shift(d);
  endfunction

  // The quotient 2^(D + M) / d, with ExtraBits more, rounded to the mantissa of 1 / d: half of it, halves up.
  function automatic logic [MantissaBits:0] mantissa_of(input logic [DivideBits-1:0] state);
    mantissa_of = (MantissaBits + 1)'(((state >> (DivBits + ExtraBits)) + DivideBits'(1)) >> 1);
  endfunction

`include "traversal/line_functions.svh"

  // The start cell, two bits from `bit_number` down: a plane that the ray has passed at t belongs to it.
  function automatic logic [SearchBits-1:0] search_2(input logic [SearchBits-1:0] state,
                                                     input int unsigned bit_number, input logic still,
                                                     input logic [MantissaBits:0] mantissa,
                                                     input logic [ShiftBits-1:0] shift,
                                                     input logic [TimeBits-1:0] t);
    logic signed [ProductBits-1:0] p, upper;
    logic [PlaneBits-1:0] plane;
    {p, plane} = state;
    for (int unsigned k = 0; k < 2; k++) begin
      upper = p + ($signed(ProductBits'({1'b0, mantissa})) <<< (FractionBits + bit_number - k));
      if (!still && at_most(upper, 1'b0, shift, t)) begin
        p = upper;
        plane = plane | (PlaneBits'(1) << (bit_number - k));
      end
    end
    search_2 = {p, plane};
  endfunction

  // The plane at which the ray leaves the node of `level` that holds `leaf`.
  function automatic logic signed [ProductBits-1:0] exit_plane(input logic [PlaneBits-1:0] leaf,
                                                               input logic [HmtLevelBits-1:0] level);
    exit_plane = ((ProductBits'($signed(leaf)) >>> level) + ProductBits'(1)) <<< level;
  endfunction

  function automatic logic [HmtLevelBits-1:0] middle(input logic [HmtLevelBits-1:0] low,
                                                     input logic [HmtLevelBits-1:0] high);
    middle = HmtLevelBits'(({1'b0, low} + {1'b0, high}) >> 1);
  endfunction

  // What the engines share: the map's side as a plane.
  wire signed [ProductBits-1:0] side_plane = ProductBits'(1) << cfg_root_level_i;

  // Whether the ray's end lies beyond the plane at which it leaves a node.
  function automatic logic ends_beyond(input logic signed [ProductBits-1:0] plane,
                                       input logic signed [ProductBits-1:0] side, input logic border,
                                       input logic still, input logic [MantissaBits:0] mantissa,
                                       input logic signed [ProductBits-1:0] offset,
                                       input logic [ShiftBits-1:0] shift, input logic [TimeBits-1:0] t,
                                       input logic endless);
    ends_beyond = ~still & ~(border & (plane == side)) &
        (endless | at_most(product(plane, mantissa, offset), 1'b0, shift, t));
  endfunction

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      busy_q <= 1'b0;
    end else begin
      if (busy_q) begin
        if (age_q != AgeBits'(LatencyCycles)) age_q <= age_q + 1'b1;

        if (age_q == AgeBits'(1)) begin  // mirror, normalise
          flip_x_q <= dx_q[DirectionBits];
          flip_y_q <= dy_q[DirectionBits];
          rising_q <= ~dz_q[DirectionBits] & (dz_q != '0);
          falling_q <= dz_q[DirectionBits];
          if (dx_q[DirectionBits]) begin
            x0_q <= PositionBits'(side_plane <<< FractionBits) - x0_q;
          end
          if (dy_q[DirectionBits]) begin
            y0_q <= PositionBits'(side_plane <<< FractionBits) - y0_q;
          end
          still_x_q <= dx_q == '0;
          still_y_q <= dy_q == '0;
          still_z_q <= dz_q == '0;
          ex_q <= normalising_shift(magnitude(dx_q));
          ey_q <= normalising_shift(magnitude(dy_q));
          ez_q <= normalising_shift(magnitude(dz_q));
          dx_q <= {1'b0, normalised(magnitude(dx_q))};
          dy_q <= {1'b0, normalised(magnitude(dy_q))};
          dz_q <= {1'b0, normalised(magnitude(dz_q))};
          div_x_q <= divide_from(normalised(magnitude(dx_q)));
          div_y_q <= divide_from(normalised(magnitude(dy_q)));
          div_z_q <= divide_from(normalised(magnitude(dz_q)));
        end

        if (age_q >= AgeBits'(AtDiv) && age_q < AgeBits'(AtOffset)) begin
          div_x_q <= divide_2(div_x_q, dx_q);
          div_y_q <= divide_2(div_y_q, dy_q);
          div_z_q <= divide_2(div_z_q, dz_q);
        end

        if (age_q == AgeBits'(AtOffset)) begin
          mx_q <= still_x_q ? (MantissaBits + 1)'(1) : mantissa_of(div_x_q);
          my_q <= still_y_q ? (MantissaBits + 1)'(1) : mantissa_of(div_y_q);
          mz_q <= still_z_q ? (MantissaBits + 1)'(1) : mantissa_of(div_z_q);
          ox_q <= still_x_q ? ProductBits'(x0_q) + ProductBits'(1)
              : ProductBits'(x0_q) * $signed(ProductBits'({1'b0, mantissa_of(div_x_q)}));
          oy_q <= still_y_q ? ProductBits'(y0_q) + ProductBits'(1)
              : ProductBits'(y0_q) * $signed(ProductBits'({1'b0, mantissa_of(div_y_q)}));
          oz_q <= still_z_q ? $signed(ProductBits'({1'b0, z0_q}))
              : $signed(ProductBits'({1'b0, z0_q}))
                  * $signed(ProductBits'({1'b0, mantissa_of(div_z_q)}));
          if (still_x_q) ex_q <= '0;
          if (still_y_q) ey_q <= '0;
          if (still_z_q) ez_q <= '0;
        end

        if (age_q == AgeBits'(AtClip)) begin
          t_start_q <= '0;
          if (cfg_border_i) begin
            t_start_q <= later(time_of(-ox_q, still_x_q, ex_q, cfg_t_end_i),
                                  time_of(-oy_q, still_y_q, ey_q, cfg_t_end_i));
          end
          // When a falling ray is on the floor, a rising one above everything.
          t_root_q <= time_of(rising_q ? product($signed(ProductBits'({1'b0, cfg_root_bound_i})),
                                                       mz_q, oz_q) : oz_q,
                                 still_z_q, ez_q, cfg_t_end_i);
        end

        if (age_q == AgeBits'(AtTest)) begin
          if (cfg_border_i && (t_start_q >= time_of(product(side_plane, mx_q, ox_q), still_x_q,
                                                       ex_q, cfg_t_end_i)
              || t_start_q >= time_of(product(side_plane, my_q, oy_q), still_y_q, ey_q,
                                         cfg_t_end_i)
              || (falling_q && t_start_q > t_root_q))) begin
            dead_q <= 1'b1;
          end
          if (t_start_q >= t_max_q) dead_q <= 1'b1;
          if (rising_q && t_root_q <= t_start_q) dead_q <= 1'b1;
          t_end_q <= later(t_start_q, (!still_z_q && t_root_q < t_max_q) ? t_root_q
                                                                                       : t_max_q);
          cell_x_q <= {-ox_q, (t_start_q == '0 || still_x_q)
                              ? PlaneBits'(x0_q >>> FractionBits) : PlaneBits'(0)};
          cell_y_q <= {-oy_q, (t_start_q == '0 || still_y_q)
                              ? PlaneBits'(y0_q >>> FractionBits) : PlaneBits'(0)};
          low_x_q <= '0;
          low_y_q <= '0;
          high_x_q <= cfg_root_level_i;
          high_y_q <= cfg_root_level_i;
        end

        for (int unsigned b = 0; b < CellCycles; b++) begin
          if (age_q == AgeBits'(AtCell + b) && t_start_q != '0) begin
            cell_x_q <= search_2(cell_x_q, 2 * (CellCycles - b) - 1, still_x_q, mx_q, ex_q,
                                    t_start_q);
            cell_y_q <= search_2(cell_y_q, 2 * (CellCycles - b) - 1, still_y_q, my_q, ey_q,
                                    t_start_q);
          end
        end

        if (age_q >= AgeBits'(AtSpan) && age_q < AgeBits'(NeedsCycles)) begin
          if (low_x_q < high_x_q) begin
            if (ends_beyond(exit_plane(cell_x_q[PlaneBits-1:0], middle(low_x_q, high_x_q)), side_plane,
                            cfg_border_i, still_x_q, mx_q, ox_q, ex_q, t_end_q,
                            t_end_q == cfg_t_end_i)) begin
              low_x_q <= middle(low_x_q, high_x_q) + 1'b1;
            end else begin
              high_x_q <= middle(low_x_q, high_x_q);
            end
          end
          if (low_y_q < high_y_q) begin
            if (ends_beyond(exit_plane(cell_y_q[PlaneBits-1:0], middle(low_y_q, high_y_q)), side_plane,
                            cfg_border_i, still_y_q, my_q, oy_q, ey_q, t_end_q,
                            t_end_q == cfg_t_end_i)) begin
              low_y_q <= middle(low_y_q, high_y_q) + 1'b1;
            end else begin
              high_y_q <= middle(low_y_q, high_y_q);
            end
          end
        end

        if (free_i) busy_q <= 1'b0;
      end else if (enter_i) begin
        busy_q <= 1'b1;
        age_q <= AgeBits'(1);
        id_q <= ray_id_i;
        x0_q <= ray_x0_i;
        y0_q <= ray_y0_i;
        z0_q <= ray_z0_i;
        dx_q <= ray_dx_i;
        dy_q <= ray_dy_i;
        dz_q <= ray_dz_i;
        t_max_q <= ray_t_max_i;
        dead_q <= ray_dead_i;
      end
    end
  end

  assign ready_o = busy_q & (age_q == AgeBits'(LatencyCycles));

  logic [HmtLevelBits-1:0] span;
  always_comb begin
    span = (high_x_q > high_y_q) ? high_x_q : high_y_q;
    if (span < cfg_stop_level_i) span = cfg_stop_level_i;
    case (cfg_start_i)
      HmtStartLeaf: out_level_o = cfg_stop_level_i;
      HmtStartSpan: out_level_o = span;
      default: out_level_o = cfg_root_level_i;
    endcase
  end
  assign out_node_x_o = $signed(cell_x_q[PlaneBits-1:0]) >>> out_level_o;
  assign out_node_y_o = $signed(cell_y_q[PlaneBits-1:0]) >>> out_level_o;
  assign out_id_o = id_q;
  assign out_dead_o = dead_q;
  assign out_mx_o = mx_q;
  assign out_my_o = my_q;
  assign out_mz_o = mz_q;
  assign out_ox_o = ox_q;
  assign out_oy_o = oy_q;
  assign out_oz_o = oz_q;
  assign out_ex_o = ex_q;
  assign out_ey_o = ey_q;
  assign out_ez_o = ez_q;
  assign out_still_x_o = still_x_q;
  assign out_still_y_o = still_y_q;
  assign out_still_z_o = still_z_q;
  assign out_flip_x_o = flip_x_q;
  assign out_flip_y_o = flip_y_q;
  assign out_rising_o = rising_q;
  assign out_t_start_o = t_start_q;
  assign out_t_max_o = t_max_q;
  assign out_t_root_o = t_root_q;

endmodule
