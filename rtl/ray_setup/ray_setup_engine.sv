// ray_setup_engine: the set-up itself, a pipe of windows that each hold one ray for IntervalCycles cycles.
//
// Ports: `enter_i` takes the ray at the inputs, IntervalCycles or more after the one before; `done_o` says that the
// ray at the outputs, all registered, is set up: for one cycle, DoneCycles after it entered.
// Timing, in cycles since the entry:
//   1 normalise | DivCycles reciprocal, 2 bits a cycle | 1 offsets | 1 clip | CellCycles start cell, 2 bits a cycle,
//   the first with the test whether the ray is dead | SpanCycles start level, a binary search
// What happens in age a (cycles since the entry) is hardware of the window that holds age a + 1: there is one of
// everything that takes a cycle, and of the reciprocal and the searches as many as rays are in them at a time.
// A line is p(k) = k * slope - offset, slope = mantissa << FractionBits; its time is p << shift, saturated.

`include "traverse/traverse_types.svh"

module ray_setup_engine #(
`include "common/ray_widths.svh"
    parameter int IntervalCycles = 4
) (
    input logic clk_i,
    input logic rst_ni,

    input logic [HmtLevelBits-1:0] cfg_root_level_i,
    input logic                    cfg_border_i,
    input logic [    TimeBits-1:0] cfg_t_end_i,
    input logic [  HeightBits-1:0] cfg_root_bound_i,

    input  logic                                      enter_i,
    input  logic        [                 IdBits-1:0] ray_id_i,
    input  logic signed [           PositionBits-1:0] ray_x0_i,
    input  logic signed [           PositionBits-1:0] ray_y0_i,
    input  logic        [HeightBits+FractionBits-1:0] ray_z0_i,
    input  logic signed [            DirectionBits:0] ray_dx_i,
    input  logic signed [            DirectionBits:0] ray_dy_i,
    input  logic signed [            DirectionBits:0] ray_dz_i,
    input  logic        [               TimeBits-1:0] ray_t_max_i,
    input  logic                                      ray_dead_i,

    output logic                             done_o,
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
    output logic signed [     PlaneBits-1:0] out_cell_x_o,
    output logic signed [     PlaneBits-1:0] out_cell_y_o,
    output logic        [  HmtLevelBits-1:0] out_span_x_o,  // lowest level whose node holds the ray's way, in x
    output logic        [  HmtLevelBits-1:0] out_span_y_o
);

  localparam int DivCycles = (MantissaBits + 1) / 2;
  localparam int ExtraBits = 2 * DivCycles - MantissaBits;
  localparam int CellCycles = (MaxLevel + 1) / 2;
  localparam int SpanCycles = $clog2(MaxLevel + 1);
  localparam int AtDiv = 2;
  localparam int AtOffset = AtDiv + DivCycles;
  localparam int AtClip = AtOffset + 1;
  localparam int AtTest = AtClip + 1;
  localparam int AtSpan = AtTest + CellCycles;
  localparam int DoneCycles = AtSpan + SpanCycles;
  localparam int Windows = (DoneCycles - 1) / IntervalCycles + 1;
  localparam int ZBits = HeightBits + FractionBits;
  localparam int DivBits = DirectionBits + 2;
  localparam int QuotientBits = 2 * DivCycles + 2;
  localparam int DivideBits = QuotientBits + DivBits;
  localparam int SearchBits = ProductBits + PlaneBits;

  // Left shift that brings the top bit of d to bit DirectionBits - 1; 0 for d = 0.
  function automatic logic [ShiftBits-1:0] normalising_shift(input logic [DirectionBits-1:0] d);
    logic [DirectionBits-1:0] rest;
    rest = d;
    normalising_shift = '0;
    if (d != '0) begin
      for (int unsigned k = 0; k < ShiftBits; k++) begin  // by halves
        if (rest >> (DirectionBits - (1 << (ShiftBits - 1 - k))) == '0) begin
          normalising_shift[ShiftBits-1-k] = 1'b1;
          rest = rest << (1 << (ShiftBits - 1 - k));
        end
      end
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

  // The quotient 2^(D + M) / d, with ExtraBits more, rounded to the mantissa of 1 / d: half of it, halves up.
  function automatic logic [MantissaBits:0] mantissa_of(input logic [DivideBits-1:0] state);
    mantissa_of = (MantissaBits + 1)'(((state >> (DivBits + ExtraBits)) + DivideBits'(1)) >> 1);
  endfunction

`include "common/plane_time_functions.svh"

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

  // ---- The windows. Window w holds the ages w * IntervalCycles + 1 to (w + 1) * IntervalCycles.
`define HMT_FROM gen_window[Before]
// Whether the ray that is now in age `age` is worked on here, or in one of `ages` ages from that on.
`define HMT_NOW(age) ((age) / IntervalCycles == w && alive[age])
// Whether this window works in one of the ages `first` to `last`, in which something is read.
`define HMT_READ(first, last) (First <= (last) && First + IntervalCycles > (first))
`define HMT_WITHIN(age, ages) ((here & (((Alive'(1) << (ages)) - Alive'(1)) << (age))) != '0)

  // [a]: a ray is in age a, from its entry in this cycle to the cycle in which it is done.
  localparam int Alive = DoneCycles + 1;
  logic [DoneCycles:1] age_q;
  wire [DoneCycles:0] alive = {age_q, enter_i};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) age_q <= '0;
    else age_q <= alive[DoneCycles-1:0];
  end

  for (genvar w = 0; w < Windows; w++) begin : gen_window
    localparam int First = w * IntervalCycles;  // the age in which a ray comes in
    localparam int Before = (w > 0) ? w - 1 : 0;
    // The ages in which there is work for this window.
    localparam int Ages = (w == Windows - 1) ? DoneCycles - First : IntervalCycles;
    localparam logic [DoneCycles:0] Mine = ((Alive'(1) << Ages) - Alive'(1)) << First;
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

    wire comes = alive[First];
    wire [DoneCycles:0] here = alive & Mine;

    task automatic work;
      // The ray that is worked on: the one that comes in, or the one here.
      logic rising, falling, still_x, still_y, still_z;
      logic signed [PositionBits-1:0] x0, y0;
      logic [ZBits-1:0] z0;
      logic signed [DirectionBits:0] dx, dy, dz;
      logic [ShiftBits-1:0] ex, ey, ez;
      logic [DivideBits-1:0] div_x, div_y, div_z;
      logic [MantissaBits:0] mx, my, mz;
      logic signed [ProductBits-1:0] ox, oy, oz;
      logic [TimeBits-1:0] t_start, t_max, t_root, t_end;
      logic [SearchBits-1:0] cell_x, cell_y;
      logic [HmtLevelBits-1:0] low_x, low_y, high_x, high_y;
      // What this window does not read: no wire without a driver.
      {rising, falling, still_x, still_y, still_z} = '0;
      {x0, y0, z0} = '0;
      {dx, dy, dz} = '0;
      {ex, ey, ez} = '0;
      {div_x, div_y, div_z} = '0;
      {mx, my, mz} = '0;
      {ox, oy, oz} = '0;
      {t_start, t_max, t_root, t_end} = '0;
      {cell_x, cell_y} = '0;
      {low_x, low_y, high_x, high_y} = '0;
      if (`HMT_READ(1, AtOffset - 1)) begin
        dx = comes ? `HMT_FROM.dx_q : dx_q;
        dy = comes ? `HMT_FROM.dy_q : dy_q;
        dz = comes ? `HMT_FROM.dz_q : dz_q;
      end
      if (`HMT_READ(AtDiv, AtOffset)) begin
        div_x = comes ? `HMT_FROM.div_x_q : div_x_q;
        div_y = comes ? `HMT_FROM.div_y_q : div_y_q;
        div_z = comes ? `HMT_FROM.div_z_q : div_z_q;
      end
      if (`HMT_READ(1, AtTest)) begin
        x0 = comes ? `HMT_FROM.x0_q : x0_q;
        y0 = comes ? `HMT_FROM.y0_q : y0_q;
      end
      if (`HMT_READ(AtOffset, AtOffset)) begin
        z0 = comes ? `HMT_FROM.z0_q : z0_q;
      end
      if (`HMT_READ(AtOffset, DoneCycles)) begin
        still_x = comes ? `HMT_FROM.still_x_q : still_x_q;
        still_y = comes ? `HMT_FROM.still_y_q : still_y_q;
        ex = comes ? `HMT_FROM.ex_q : ex_q;
        ey = comes ? `HMT_FROM.ey_q : ey_q;
      end
      if (`HMT_READ(AtOffset, AtTest)) begin
        still_z = comes ? `HMT_FROM.still_z_q : still_z_q;
        ez = comes ? `HMT_FROM.ez_q : ez_q;
      end
      if (`HMT_READ(AtClip, DoneCycles)) begin
        mx = comes ? `HMT_FROM.mx_q : mx_q;
        my = comes ? `HMT_FROM.my_q : my_q;
        ox = comes ? `HMT_FROM.ox_q : ox_q;
        oy = comes ? `HMT_FROM.oy_q : oy_q;
      end
      if (`HMT_READ(AtClip, AtClip)) begin
        mz = comes ? `HMT_FROM.mz_q : mz_q;
        oz = comes ? `HMT_FROM.oz_q : oz_q;
      end
      if (`HMT_READ(AtTest, AtSpan - 1)) begin
        t_start = comes ? `HMT_FROM.t_start_q : t_start_q;
      end
      if (`HMT_READ(AtTest, AtTest)) begin
        t_max = comes ? `HMT_FROM.t_max_q : t_max_q;
        t_root = comes ? `HMT_FROM.t_root_q : t_root_q;
      end
      if (`HMT_READ(AtClip, AtTest)) begin
        rising = comes ? `HMT_FROM.rising_q : rising_q;
        falling = comes ? `HMT_FROM.falling_q : falling_q;
      end
      if (`HMT_READ(AtSpan, DoneCycles)) begin
        t_end = comes ? `HMT_FROM.t_end_q : t_end_q;
      end
      if (`HMT_READ(AtTest + 1, DoneCycles)) begin
        cell_x = comes ? `HMT_FROM.cell_x_q : cell_x_q;
        cell_y = comes ? `HMT_FROM.cell_y_q : cell_y_q;
      end
      if (`HMT_READ(AtSpan, DoneCycles)) begin
        low_x = comes ? `HMT_FROM.low_x_q : low_x_q;
        low_y = comes ? `HMT_FROM.low_y_q : low_y_q;
        high_x = comes ? `HMT_FROM.high_x_q : high_x_q;
        high_y = comes ? `HMT_FROM.high_y_q : high_y_q;
      end
      if (comes && w > 0) begin
        id_q <= `HMT_FROM.id_q;
        dead_q <= `HMT_FROM.dead_q;
        flip_x_q <= `HMT_FROM.flip_x_q;
        flip_y_q <= `HMT_FROM.flip_y_q;
        rising_q <= `HMT_FROM.rising_q;
        falling_q <= `HMT_FROM.falling_q;
        x0_q <= `HMT_FROM.x0_q;
        y0_q <= `HMT_FROM.y0_q;
        z0_q <= `HMT_FROM.z0_q;
        dx_q <= `HMT_FROM.dx_q;
        dy_q <= `HMT_FROM.dy_q;
        dz_q <= `HMT_FROM.dz_q;
        still_x_q <= `HMT_FROM.still_x_q;
        still_y_q <= `HMT_FROM.still_y_q;
        still_z_q <= `HMT_FROM.still_z_q;
        ex_q <= `HMT_FROM.ex_q;
        ey_q <= `HMT_FROM.ey_q;
        ez_q <= `HMT_FROM.ez_q;
        div_x_q <= `HMT_FROM.div_x_q;
        div_y_q <= `HMT_FROM.div_y_q;
        div_z_q <= `HMT_FROM.div_z_q;
        mx_q <= `HMT_FROM.mx_q;
        my_q <= `HMT_FROM.my_q;
        mz_q <= `HMT_FROM.mz_q;
        ox_q <= `HMT_FROM.ox_q;
        oy_q <= `HMT_FROM.oy_q;
        oz_q <= `HMT_FROM.oz_q;
        t_start_q <= `HMT_FROM.t_start_q;
        t_max_q <= `HMT_FROM.t_max_q;
        t_root_q <= `HMT_FROM.t_root_q;
        t_end_q <= `HMT_FROM.t_end_q;
        cell_x_q <= `HMT_FROM.cell_x_q;
        cell_y_q <= `HMT_FROM.cell_y_q;
        low_x_q <= `HMT_FROM.low_x_q;
        low_y_q <= `HMT_FROM.low_y_q;
        high_x_q <= `HMT_FROM.high_x_q;
        high_y_q <= `HMT_FROM.high_y_q;
      end
      if (comes && w == 0) begin
        id_q <= ray_id_i;
        dead_q <= ray_dead_i;
        x0_q <= ray_x0_i;
        y0_q <= ray_y0_i;
        z0_q <= ray_z0_i;
        dx_q <= ray_dx_i;
        dy_q <= ray_dy_i;
        dz_q <= ray_dz_i;
        t_max_q <= ray_t_max_i;
      end

      if (`HMT_NOW(1)) begin  // mirror, normalise
        flip_x_q <= dx[DirectionBits];
        flip_y_q <= dy[DirectionBits];
        rising_q <= ~dz[DirectionBits] & (dz != '0);
        falling_q <= dz[DirectionBits];
        if (dx[DirectionBits]) x0_q <= PositionBits'(side_plane <<< FractionBits) - x0;
        if (dy[DirectionBits]) y0_q <= PositionBits'(side_plane <<< FractionBits) - y0;
        still_x_q <= dx == '0;
        still_y_q <= dy == '0;
        still_z_q <= dz == '0;
        ex = normalising_shift(magnitude(dx));
        ey = normalising_shift(magnitude(dy));
        ez = normalising_shift(magnitude(dz));
        dx = {1'b0, magnitude(dx) << ex};
        dy = {1'b0, magnitude(dy) << ey};
        dz = {1'b0, magnitude(dz) << ez};
        ex_q <= ex;
        ey_q <= ey;
        ez_q <= ez;
        dx_q <= dx;
        dy_q <= dy;
        dz_q <= dz;
        div_x_q <= divide_from(dx[DirectionBits-1:0]);
        div_y_q <= divide_from(dy[DirectionBits-1:0]);
        div_z_q <= divide_from(dz[DirectionBits-1:0]);
      end

      if (`HMT_WITHIN(AtDiv, DivCycles)) begin
        div_x_q <= divide_2(div_x, dx);
        div_y_q <= divide_2(div_y, dy);
        div_z_q <= divide_2(div_z, dz);
      end

      if (`HMT_NOW(AtOffset)) begin
        mx_q <= still_x ? (MantissaBits + 1)'(1) : mantissa_of(div_x);
        my_q <= still_y ? (MantissaBits + 1)'(1) : mantissa_of(div_y);
        mz_q <= still_z ? (MantissaBits + 1)'(1) : mantissa_of(div_z);
        ox_q <= still_x ? ProductBits'(x0) + ProductBits'(1)
            : ProductBits'(x0) * $signed(ProductBits'({1'b0, mantissa_of(div_x)}));
        oy_q <= still_y ? ProductBits'(y0) + ProductBits'(1)
            : ProductBits'(y0) * $signed(ProductBits'({1'b0, mantissa_of(div_y)}));
        oz_q <= still_z ? $signed(ProductBits'({1'b0, z0}))
            : $signed(ProductBits'({1'b0, z0})) * $signed(ProductBits'({1'b0, mantissa_of(div_z)}));
        if (still_x) ex_q <= '0;
        if (still_y) ey_q <= '0;
        if (still_z) ez_q <= '0;
      end

      if (`HMT_NOW(AtClip)) begin
        t_start_q <= '0;
        if (cfg_border_i) begin
          t_start_q <= later(time_of(-ox, still_x, ex, cfg_t_end_i),
                             time_of(-oy, still_y, ey, cfg_t_end_i));
        end
        // When a falling ray is on the floor, a rising one above everything.
        t_root_q <= time_of(rising ? product($signed(ProductBits'({1'b0, cfg_root_bound_i})), mz, oz) : oz,
                            still_z, ez, cfg_t_end_i);
      end

      if (`HMT_NOW(AtTest)) begin
        if (cfg_border_i && (
            t_start >= time_of(product(side_plane, mx, ox), still_x, ex, cfg_t_end_i)
            || t_start >= time_of(product(side_plane, my, oy), still_y, ey, cfg_t_end_i)
            || (falling && t_start > t_root))) begin
          dead_q <= 1'b1;
        end
        if (t_start >= t_max) dead_q <= 1'b1;
        if (rising && t_root <= t_start) dead_q <= 1'b1;
        t_end_q <= later(t_start, (!still_z && t_root < t_max) ? t_root : t_max);
        // The start cell: of the origin, or, of a ray that enters by the border, the first two bits.
        if (t_start == '0) begin
          cell_x_q <= {-ox, PlaneBits'(x0 >>> FractionBits)};
          cell_y_q <= {-oy, PlaneBits'(y0 >>> FractionBits)};
        end else begin
          cell_x_q <= search_2({-ox, still_x ? PlaneBits'(x0 >>> FractionBits) : PlaneBits'(0)},
                               2 * CellCycles - 1, still_x, mx, ex, t_start);
          cell_y_q <= search_2({-oy, still_y ? PlaneBits'(y0 >>> FractionBits) : PlaneBits'(0)},
                               2 * CellCycles - 1, still_y, my, ey, t_start);
        end
        low_x_q <= '0;
        low_y_q <= '0;
        high_x_q <= cfg_root_level_i;
        high_y_q <= cfg_root_level_i;
      end

      for (int unsigned b = 1; b < CellCycles; b++) begin
        if (`HMT_NOW(AtTest + b) && t_start != '0) begin
          cell_x_q <= search_2(cell_x, 2 * (CellCycles - b) - 1, still_x, mx, ex, t_start);
          cell_y_q <= search_2(cell_y, 2 * (CellCycles - b) - 1, still_y, my, ey, t_start);
        end
      end

      if (`HMT_WITHIN(AtSpan, SpanCycles)) begin
        if (low_x < high_x) begin
          if (ends_beyond(exit_plane(cell_x[PlaneBits-1:0], middle(low_x, high_x)), side_plane, cfg_border_i,
                          still_x, mx, ox, ex, t_end, t_end == cfg_t_end_i)) begin
            low_x_q <= middle(low_x, high_x) + 1'b1;
          end else begin
            high_x_q <= middle(low_x, high_x);
          end
        end
        if (low_y < high_y) begin
          if (ends_beyond(exit_plane(cell_y[PlaneBits-1:0], middle(low_y, high_y)), side_plane, cfg_border_i,
                          still_y, my, oy, ey, t_end, t_end == cfg_t_end_i)) begin
            low_y_q <= middle(low_y, high_y) + 1'b1;
          end else begin
            high_y_q <= middle(low_y, high_y);
          end
        end
      end
    endtask
    always_ff @(posedge clk_i) if (here != '0) work();
  end

`undef HMT_FROM
`undef HMT_NOW
`undef HMT_READ
`undef HMT_WITHIN

  assign done_o = alive[DoneCycles];
  assign out_id_o = gen_window[Windows-1].id_q;
  assign out_dead_o = gen_window[Windows-1].dead_q;
  assign out_mx_o = gen_window[Windows-1].mx_q;
  assign out_my_o = gen_window[Windows-1].my_q;
  assign out_mz_o = gen_window[Windows-1].mz_q;
  assign out_ox_o = gen_window[Windows-1].ox_q;
  assign out_oy_o = gen_window[Windows-1].oy_q;
  assign out_oz_o = gen_window[Windows-1].oz_q;
  assign out_ex_o = gen_window[Windows-1].ex_q;
  assign out_ey_o = gen_window[Windows-1].ey_q;
  assign out_ez_o = gen_window[Windows-1].ez_q;
  assign out_still_x_o = gen_window[Windows-1].still_x_q;
  assign out_still_y_o = gen_window[Windows-1].still_y_q;
  assign out_still_z_o = gen_window[Windows-1].still_z_q;
  assign out_flip_x_o = gen_window[Windows-1].flip_x_q;
  assign out_flip_y_o = gen_window[Windows-1].flip_y_q;
  assign out_rising_o = gen_window[Windows-1].rising_q;
  assign out_t_start_o = gen_window[Windows-1].t_start_q;
  assign out_t_max_o = gen_window[Windows-1].t_max_q;
  assign out_t_root_o = gen_window[Windows-1].t_root_q;
  assign out_cell_x_o = gen_window[Windows-1].cell_x_q[PlaneBits-1:0];
  assign out_cell_y_o = gen_window[Windows-1].cell_y_q[PlaneBits-1:0];
  assign out_span_x_o = gen_window[Windows-1].high_x_q;
  assign out_span_y_o = gen_window[Windows-1].high_y_q;

endmodule
