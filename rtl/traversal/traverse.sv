// traverse: one step of one ray per cycle, in a rigid pipe of Stages slots that go round.
//
// Ports: contexts from ray_setup (valid/ready), lookups to height_l1 and its answer in the same cycle, replays and
// retries from height_l1, hit stream out (valid/ready). All but the choice within a cycle are registered.
// Timing: the slot at select holds a ray that has ended (it leaves by the hit stream; while that is not ready the
// whole pipe stands still), a ray that goes on (its texel is looked up), or nothing: then the first that can takes
// it: a replay, a retry, a new ray while fewer than Contexts are resident. A step is done when the slot is at
// select again, Stages cycles later; a ray whose lookup misses is parked and leaves the slot empty.
//   0 select, address, lookup | 1 products of the exit planes; the texel | 2 their times; product of the texel
//   3 time of the texel | 4 hit, skip, cross | 5 next node and level | 6 further descents, write back

`include "traversal/traverse_types.svh"

module traverse #(
    parameter int MaxLevel = 10,
    parameter int HeightBits = 8,
    parameter int FractionBits = 8,
    parameter int DirectionBits = 32,
    parameter int MantissaBits = 12,
    parameter int TileBits = 4,
    parameter int IdBits = 32,
    parameter int Stages = 8,
    parameter int Contexts = 32,
    parameter int AddressBits = 24,
    // Widths that follow.
    parameter int IndexBits = MaxLevel + TileBits,
    parameter int PlaneBits = IndexBits + 3,
    parameter int SpaceBits = (IndexBits + 2 > HeightBits + 1) ? IndexBits + 2 : HeightBits + 1,
    parameter int ProductBits = SpaceBits + FractionBits + MantissaBits + 2,
    parameter int TimeBits =
        ((IndexBits > HeightBits) ? IndexBits : HeightBits) + FractionBits + MantissaBits,
    parameter int ShiftBits = $clog2(DirectionBits),
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
    output logic                   lookup_valid_o,
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
    output logic                   slot_step_o,  // what the cycle was, one of these or a miss or a bubble
    output logic                   slot_dead_o,
    output logic                   stalled_o,
    output logic                   bubble_o,
    output logic                   full_o,       // every context is resident
    output logic [ContextBits:0]   resident_o
);

  localparam int WriteBack = 6;
  localparam int TexelShift = (HeightBits > 8) ? 1 : 0;

`include "traversal/line_functions.svh"

  // ---- Contexts: what a ray brings along, and where it is. Written at entry and in stage 6.
  logic        [      IdBits-1:0] id_q      [Contexts];
  logic        [  MantissaBits:0] mx_q      [Contexts];
  logic        [  MantissaBits:0] my_q      [Contexts];
  logic        [  MantissaBits:0] mz_q      [Contexts];
  logic signed [ ProductBits-1:0] ox_q      [Contexts];
  logic signed [ ProductBits-1:0] oy_q      [Contexts];
  logic signed [ ProductBits-1:0] oz_q      [Contexts];
  logic        [   ShiftBits-1:0] ex_q      [Contexts];
  logic        [   ShiftBits-1:0] ey_q      [Contexts];
  logic        [   ShiftBits-1:0] ez_q      [Contexts];
  logic                           still_x_q [Contexts];
  logic                           still_y_q [Contexts];
  logic                           still_z_q [Contexts];
  logic                           flip_x_q  [Contexts];
  logic                           flip_y_q  [Contexts];
  logic                           rising_q  [Contexts];
  logic        [    TimeBits-1:0] t_start_q [Contexts];
  logic        [    TimeBits-1:0] t_max_q   [Contexts];
  logic        [    TimeBits-1:0] t_root_q  [Contexts];
  logic        [HmtLevelBits-1:0] level_q   [Contexts];
  logic signed [   PlaneBits-1:0] node_x_q  [Contexts];
  logic signed [   PlaneBits-1:0] node_y_q  [Contexts];
  logic        [    TimeBits-1:0] t_cur_q   [Contexts];  // of a ray that has hit: when
  logic        [             1:0] down_q    [Contexts];
  logic        [  HmtLevelBits:0] crossed_q [Contexts];  // {valid, level of the crossing that the last step was}
  logic        [            31:0] steps_q   [Contexts];
  logic        [             2:0] face_q    [Contexts];  // none: no hit
  logic        [    Contexts-1:0] resident_q;
  logic        [   ContextBits:0] fill_q;

  // ---- The slots: [0] is one cycle past select, [Stages - 1] at select.
  logic [Stages-1:0] slot_valid_q;
  logic [Stages-1:0] slot_ended_q;
  logic [ContextBits-1:0] slot_context_q[Stages];

  // ---- 0: select
  wire [ContextBits-1:0] select_context = slot_context_q[Stages-1];
  wire ended = slot_valid_q[Stages-1] & slot_ended_q[Stages-1];
  wire goes_on = slot_valid_q[Stages-1] & ~slot_ended_q[Stages-1];
  wire completes = ended & hit_ready_i;
  wire enable = ~ended | hit_ready_i;
  wire empty_slot = enable & ~goes_on;
  wire replay = empty_slot & replay_valid_i;
  wire retry = empty_slot & ~replay_valid_i & retry_valid_i;
  wire room = completes | (fill_q != (ContextBits + 1)'(Contexts));
  assign in_ready_o = empty_slot & ~replay_valid_i & ~retry_valid_i & room;
  wire fresh = in_ready_o & in_valid_i;
  wire fresh_dead = fresh & in_dead_i;

  logic [ContextBits-1:0] free_context;
  always_comb begin
    free_context = select_context;  // of the ray that completes
    for (int unsigned k = 0; k < Contexts; k++) begin
      if (!completes && !resident_q[Contexts-1-k]) free_context = ContextBits'(Contexts - 1 - k);
    end
  end

  wire [ContextBits-1:0] context_0 =
      goes_on ? select_context : replay ? replay_context_i : retry ? retry_context_i : free_context;
  wire [HmtLevelBits-1:0] level_0 = fresh ? in_level_i : level_q[context_0];
  wire signed [PlaneBits-1:0] node_x_0 = fresh ? in_node_x_i : node_x_q[context_0];
  wire signed [PlaneBits-1:0] node_y_0 = fresh ? in_node_y_i : node_y_q[context_0];
  wire flip_x_0 = fresh ? in_flip_x_i : flip_x_q[context_0];
  wire flip_y_0 = fresh ? in_flip_y_i : flip_y_q[context_0];

  // Node to address: the fetch index, then row-major or Morton order within the level.
  logic [HmtLevelBits-1:0] bits_0;
  logic [MaxLevel-1:0] mask_0, i_0, j_0;
  logic [2*MaxLevel-1:0] index_0;
  always_comb begin
    bits_0 = cfg_root_level_i - level_0;
    mask_0 = ~({MaxLevel{1'b1}} << bits_0);
    i_0 = (node_x_0[MaxLevel-1:0] ^ {MaxLevel{flip_x_0}}) & mask_0;
    j_0 = (node_y_0[MaxLevel-1:0] ^ {MaxLevel{flip_y_0}}) & mask_0;
    index_0 = ({{MaxLevel{1'b0}}, j_0} << bits_0) | {{MaxLevel{1'b0}}, i_0};
    if (cfg_morton_i) begin
      for (int unsigned b = 0; b < MaxLevel; b++) begin
        index_0[2*b] = i_0[b];
        index_0[2*b+1] = j_0[b];
      end
    end
  end
  assign lookup_address_o = cfg_level_base_i[level_0*AddressBits+:AddressBits] +
      (AddressBits'(index_0) << TexelShift);
  assign lookup_context_o = context_0;
  assign lookup_valid_o = goes_on | retry | (fresh & ~in_dead_i);
  assign lookup_retry_o = retry;
  assign replay_take_o = replay;
  assign enable_o = enable;
  wire step_0 = replay | (lookup_valid_o & lookup_hit_i);

  assign slot_id_o = fresh ? in_id_i : id_q[context_0];
  assign slot_step_o = step_0;
  assign slot_dead_o = fresh_dead;
  assign stalled_o = ~enable;
  assign bubble_o = empty_slot & ~replay & ~retry & ~fresh;
  assign full_o = ~room;
  assign resident_o = fill_q;

  // ---- 1: products of the exit planes
  logic step_1_q;
  logic [ContextBits-1:0] context_1_q;
  logic [HmtLevelBits-1:0] level_1_q;
  logic signed [PlaneBits-1:0] node_x_1_q, node_y_1_q;
  wire signed [ProductBits-1:0] exit_x_1 = (ProductBits'(node_x_1_q) + ProductBits'(1)) <<< level_1_q;
  wire signed [ProductBits-1:0] exit_y_1 = (ProductBits'(node_y_1_q) + ProductBits'(1)) <<< level_1_q;

  // ---- 2: times of planes, product of the texel
  logic step_2_q;
  logic [ContextBits-1:0] context_2_q;
  logic [HmtLevelBits-1:0] level_2_q;
  logic signed [PlaneBits-1:0] node_x_2_q, node_y_2_q;
  logic signed [ProductBits-1:0] px_2_q, py_2_q;
  logic [HeightBits-1:0] bound_2_q;
  // Products over the breadth of a node: from the exit plane to the planes of entry and of the next node's exit.
  wire signed [ProductBits-1:0] breadth_x_2 =
      $signed(ProductBits'({1'b0, mx_q[context_2_q]})) <<< (FractionBits + 32'(level_2_q));
  wire signed [ProductBits-1:0] breadth_y_2 =
      $signed(ProductBits'({1'b0, my_q[context_2_q]})) <<< (FractionBits + 32'(level_2_q));
  wire signed [ProductBits-1:0] enter_x_2 = px_2_q - breadth_x_2;
  wire signed [ProductBits-1:0] enter_y_2 = py_2_q - breadth_y_2;
  wire signed [ProductBits-1:0] rise_2 =
      product($signed(ProductBits'({1'b0, bound_2_q})), mz_q[context_2_q], oz_q[context_2_q]);

  // ---- 3: time of the texel
  logic step_3_q;
  logic [ContextBits-1:0] context_3_q;
  logic [HmtLevelBits-1:0] level_3_q;
  logic signed [PlaneBits-1:0] node_x_3_q, node_y_3_q;
  logic signed [ProductBits-1:0] px_3_q, py_3_q, pz_3_q;
  logic [TimeBits-1:0] t_x_3_q, t_y_3_q, enter_t_x_3_q, enter_t_y_3_q, next_t_x_3_q, next_t_y_3_q;
  logic before_x_3_q, before_y_3_q;  // the entry plane's time is negative

  // ---- 4: hit, skip, cross
  logic step_4_q;
  logic [ContextBits-1:0] context_4_q;
  logic [HmtLevelBits-1:0] level_4_q;
  logic signed [PlaneBits-1:0] node_x_4_q, node_y_4_q;
  logic signed [ProductBits-1:0] px_4_q, py_4_q;
  logic [TimeBits-1:0] t_x_4_q, t_y_4_q, t_z_4_q, enter_t_x_4_q, enter_t_y_4_q, next_t_x_4_q, next_t_y_4_q;
  logic before_x_4_q, before_y_4_q, before_z_4_q;
  wire rising_4 = rising_q[context_4_q];
  wire [TimeBits-1:0] t_cur_4 = t_cur_q[context_4_q];
  wire [TimeBits-1:0] t_start_4 = t_start_q[context_4_q];
  wire [TimeBits-1:0] t_max_4 = t_max_q[context_4_q];
  wire [TimeBits-1:0] t_out_4 = (t_x_4_q < t_y_4_q) ? t_x_4_q : t_y_4_q;
  wire [TimeBits-1:0] reached_4 = rising_4 ? t_cur_4 : later(t_cur_4, t_z_4_q);
  wire leaf_4 = level_4_q == cfg_stop_level_i;
  wire [TimeBits-1:0] t_in_4 = later(t_start_4, later(enter_t_x_4_q, enter_t_y_4_q));
  wire [TimeBits-1:0] t_hit_4 = rising_4 ? t_in_4 : later(t_in_4, t_z_4_q);
  wire hits_4 = leaf_4 & (t_hit_4 < t_out_4) & (t_hit_4 < t_max_4) &
      (~rising_4 | (~before_z_4_q & (t_in_4 < t_z_4_q)));
  wire top_4 = ~rising_4 & ~before_z_4_q & (t_z_4_q >= t_in_4);
  wire walls_4 = (~before_x_4_q & (enter_t_x_4_q >= t_start_4)) | (~before_y_4_q & (enter_t_y_4_q >= t_start_4));
  wire wall_x_4 = ~before_x_4_q & (before_y_4_q | (enter_t_x_4_q >= enter_t_y_4_q));
  wire [2:0] face_4 = top_4 ? HmtFaceTop : ~walls_4 ? HmtFaceInside : wall_x_4 ? HmtFaceWallX : HmtFaceWallY;
  wire skip_4 = leaf_4 | (rising_4 ? (t_z_4_q <= t_cur_4) : (reached_4 >= t_out_4));
  wire cross_x_4 = skip_4 & (t_x_4_q == t_out_4);
  wire cross_y_4 = skip_4 & (t_y_4_q == t_out_4);
  wire [TimeBits-1:0] next_x_4 = cross_x_4 ? next_t_x_4_q : t_x_4_q;
  wire [TimeBits-1:0] next_y_4 = cross_y_4 ? next_t_y_4_q : t_y_4_q;
  wire [TimeBits-1:0] beyond_4 = later(t_out_4, t_z_4_q);
  wire neighbour_skipped_4 = rising_4 | (beyond_4 >= next_x_4) | (beyond_4 >= next_y_4);
  // Half the breadth of the node, for the plane in its middle.
  wire signed [ProductBits-1:0] half_x_4 =
      ($signed(ProductBits'({1'b0, mx_q[context_4_q]})) <<< (FractionBits + 32'(level_4_q))) >>> 1;
  wire signed [ProductBits-1:0] half_y_4 =
      ($signed(ProductBits'({1'b0, my_q[context_4_q]})) <<< (FractionBits + 32'(level_4_q))) >>> 1;
  wire upper_x_4 = at_most(px_4_q - half_x_4, still_x_q[context_4_q], ex_q[context_4_q], reached_4);
  wire upper_y_4 = at_most(py_4_q - half_y_4, still_y_q[context_4_q], ey_q[context_4_q], reached_4);

  // ---- 5: next node and level
  logic step_5_q;
  logic [ContextBits-1:0] context_5_q;
  logic [HmtLevelBits-1:0] level_5_q;
  logic signed [PlaneBits-1:0] node_x_5_q, node_y_5_q;  // after crossing or descending
  logic signed [ProductBits-1:0] px_5_q, py_5_q;        // exit planes of the child
  logic hits_5_q, skip_5_q, cross_x_5_q, cross_y_5_q, neighbour_skipped_5_q;
  logic [2:0] face_5_q;
  logic [TimeBits-1:0] t_5_q;  // t_cur after the step, or when it hit
  wire even_axis_5 = (cross_x_5_q & ~node_x_5_q[0]) | (cross_y_5_q & ~node_y_5_q[0]);
  logic rule_5;
  always_comb begin
    case (cfg_up_i)
      HmtUpAlways: rule_5 = 1'b1;
      HmtUpInterval: rule_5 = ~level_5_q[0];
      HmtUpEvenAxis: rule_5 = even_axis_5;
      HmtUpBothEven: rule_5 = ~node_x_5_q[0] & ~node_y_5_q[0];
      HmtUpSelective: rule_5 = neighbour_skipped_5_q;
      HmtUpSelectiveEven: rule_5 = even_axis_5 & neighbour_skipped_5_q;
      HmtUpCoherent: rule_5 = crossed_q[context_5_q] == {1'b1, level_5_q};
      default: rule_5 = 1'b0;
    endcase
  end
  wire up_5 = skip_5_q & (level_5_q < cfg_root_level_i) & rule_5;
  wire signed [PlaneBits-1:0] node_x_5 = up_5 ? node_x_5_q >>> 1 : node_x_5_q;
  wire signed [PlaneBits-1:0] node_y_5 = up_5 ? node_y_5_q >>> 1 : node_y_5_q;
  wire [HmtLevelBits-1:0] level_5 =
      level_5_q + {{(HmtLevelBits - 1) {1'b0}}, up_5} - {{(HmtLevelBits - 1) {1'b0}}, ~skip_5_q};
  wire [HmtLevelBits-1:0] side_bits_5 = cfg_root_level_i - level_5;
  wire outside_5 = cfg_border_i & (((node_x_5 >>> side_bits_5) != '0) | ((node_y_5 >>> side_bits_5) != '0));
  wire misses_5 = (t_5_q >= t_max_q[context_5_q]) |
      (rising_q[context_5_q] & (t_root_q[context_5_q] <= t_5_q)) | outside_5;
  wire [1:0] down_5 = down_q[context_5_q];
  // Levels below the stop level are never entered.
  wire further_5 = ~skip_5_q & (down_5 > 2'd1) & (level_5 > cfg_stop_level_i);
  wire further_twice_5 = further_5 & (down_5 > 2'd2) & (level_5 > cfg_stop_level_i + 1'b1);

  // ---- 6: further descents, write back
  logic step_6_q;
  logic [ContextBits-1:0] context_6_q;
  logic [HmtLevelBits-1:0] level_6_q;
  logic signed [PlaneBits-1:0] node_x_6_q, node_y_6_q;
  logic signed [ProductBits-1:0] px_6_q, py_6_q;
  logic hits_6_q, misses_6_q, skip_6_q, further_6_q, further_twice_6_q;
  logic [HmtLevelBits-1:0] crossed_6_q;
  logic [2:0] face_6_q;
  logic [TimeBits-1:0] t_6_q;
  wire still_x_6 = still_x_q[context_6_q];
  wire still_y_6 = still_y_q[context_6_q];
  wire [ShiftBits-1:0] ex_6 = ex_q[context_6_q];
  wire [ShiftBits-1:0] ey_6 = ey_q[context_6_q];
  wire signed [ProductBits-1:0] half_x_6 =
      ($signed(ProductBits'({1'b0, mx_q[context_6_q]})) <<< (FractionBits + 32'(level_6_q))) >>> 1;
  wire signed [ProductBits-1:0] half_y_6 =
      ($signed(ProductBits'({1'b0, my_q[context_6_q]})) <<< (FractionBits + 32'(level_6_q))) >>> 1;
  wire upper_x_6 = at_most(px_6_q - half_x_6, still_x_6, ex_6, t_6_q);
  wire upper_y_6 = at_most(py_6_q - half_y_6, still_y_6, ey_6, t_6_q);
  wire signed [ProductBits-1:0] child_px_6 = upper_x_6 ? px_6_q : px_6_q - half_x_6;
  wire signed [ProductBits-1:0] child_py_6 = upper_y_6 ? py_6_q : py_6_q - half_y_6;
  wire upper_again_x_6 = at_most(child_px_6 - (half_x_6 >>> 1), still_x_6, ex_6, t_6_q);
  wire upper_again_y_6 = at_most(child_py_6 - (half_y_6 >>> 1), still_y_6, ey_6, t_6_q);
  logic [HmtLevelBits-1:0] level_6;
  logic signed [PlaneBits-1:0] node_x_6, node_y_6;
  always_comb begin
    level_6 = level_6_q;
    node_x_6 = node_x_6_q;
    node_y_6 = node_y_6_q;
    if (further_6_q) begin
      level_6 = level_6_q - 1'b1;
      node_x_6 = (node_x_6_q <<< 1) | {{(PlaneBits - 1) {1'b0}}, upper_x_6};
      node_y_6 = (node_y_6_q <<< 1) | {{(PlaneBits - 1) {1'b0}}, upper_y_6};
    end
    if (further_twice_6_q) begin
      level_6 = level_6_q - HmtLevelBits'(2);
      node_x_6 = (node_x_6 <<< 1) | {{(PlaneBits - 1) {1'b0}}, upper_again_x_6};
      node_y_6 = (node_y_6 <<< 1) | {{(PlaneBits - 1) {1'b0}}, upper_again_y_6};
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      slot_valid_q <= '0;
      slot_ended_q <= '0;
      resident_q <= '0;
      fill_q <= '0;
      step_1_q <= 1'b0;
      step_2_q <= 1'b0;
      step_3_q <= 1'b0;
      step_4_q <= 1'b0;
      step_5_q <= 1'b0;
      step_6_q <= 1'b0;
    end else if (enable) begin
      fill_q <= fill_q + {{ContextBits{1'b0}}, fresh} - {{ContextBits{1'b0}}, completes};
      if (completes) resident_q[select_context] <= 1'b0;
      if (fresh) resident_q[context_0] <= 1'b1;
      slot_valid_q <= {slot_valid_q[Stages-2:0], step_0 | fresh_dead};
      slot_ended_q <= {slot_ended_q[Stages-2:0], fresh_dead};
      if (step_6_q) slot_ended_q[WriteBack] <= hits_6_q | misses_6_q;
      step_1_q <= step_0;
      step_2_q <= step_1_q;
      step_3_q <= step_2_q;
      step_4_q <= step_3_q;
      step_5_q <= step_4_q;
      step_6_q <= step_5_q;
    end
  end

  always_ff @(posedge clk_i) begin
    if (enable) begin
      slot_context_q[0] <= context_0;
      for (int unsigned s = 1; s < Stages; s++) slot_context_q[s] <= slot_context_q[s-1];

      context_1_q <= context_0;
      level_1_q <= level_0;
      node_x_1_q <= node_x_0;
      node_y_1_q <= node_y_0;

      if (step_1_q) begin
        context_2_q <= context_1_q;
        level_2_q <= level_1_q;
        node_x_2_q <= node_x_1_q;
        node_y_2_q <= node_y_1_q;
        px_2_q <= product(exit_x_1, mx_q[context_1_q], ox_q[context_1_q]);
        py_2_q <= product(exit_y_1, my_q[context_1_q], oy_q[context_1_q]);
        bound_2_q <= texel_i;
      end

      if (step_2_q) begin
        context_3_q <= context_2_q;
        level_3_q <= level_2_q;
        node_x_3_q <= node_x_2_q;
        node_y_3_q <= node_y_2_q;
        px_3_q <= px_2_q;
        py_3_q <= py_2_q;
        pz_3_q <= rising_q[context_2_q] ? rise_2 : -rise_2;
        t_x_3_q <= time_of(px_2_q, still_x_q[context_2_q], ex_q[context_2_q], cfg_t_end_i);
        t_y_3_q <= time_of(py_2_q, still_y_q[context_2_q], ey_q[context_2_q], cfg_t_end_i);
        enter_t_x_3_q <= time_of(enter_x_2, still_x_q[context_2_q], ex_q[context_2_q], cfg_t_end_i);
        enter_t_y_3_q <= time_of(enter_y_2, still_y_q[context_2_q], ey_q[context_2_q], cfg_t_end_i);
        before_x_3_q <= enter_x_2[ProductBits-1];
        before_y_3_q <= enter_y_2[ProductBits-1];
        next_t_x_3_q <= time_of(px_2_q + breadth_x_2, still_x_q[context_2_q], ex_q[context_2_q], cfg_t_end_i);
        next_t_y_3_q <= time_of(py_2_q + breadth_y_2, still_y_q[context_2_q], ey_q[context_2_q], cfg_t_end_i);
      end

      if (step_3_q) begin
        context_4_q <= context_3_q;
        level_4_q <= level_3_q;
        node_x_4_q <= node_x_3_q;
        node_y_4_q <= node_y_3_q;
        px_4_q <= px_3_q;
        py_4_q <= py_3_q;
        t_x_4_q <= t_x_3_q;
        t_y_4_q <= t_y_3_q;
        t_z_4_q <= time_of(pz_3_q, still_z_q[context_3_q], ez_q[context_3_q], cfg_t_end_i);
        before_z_4_q <= pz_3_q[ProductBits-1];
        enter_t_x_4_q <= enter_t_x_3_q;
        enter_t_y_4_q <= enter_t_y_3_q;
        before_x_4_q <= before_x_3_q;
        before_y_4_q <= before_y_3_q;
        next_t_x_4_q <= next_t_x_3_q;
        next_t_y_4_q <= next_t_y_3_q;
      end

      if (step_4_q) begin
        context_5_q <= context_4_q;
        level_5_q <= level_4_q;
        hits_5_q <= hits_4;
        skip_5_q <= skip_4;
        cross_x_5_q <= cross_x_4;
        cross_y_5_q <= cross_y_4;
        neighbour_skipped_5_q <= neighbour_skipped_4;
        face_5_q <= face_4;
        t_5_q <= hits_4 ? t_hit_4 : skip_4 ? t_out_4 : reached_4;
        node_x_5_q <= node_x_4_q;
        node_y_5_q <= node_y_4_q;
        if (!hits_4) begin
          node_x_5_q <= skip_4 ? node_x_4_q + {{(PlaneBits - 1) {1'b0}}, cross_x_4}
                               : (node_x_4_q <<< 1) | {{(PlaneBits - 1) {1'b0}}, upper_x_4};
          node_y_5_q <= skip_4 ? node_y_4_q + {{(PlaneBits - 1) {1'b0}}, cross_y_4}
                               : (node_y_4_q <<< 1) | {{(PlaneBits - 1) {1'b0}}, upper_y_4};
        end
        px_5_q <= upper_x_4 ? px_4_q : px_4_q - half_x_4;
        py_5_q <= upper_y_4 ? py_4_q : py_4_q - half_y_4;
      end

      if (step_5_q) begin
        context_6_q <= context_5_q;
        hits_6_q <= hits_5_q;
        misses_6_q <= misses_5;
        skip_6_q <= skip_5_q;
        face_6_q <= face_5_q;
        t_6_q <= t_5_q;
        crossed_6_q <= level_5_q;
        level_6_q <= hits_5_q ? level_5_q : level_5;
        node_x_6_q <= hits_5_q ? node_x_5_q : node_x_5;
        node_y_6_q <= hits_5_q ? node_y_5_q : node_y_5;
        px_6_q <= px_5_q;
        py_6_q <= py_5_q;
        further_6_q <= further_5 & ~hits_5_q;
        further_twice_6_q <= further_twice_5 & ~hits_5_q;
      end

      if (step_6_q) begin
        level_q[context_6_q] <= level_6;
        node_x_q[context_6_q] <= node_x_6;
        node_y_q[context_6_q] <= node_y_6;
        t_cur_q[context_6_q] <= t_6_q;
        crossed_q[context_6_q] <= {skip_6_q, crossed_6_q};
        face_q[context_6_q] <= hits_6_q ? face_6_q : HmtFaceNone;
        steps_q[context_6_q] <= steps_q[context_6_q] + 32'd1;
        if (skip_6_q) down_q[context_6_q] <= 2'd1;
      end

      if (fresh) begin
        id_q[context_0] <= in_id_i;
        mx_q[context_0] <= in_mx_i;
        my_q[context_0] <= in_my_i;
        mz_q[context_0] <= in_mz_i;
        ox_q[context_0] <= in_ox_i;
        oy_q[context_0] <= in_oy_i;
        oz_q[context_0] <= in_oz_i;
        ex_q[context_0] <= in_ex_i;
        ey_q[context_0] <= in_ey_i;
        ez_q[context_0] <= in_ez_i;
        still_x_q[context_0] <= in_still_x_i;
        still_y_q[context_0] <= in_still_y_i;
        still_z_q[context_0] <= in_still_z_i;
        flip_x_q[context_0] <= in_flip_x_i;
        flip_y_q[context_0] <= in_flip_y_i;
        rising_q[context_0] <= in_rising_i;
        t_start_q[context_0] <= in_t_start_i;
        t_max_q[context_0] <= in_t_max_i;
        t_root_q[context_0] <= in_t_root_i;
        level_q[context_0] <= in_level_i;
        node_x_q[context_0] <= in_node_x_i;
        node_y_q[context_0] <= in_node_y_i;
        t_cur_q[context_0] <= in_t_start_i;
        down_q[context_0] <= cfg_down_i;
        crossed_q[context_0] <= '0;
        steps_q[context_0] <= '0;
        face_q[context_0] <= HmtFaceNone;
      end
    end
  end

  // ---- The hit stream. The cell is in the map's own frame, unwrapped.
  wire hit = face_q[select_context] != HmtFaceNone;
  wire signed [PlaneBits-1:0] last_node =
      (PlaneBits'(1) << (cfg_root_level_i - level_q[select_context])) - PlaneBits'(1);
  assign hit_valid_o = ended;
  assign hit_id_o = id_q[select_context];
  assign hit_status_o = hit;
  assign hit_face_o = face_q[select_context];
  assign hit_level_o = hit ? level_q[select_context] : '0;
  assign hit_i_o = ~hit ? '0 : flip_x_q[select_context] ? last_node - node_x_q[select_context]
                                                         : node_x_q[select_context];
  assign hit_j_o = ~hit ? '0 : flip_y_q[select_context] ? last_node - node_y_q[select_context]
                                                         : node_y_q[select_context];
  assign hit_t_o = hit ? t_cur_q[select_context] : '0;
  assign hit_steps_o = steps_q[select_context];

endmodule
