// traverse: one step of one ray per cycle, in a rigid pipe of Stages slots that go round.
//
// Ports: contexts from ray_setup (valid/ready), lookups to height_l1 and its answer in the same cycle, replays and
// retries from height_l1, hit stream out (valid/ready). All but the choice within a cycle are registered; what is
// chosen follows from registers alone, hit_ready_i only enables it.
// Timing: the slot at select holds a ray that has ended (it leaves by the hit stream; while that is not ready the
// whole pipe stands still), a ray that goes on (its texel is looked up), or nothing: then the first that can takes
// it: a replay, a retry, a new ray while fewer than Contexts are resident. A step is done when the slot is at
// select again, Stages cycles later; a ray whose lookup misses is parked and leaves the slot empty.
//   0 select, address, lookup | 1 the texel | 2 products of the exit planes and the texel | 3 their times
//   4 hit, skip, cross | 5 next node and level | 6 further descents, write back
// A stage works only while a step is in it, and only on what the step needs: planes of entry in leaves, the next
// node's exit where the up rule asks for it.

`include "traverse/traverse_types.svh"

module traverse #(
`include "common/ray_widths.svh"
    parameter int Stages = 8,
    parameter int Contexts = 32,
    parameter int AddressBits = 24,
    // A width that follows.
    parameter int ContextBits = (Contexts > 1) ? $clog2(Contexts) : 1
) (
    input logic clk_i,
    input logic rst_ni,

    input logic [                HmtLevelBits-1:0] cfg_root_level_i,
    input logic                                    cfg_border_i,
    input logic [                             1:0] cfg_down_i,
    input logic [                             2:0] cfg_up_i,
    input logic [                HmtLevelBits-1:0] cfg_stop_level_i,
    input logic [                    TimeBits-1:0] cfg_t_end_i,
    input logic                                    cfg_morton_i,
    input logic [(MaxLevel + 1) * AddressBits-1:0] cfg_level_base_i,  // bytes, level 0 in the lowest bits

    input  logic                           in_valid_i,
    output logic                           in_ready_o,
    input  logic        [      IdBits-1:0] in_id_i,
    input  logic                           in_dead_i,
    input  logic        [  MantissaBits:0] in_mx_i,
    input  logic        [  MantissaBits:0] in_my_i,
    input  logic        [  MantissaBits:0] in_mz_i,
    input  logic signed [ ProductBits-1:0] in_ox_i,
    input  logic signed [ ProductBits-1:0] in_oy_i,
    input  logic signed [ ProductBits-1:0] in_oz_i,
    input  logic        [   ShiftBits-1:0] in_ex_i,
    input  logic        [   ShiftBits-1:0] in_ey_i,
    input  logic        [   ShiftBits-1:0] in_ez_i,
    input  logic                           in_still_x_i,
    input  logic                           in_still_y_i,
    input  logic                           in_still_z_i,
    input  logic                           in_flip_x_i,
    input  logic                           in_flip_y_i,
    input  logic                           in_rising_i,
    input  logic        [    TimeBits-1:0] in_t_start_i,
    input  logic        [    TimeBits-1:0] in_t_max_i,
    input  logic        [    TimeBits-1:0] in_t_root_i,
    input  logic        [HmtLevelBits-1:0] in_level_i,
    input  logic signed [   PlaneBits-1:0] in_node_x_i,
    input  logic signed [   PlaneBits-1:0] in_node_y_i,

    output logic                   enable_o,           // the pipe moves
    output logic                   lookup_valid_o,     // lookup, retry and replay: if the pipe moves
    output logic                   lookup_retry_o,     // of the ray at the head of the retry FIFO
    output logic [AddressBits-1:0] lookup_address_o,   // bytes; of a replay too
    output logic [ContextBits-1:0] lookup_context_o,
    input  logic                   lookup_hit_i,
    input  logic                   replay_valid_i,
    output logic                   replay_take_o,
    input  logic [ContextBits-1:0] replay_context_i,
    input  logic                   retry_valid_i,
    input  logic [ContextBits-1:0] retry_context_i,
    input  logic [ HeightBits-1:0] texel_i,            // of the lookup or replay one enabled cycle before

    output logic                           hit_valid_o,
    input  logic                           hit_ready_i,
    output logic        [      IdBits-1:0] hit_id_o,
    output logic                           hit_status_o,  // 0 miss, 1 hit
    output logic        [             2:0] hit_face_o,
    output logic        [HmtLevelBits-1:0] hit_level_o,
    output logic signed [   PlaneBits-1:0] hit_i_o,
    output logic signed [   PlaneBits-1:0] hit_j_o,
    output logic        [    TimeBits-1:0] hit_t_o,
    output logic        [            31:0] hit_steps_o,

    output logic [     IdBits-1:0] slot_id_o,    // the ray at select
    output logic                   slot_step_o,  // what the cycle is if the pipe moves: one of these, a miss, a bubble
    output logic                   slot_dead_o,
    output logic                   stalled_o,
    output logic                   full_o,       // every context is resident
    output logic [ContextBits:0]   resident_o
);

  localparam int WriteBack = 6;
  localparam int TexelShift = (HeightBits > 8) ? 1 : 0;
  localparam int LineBits = 1 + ShiftBits + MantissaBits + 1 + ProductBits;
  localparam int PlaceBits = HmtLevelBits + 2 * PlaneBits;
  localparam int CrossedBits = HmtLevelBits + 1;
  localparam int StateBits = 32 + 2 + CrossedBits + 3;

`include "common/plane_time_functions.svh"

  // Product over the breadth of a node.
  function automatic logic signed [ProductBits-1:0] breadth(input logic [MantissaBits:0] mantissa,
                                                            input logic [HmtLevelBits-1:0] level);
    breadth = $signed({{(ProductBits - MantissaBits - 1) {1'b0}}, mantissa}) <<< (FractionBits + 32'(level));
  endfunction

  // The number of the lowest bit that is not set: by halves.
  function automatic logic [ContextBits-1:0] lowest_free(input logic [Contexts-1:0] taken);
    logic [(1<<ContextBits)-1:0] rest;
    rest = {{(1 << ContextBits) {1'b1}}} << Contexts;
    rest[Contexts-1:0] = taken;
    for (int unsigned b = 0; b < ContextBits; b++) begin
      lowest_free[ContextBits-1-b] = (~rest & ((1 << (1 << (ContextBits - 1 - b))) - 1)) == '0;
      if (lowest_free[ContextBits-1-b]) rest = rest >> (1 << (ContextBits - 1 - b));
    end
  endfunction

  // ---- Contexts: what a ray brings along (written at entry), and where it is (written in stage 6 too).
  logic [   IdBits-1:0] id_q     [Contexts];
  logic [          2:0] ways_q   [Contexts];  // {flip_x, flip_y, rising}
  logic [ LineBits-1:0] line_x_q [Contexts];  // {still, shift, mantissa, offset}
  logic [ LineBits-1:0] line_y_q [Contexts];
  logic [ LineBits-1:0] line_z_q [Contexts];
  logic [ TimeBits-1:0] t_start_q[Contexts];
  logic [ TimeBits-1:0] t_max_q  [Contexts];
  logic [ TimeBits-1:0] t_root_q [Contexts];
  logic [PlaceBits-1:0] place_q  [Contexts];  // {level, node_x, node_y}
  logic [ TimeBits-1:0] t_cur_q  [Contexts];  // of a ray that has hit: when
  // {steps, down, crossed, face}; crossed: {valid, level of the crossing that the last step was}; face: none, no hit
  logic [StateBits-1:0] state_q  [Contexts];
  logic [ Contexts-1:0] resident_q;
  logic [ContextBits:0] fill_q;

  // ---- The slots: [0] is one cycle past select, [Stages - 1] at select; stage k works on slot k - 1.
  logic [Stages-1:0] slot_valid_q;
  logic [Stages-1:0] slot_ended_q;
  logic [Stages*ContextBits-1:0] slot_context_q;
  logic [WriteBack:1] step_q;  // a step is in stage k

  // ---- 0: select. All but the enable follows from registers: what the slot does if the pipe moves.
  wire [ContextBits-1:0] select_context = slot_context_q[(Stages-1)*ContextBits+:ContextBits];
  wire ended = slot_valid_q[Stages-1] & slot_ended_q[Stages-1];
  wire goes_on = slot_valid_q[Stages-1] & ~slot_ended_q[Stages-1];
  wire replay = ~goes_on & replay_valid_i;
  wire retry = ~goes_on & ~replay_valid_i & retry_valid_i;
  wire room = ended | (fill_q != (ContextBits + 1)'(Contexts));
  wire takes_new = ~goes_on & ~replay_valid_i & ~retry_valid_i & room;
  wire fresh = takes_new & in_valid_i;
  wire fresh_dead = fresh & in_dead_i;
  wire enable = ~ended | hit_ready_i;
  wire issues = goes_on | replay | retry | (fresh & ~in_dead_i);

  logic [ContextBits-1:0] context_0;
  always_comb begin
    context_0 = select_context;  // of the ray that goes on, or of the one that completes
    if (replay) context_0 = replay_context_i;
    else if (retry) context_0 = retry_context_i;
    else if (fresh && !ended) context_0 = lowest_free(resident_q);
  end

  // Node to address: the fetch index, then row-major or Morton order within the level.
  logic [HmtLevelBits-1:0] level_0, bits_0;
  logic [MaxLevel-1:0] node_x_0, node_y_0;  // wrapped
  logic flip_x_0, flip_y_0;
  logic [MaxLevel-1:0] mask_0, i_0, j_0;
  logic [2*MaxLevel-1:0] index_0;
  logic [PlaceBits-1:0] place_0;
  always_comb begin
    place_0 = '0;
    level_0 = '0;
    {node_x_0, node_y_0} = '0;
    {flip_x_0, flip_y_0} = 2'b00;
    bits_0 = '0;
    mask_0 = '0;
    {i_0, j_0} = '0;
    index_0 = '0;
    lookup_address_o = '0;
    if (issues) begin
      place_0 = fresh ? {in_level_i, in_node_x_i, in_node_y_i} : place_q[context_0];
      {flip_x_0, flip_y_0} = fresh ? {in_flip_x_i, in_flip_y_i} : ways_q[context_0][2:1];
      level_0 = place_0[PlaceBits-1-:HmtLevelBits];
      node_x_0 = place_0[PlaneBits+:MaxLevel];
      node_y_0 = place_0[0+:MaxLevel];
      bits_0 = cfg_root_level_i - level_0;
      mask_0 = ~({MaxLevel{1'b1}} << bits_0);
      i_0 = (node_x_0 ^ {MaxLevel{flip_x_0}}) & mask_0;
      j_0 = (node_y_0 ^ {MaxLevel{flip_y_0}}) & mask_0;
      if (cfg_morton_i) begin
        for (int unsigned b = 0; b < MaxLevel; b++) begin
          index_0[2*b] = i_0[b];
          index_0[2*b+1] = j_0[b];
        end
      end else begin
        index_0 = ({{MaxLevel{1'b0}}, j_0} << bits_0) | {{MaxLevel{1'b0}}, i_0};
      end
      lookup_address_o = cfg_level_base_i[level_0*AddressBits+:AddressBits] + (AddressBits'(index_0) << TexelShift);
    end
  end
  assign lookup_context_o = context_0;
  assign lookup_valid_o = goes_on | retry | (fresh & ~in_dead_i);
  assign lookup_retry_o = retry;
  assign replay_take_o = replay;
  assign enable_o = enable;
  assign in_ready_o = enable & takes_new;
  wire step_0 = replay | (lookup_valid_o & lookup_hit_i);

  assign slot_id_o = fresh ? in_id_i : id_q[context_0];
  assign slot_step_o = step_0;
  assign slot_dead_o = fresh_dead;
  assign stalled_o = ~enable;
  assign full_o = ~room;
  assign resident_o = fill_q;

  // ---- 1: the texel
  logic [PlaceBits-1:0] place_1_q;

  // ---- 2: products of the exit planes and the texel
  logic [PlaceBits-1:0] place_2_q;
  logic [HeightBits-1:0] bound_2_q;

  // ---- 3: their times
  logic [PlaceBits-1:0] place_3_q;
  logic signed [ProductBits-1:0] px_3_q, py_3_q, pz_3_q;

  // ---- 4: hit, skip, cross
  logic [PlaceBits-1:0] place_4_q;
  logic signed [ProductBits-1:0] px_4_q, py_4_q;
  logic [TimeBits-1:0] t_x_4_q, t_y_4_q, t_z_4_q;
  logic before_z_4_q;                           // the texel's time is negative
  logic [TimeBits-1:0] enter_t_x_4_q, enter_t_y_4_q;  // of a leaf
  logic before_x_4_q, before_y_4_q;

  // ---- 5: next node and level
  logic [HmtLevelBits-1:0] level_5_q;
  logic signed [PlaneBits-1:0] node_x_5_q, node_y_5_q;  // after crossing or descending
  logic signed [ProductBits-1:0] px_5_q, py_5_q;        // exit planes of the child, or of the node crossed into
  logic hits_5_q, skip_5_q, cross_x_5_q, cross_y_5_q;
  logic [2:0] face_5_q;                // of a hit
  logic [TimeBits-1:0] t_5_q;          // t_cur after the step, or when it hit
  logic [TimeBits-1:0] beyond_5_q;     // when the ray is out of the node that it skips and below its bound

  // ---- 6: further descents, write back
  logic [HmtLevelBits-1:0] level_6_q;
  logic signed [PlaneBits-1:0] node_x_6_q, node_y_6_q;
  logic signed [ProductBits-1:0] px_6_q, py_6_q;
  logic hits_6_q, misses_6_q, further_6_q, further_twice_6_q;
  logic [1:0] down_6_q;
  logic [CrossedBits-1:0] crossed_6_q;
  logic [2:0] face_6_q;
  logic [TimeBits-1:0] t_6_q;

  // ---- The stages. Each computes only while a step is in it.
  task automatic do_stage_2;
    logic [ContextBits-1:0] ray;
    logic [MantissaBits:0] mx, my, mz;
    logic signed [ProductBits-1:0] ox, oy, oz, rise;
    logic [HmtLevelBits-1:0] level;
    logic signed [PlaneBits-1:0] node_x, node_y;
    ray = slot_context_q[1*ContextBits+:ContextBits];
    {mx, ox} = line_x_q[ray][MantissaBits+ProductBits:0];
    {my, oy} = line_y_q[ray][MantissaBits+ProductBits:0];
    {mz, oz} = line_z_q[ray][MantissaBits+ProductBits:0];
    {level, node_x, node_y} = place_2_q;
    place_3_q <= place_2_q;
    px_3_q <= product((ProductBits'(node_x) + ProductBits'(1)) <<< level, mx, ox);
    py_3_q <= product((ProductBits'(node_y) + ProductBits'(1)) <<< level, my, oy);
    rise = product($signed(ProductBits'({1'b0, bound_2_q})), mz, oz);
    pz_3_q <= ways_q[ray][0] ? rise : -rise;
  endtask

  task automatic do_stage_3;
    logic [ContextBits-1:0] ray;
    logic still_x, still_y, still_z;
    logic [ShiftBits-1:0] ex, ey, ez;
    logic [MantissaBits:0] mx, my;
    logic signed [ProductBits-1:0] enter_x, enter_y;
    logic [HmtLevelBits-1:0] level;
    ray = slot_context_q[2*ContextBits+:ContextBits];
    {still_x, ex, mx} = line_x_q[ray][LineBits-1:ProductBits];
    {still_y, ey, my} = line_y_q[ray][LineBits-1:ProductBits];
    {still_z, ez} = line_z_q[ray][LineBits-1-:ShiftBits+1];
    level = place_3_q[PlaceBits-1-:HmtLevelBits];
    place_4_q <= place_3_q;
    px_4_q <= px_3_q;
    py_4_q <= py_3_q;
    t_x_4_q <= time_of(px_3_q, still_x, ex, cfg_t_end_i);
    t_y_4_q <= time_of(py_3_q, still_y, ey, cfg_t_end_i);
    t_z_4_q <= time_of(pz_3_q, still_z, ez, cfg_t_end_i);
    before_z_4_q <= pz_3_q[ProductBits-1];
    if (level == cfg_stop_level_i) begin
      enter_x = px_3_q - breadth(mx, level);
      enter_y = py_3_q - breadth(my, level);
      enter_t_x_4_q <= time_of(enter_x, still_x, ex, cfg_t_end_i);
      enter_t_y_4_q <= time_of(enter_y, still_y, ey, cfg_t_end_i);
      before_x_4_q <= enter_x[ProductBits-1];
      before_y_4_q <= enter_y[ProductBits-1];
    end
  endtask

  task automatic do_stage_4;
    logic [ContextBits-1:0] ray;
    logic rising, leaf, hits, skip, cross_x, cross_y, still_x, still_y, upper_x, upper_y;
    logic [ShiftBits-1:0] ex, ey;
    logic [MantissaBits:0] mx, my;
    logic [TimeBits-1:0] t_cur, t_out, reached, t_in, t_start, t_hit;
    logic signed [ProductBits-1:0] breadth_x, breadth_y;
    logic [HmtLevelBits-1:0] level;
    logic signed [PlaneBits-1:0] node_x, node_y;
    ray = slot_context_q[3*ContextBits+:ContextBits];
    {still_x, ex, mx} = line_x_q[ray][LineBits-1:ProductBits];
    {still_y, ey, my} = line_y_q[ray][LineBits-1:ProductBits];
    {level, node_x, node_y} = place_4_q;
    breadth_x = breadth(mx, level);
    breadth_y = breadth(my, level);
    rising = ways_q[ray][0];
    t_cur = t_cur_q[ray];
    t_out = (t_x_4_q < t_y_4_q) ? t_x_4_q : t_y_4_q;
    reached = rising ? t_cur : later(t_cur, t_z_4_q);
    leaf = level == cfg_stop_level_i;
    skip = leaf | (rising ? (t_z_4_q <= t_cur) : (reached >= t_out));
    hits = 1'b0;
    t_hit = '0;
    if (leaf) begin
      t_start = t_start_q[ray];
      t_in = later(t_start, later(enter_t_x_4_q, enter_t_y_4_q));
      t_hit = rising ? t_in : later(t_in, t_z_4_q);
      hits = (t_hit < t_out) & (t_hit < t_max_q[ray]) & (~rising | (~before_z_4_q & (t_in < t_z_4_q)));
      if (~rising & ~before_z_4_q & (t_z_4_q >= t_in)) begin
        face_5_q <= HmtFaceTop;
      end else if ((before_x_4_q | (enter_t_x_4_q < t_start)) & (before_y_4_q | (enter_t_y_4_q < t_start))) begin
        face_5_q <= HmtFaceInside;
      end else if (~before_x_4_q & (before_y_4_q | (enter_t_x_4_q >= enter_t_y_4_q))) begin
        face_5_q <= HmtFaceWallX;
      end else begin
        face_5_q <= HmtFaceWallY;
      end
    end
    level_5_q <= level;
    hits_5_q <= hits;
    skip_5_q <= skip;
    if (skip) begin
      cross_x = t_x_4_q == t_out;
      cross_y = t_y_4_q == t_out;
      cross_x_5_q <= cross_x;
      cross_y_5_q <= cross_y;
      t_5_q <= hits ? t_hit : t_out;
      beyond_5_q <= later(t_out, t_z_4_q);
      node_x_5_q <= (cross_x & ~hits) ? node_x + PlaneBits'(1) : node_x;
      node_y_5_q <= (cross_y & ~hits) ? node_y + PlaneBits'(1) : node_y;
      px_5_q <= cross_x ? px_4_q + breadth_x : px_4_q;
      py_5_q <= cross_y ? py_4_q + breadth_y : py_4_q;
    end else begin
      // Half the breadth of the node, for the plane in its middle.
      upper_x = at_most(px_4_q - (breadth_x >>> 1), still_x, ex, reached);
      upper_y = at_most(py_4_q - (breadth_y >>> 1), still_y, ey, reached);
      t_5_q <= reached;
      node_x_5_q <= {node_x[PlaneBits-2:0], upper_x};
      node_y_5_q <= {node_y[PlaneBits-2:0], upper_y};
      px_5_q <= upper_x ? px_4_q : px_4_q - (breadth_x >>> 1);
      py_5_q <= upper_y ? py_4_q : py_4_q - (breadth_y >>> 1);
    end
  endtask

  // Whether the ray is out of the node that it crosses into, too, when it is below the bound of the one it leaves.
  function automatic logic neighbour_skipped(input logic [ContextBits-1:0] ray);
    logic still_x, still_y;
    logic [ShiftBits-1:0] ex, ey;
    {still_x, ex} = line_x_q[ray][LineBits-1-:ShiftBits+1];
    {still_y, ey} = line_y_q[ray][LineBits-1-:ShiftBits+1];
    neighbour_skipped = ways_q[ray][0] | (beyond_5_q >= time_of(px_5_q, still_x, ex, cfg_t_end_i)) |
        (beyond_5_q >= time_of(py_5_q, still_y, ey, cfg_t_end_i));
  endfunction

  task automatic do_stage_5;
    logic [ContextBits-1:0] ray;
    logic even_axis, rule, outside, further;
    logic [1:0] down;
    logic [CrossedBits-1:0] crossed;
    logic signed [PlaneBits-1:0] node_x, node_y;
    logic [HmtLevelBits-1:0] level, side_bits;
    ray = slot_context_q[4*ContextBits+:ContextBits];
    {down, crossed} = state_q[ray][3+:CrossedBits+2];
    node_x = node_x_5_q;
    node_y = node_y_5_q;
    level = level_5_q;
    further = 1'b0;
    hits_6_q <= hits_5_q;
    face_6_q <= hits_5_q ? face_5_q : HmtFaceNone;
    t_6_q <= t_5_q;
    crossed_6_q <= {skip_5_q, level_5_q};
    if (skip_5_q) begin
      rule = 1'b0;
      if (!hits_5_q && level_5_q < cfg_root_level_i) begin
        even_axis = (cross_x_5_q & ~node_x_5_q[0]) | (cross_y_5_q & ~node_y_5_q[0]);
        case (cfg_up_i)
          HmtUpAlways: rule = 1'b1;
          HmtUpInterval: rule = ~level_5_q[0];
          HmtUpEvenAxis: rule = even_axis;
          HmtUpBothEven: rule = ~node_x_5_q[0] & ~node_y_5_q[0];
          HmtUpSelective: rule = neighbour_skipped(ray);
          HmtUpSelectiveEven: if (even_axis) rule = neighbour_skipped(ray);
          HmtUpCoherent: rule = crossed == {1'b1, level_5_q};
          default: rule = 1'b0;
        endcase
      end
      if (rule) begin
        node_x = node_x_5_q >>> 1;
        node_y = node_y_5_q >>> 1;
        level = level_5_q + 1'b1;
      end
      down_6_q <= 2'd1;
    end else begin
      level = level_5_q - 1'b1;
      // Levels below the stop level are never entered.
      further = (down > 2'd1) & (level > cfg_stop_level_i);
      further_twice_6_q <= (down > 2'd2) & (level > cfg_stop_level_i + 1'b1);
      down_6_q <= down;
      px_6_q <= px_5_q;
      py_6_q <= py_5_q;
    end
    outside = 1'b0;
    if (cfg_border_i) begin
      side_bits = cfg_root_level_i - level;
      outside = ((node_x >>> side_bits) != '0) | ((node_y >>> side_bits) != '0);
    end
    misses_6_q <= (t_5_q >= t_max_q[ray]) | (ways_q[ray][0] & (t_root_q[ray] <= t_5_q)) | outside;
    level_6_q <= level;
    node_x_6_q <= node_x;
    node_y_6_q <= node_y;
    further_6_q <= further;
  endtask

  task automatic do_stage_6;
    logic still_x, still_y, upper_x, upper_y;
    logic [ShiftBits-1:0] ex, ey;
    logic [MantissaBits:0] mx, my;
    logic signed [ProductBits-1:0] px, py, half_x, half_y;
    logic signed [PlaneBits-1:0] node_x, node_y;
    logic [HmtLevelBits-1:0] level;
    logic [ContextBits-1:0] ray;
    ray = slot_context_q[5*ContextBits+:ContextBits];
    level = level_6_q;
    node_x = node_x_6_q;
    node_y = node_y_6_q;
    if (further_6_q) begin
      {still_x, ex, mx} = line_x_q[ray][LineBits-1:ProductBits];
      {still_y, ey, my} = line_y_q[ray][LineBits-1:ProductBits];
      half_x = breadth(mx, level_6_q) >>> 1;
      half_y = breadth(my, level_6_q) >>> 1;
      upper_x = at_most(px_6_q - half_x, still_x, ex, t_6_q);
      upper_y = at_most(py_6_q - half_y, still_y, ey, t_6_q);
      level = level_6_q - 1'b1;
      node_x = {node_x[PlaneBits-2:0], upper_x};
      node_y = {node_y[PlaneBits-2:0], upper_y};
      if (further_twice_6_q) begin
        px = upper_x ? px_6_q : px_6_q - half_x;
        py = upper_y ? py_6_q : py_6_q - half_y;
        upper_x = at_most(px - (half_x >>> 1), still_x, ex, t_6_q);
        upper_y = at_most(py - (half_y >>> 1), still_y, ey, t_6_q);
        level = level_6_q - HmtLevelBits'(2);
        node_x = {node_x[PlaneBits-2:0], upper_x};
        node_y = {node_y[PlaneBits-2:0], upper_y};
      end
    end
    place_q[ray] <= {level, node_x, node_y};
    t_cur_q[ray] <= t_6_q;
    state_q[ray] <= {state_q[ray][StateBits-1-:32] + 32'd1, down_6_q, crossed_6_q, face_6_q};
  endtask

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      slot_valid_q <= '0;
      slot_ended_q <= '0;
      resident_q <= '0;
      fill_q <= '0;
      step_q <= '0;
    end else if (enable) begin
      slot_valid_q <= {slot_valid_q[Stages-2:0], step_0 | fresh_dead};
      slot_ended_q <= {slot_ended_q[Stages-2:0], fresh_dead};
      if (step_q[WriteBack]) slot_ended_q[WriteBack] <= hits_6_q | misses_6_q;
      // From the last on: each reads what the one before has written a cycle ago.
      if (step_q[6]) do_stage_6();
      if (step_q[5]) do_stage_5();
      if (step_q[4]) do_stage_4();
      if (step_q[3]) do_stage_3();
      if (step_q[2]) do_stage_2();
      if (step_q[1]) begin
        place_2_q <= place_1_q;
        bound_2_q <= texel_i;
      end
      if (step_0) place_1_q <= place_0;
      if (fresh) begin
        id_q[context_0] <= in_id_i;
        ways_q[context_0] <= {in_flip_x_i, in_flip_y_i, in_rising_i};
        line_x_q[context_0] <= {in_still_x_i, in_ex_i, in_mx_i, in_ox_i};
        line_y_q[context_0] <= {in_still_y_i, in_ey_i, in_my_i, in_oy_i};
        line_z_q[context_0] <= {in_still_z_i, in_ez_i, in_mz_i, in_oz_i};
        t_start_q[context_0] <= in_t_start_i;
        t_max_q[context_0] <= in_t_max_i;
        t_root_q[context_0] <= in_t_root_i;
        place_q[context_0] <= {in_level_i, in_node_x_i, in_node_y_i};
        t_cur_q[context_0] <= in_t_start_i;
        state_q[context_0] <= {32'd0, cfg_down_i, {CrossedBits{1'b0}}, HmtFaceNone};
      end
      if (fresh != ended) fill_q <= fresh ? fill_q + 1'b1 : fill_q - 1'b1;
      if (ended) resident_q[select_context] <= 1'b0;
      if (fresh) resident_q[context_0] <= 1'b1;
      slot_context_q <= {slot_context_q[(Stages-1)*ContextBits-1:0], context_0};
      step_q <= {step_q[WriteBack-1:1], step_0};
    end
  end

  // ---- The hit stream, zeros while no ray has ended. The cell is in the map's own frame, unwrapped.
  logic [HmtLevelBits-1:0] end_level;
  logic signed [PlaneBits-1:0] end_x, end_y, last_node;
  assign hit_valid_o = ended;
  always_comb begin
    hit_id_o = '0;
    hit_status_o = 1'b0;
    hit_face_o = HmtFaceNone;
    hit_level_o = '0;
    hit_i_o = '0;
    hit_j_o = '0;
    hit_t_o = '0;
    hit_steps_o = '0;
    {end_level, end_x, end_y} = '0;
    last_node = '0;
    if (ended) begin
      hit_id_o = id_q[select_context];
      hit_steps_o = state_q[select_context][StateBits-1-:32];
      hit_face_o = state_q[select_context][2:0];
      if (hit_face_o != HmtFaceNone) begin
        {end_level, end_x, end_y} = place_q[select_context];
        last_node = (PlaneBits'(1) << (cfg_root_level_i - end_level)) - PlaneBits'(1);
        hit_status_o = 1'b1;
        hit_level_o = end_level;
        hit_i_o = ways_q[select_context][2] ? last_node - end_x : end_x;
        hit_j_o = ways_q[select_context][1] ? last_node - end_y : end_y;
        hit_t_o = t_cur_q[select_context];
      end
    end
  end

endmodule
