// hmt_top: one heightmap-traversal pipeline: ray_setup, traverse and its height_l1.
//
// Ports: ray stream in and hit stream out (valid/ready, in the units of models/rays/machine_ray.h and hit.h),
// AXI4 read channels to memory (AR and R; one beat is one line, the ID is the MSHR's number, so replies may come in
// any order), a register file for configuration, and counters that carry the model's names.
// Configuration is written while no ray is inside.

`include "traverse/traverse_types.svh"
`include "common/hmt_registers.svh"

module hmt_top #(
`include "common/ray_widths.svh"
    parameter int SetupLatencyCycles = 24,
    parameter int SetupIntervalCycles = 4,
    parameter int SetupQueueDepth = 8,
    parameter int Stages = 8,
    parameter int Contexts = 32,
    parameter int SizeBytes = 16384,
    parameter int LineBytes = 64,
    parameter int Ways = 4,
    parameter int Mshrs = 8,
    parameter int AddressBits = 32,
    // A width that follows.
    parameter int MshrBits = (Mshrs > 1) ? $clog2(Mshrs) : 1
) (
    input logic clk_i,
    input logic rst_ni,

    input  logic        reg_write_i,
    input  logic        reg_read_i,
    input  logic [ 5:0] reg_address_i,
    input  logic [63:0] reg_data_i,
    output logic [63:0] reg_data_o,     // of reg_address_i while it is read, else 0

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
    input  logic                                      ray_none_i,   // none waits and none will come

    output logic                           hit_valid_o,
    input  logic                           hit_ready_i,
    output logic        [      IdBits-1:0] hit_id_o,
    output logic                           hit_status_o,
    output logic        [             2:0] hit_face_o,
    output logic        [HmtLevelBits-1:0] hit_level_o,
    output logic signed [   PlaneBits-1:0] hit_i_o,
    output logic signed [   PlaneBits-1:0] hit_j_o,
    output logic        [    TimeBits-1:0] hit_t_o,
    output logic        [            31:0] hit_steps_o,

    output logic                   axi_ar_valid_o,
    input  logic                   axi_ar_ready_i,
    output logic [   MshrBits-1:0] axi_ar_id_o,
    output logic [AddressBits-1:0] axi_ar_addr_o,
    output logic [            7:0] axi_ar_len_o,    // one beat
    output logic [            2:0] axi_ar_size_o,
    output logic [            1:0] axi_ar_burst_o,
    input  logic                   axi_r_valid_i,
    output logic                   axi_r_ready_o,
    input  logic [   MshrBits-1:0] axi_r_id_i,
    input  logic [8*LineBytes-1:0] axi_r_data_i,

    // What this cycle was, for accounting: HmtSlot... of traverse_types.svh, and whose. Nothing depends on it.
    output logic [            2:0] event_slot_o,
    output logic                   event_replay_o,  // a step that height_l1 has replayed
    output logic [     IdBits-1:0] event_id_o
);

  localparam int ContextBits = (Contexts > 1) ? $clog2(Contexts) : 1;

  // ---- Configuration registers
  logic [HmtLevelBits-1:0] root_level_q, stop_level_q;
  logic [1:0] start_q, down_q;
  logic [2:0] up_q;
  logic border_q, morton_q;
  logic [TimeBits-1:0] t_end_q;
  logic [HeightBits-1:0] root_bound_q;
  logic [(MaxLevel+1)*AddressBits-1:0] level_base_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {morton_q, stop_level_q, up_q, down_q, start_q, border_q, root_level_q} <= '0;
      t_end_q <= '0;
      root_bound_q <= '0;
      level_base_q <= '0;
    end else if (reg_write_i) begin
      if (reg_address_i == HmtAtMode) begin
        root_level_q <= reg_data_i[HmtModeRootLevel+:HmtLevelBits];
        border_q <= reg_data_i[HmtModeBorder];
        start_q <= reg_data_i[HmtModeStart+:2];
        down_q <= reg_data_i[HmtModeDown+:2];
        up_q <= reg_data_i[HmtModeUp+:3];
        stop_level_q <= reg_data_i[HmtModeStopLevel+:HmtLevelBits];
        morton_q <= reg_data_i[HmtModeMorton];
      end
      if (reg_address_i == HmtAtTimeEnd) t_end_q <= reg_data_i[TimeBits-1:0];
      if (reg_address_i == HmtAtRootBound) root_bound_q <= reg_data_i[HeightBits-1:0];
      for (int unsigned level = 0; level <= MaxLevel; level++) begin
        if (reg_address_i == HmtAtLevelBase + 6'(level)) begin
          level_base_q[level*AddressBits+:AddressBits] <= reg_data_i[AddressBits-1:0];
        end
      end
    end
  end

  // ---- ray_setup to traverse
  logic ray_offered, ray_taken, ray_dead, still_x, still_y, still_z, flip_x, flip_y, rising;
  logic [IdBits-1:0] ray_id;
  logic [MantissaBits:0] mx, my, mz;
  logic signed [ProductBits-1:0] ox, oy, oz;
  logic [ShiftBits-1:0] ex, ey, ez;
  logic [TimeBits-1:0] t_start, t_max, t_root;
  logic [HmtLevelBits-1:0] level;
  logic signed [PlaneBits-1:0] node_x, node_y;
  logic setup_empty;

  ray_setup #(
      .MaxLevel(MaxLevel),
      .HeightBits(HeightBits),
      .FractionBits(FractionBits),
      .DirectionBits(DirectionBits),
      .MantissaBits(MantissaBits),
      .TileBits(TileBits),
      .IdBits(IdBits),
      .LatencyCycles(SetupLatencyCycles),
      .IntervalCycles(SetupIntervalCycles),
      .QueueDepth(SetupQueueDepth)
  ) u_ray_setup (
      .clk_i,
      .rst_ni,
      .cfg_root_level_i(root_level_q),
      .cfg_border_i(border_q),
      .cfg_start_i(start_q),
      .cfg_stop_level_i(stop_level_q),
      .cfg_t_end_i(t_end_q),
      .cfg_root_bound_i(root_bound_q),
      .ray_valid_i,
      .ray_ready_o,
      .ray_id_i,
      .ray_x0_i,
      .ray_y0_i,
      .ray_z0_i,
      .ray_dx_i,
      .ray_dy_i,
      .ray_dz_i,
      .ray_t_max_i,
      .ray_dead_i,
      .empty_o(setup_empty),
      .out_valid_o(ray_offered),
      .out_ready_i(ray_taken),
      .out_id_o(ray_id),
      .out_dead_o(ray_dead),
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
      .out_level_o(level),
      .out_node_x_o(node_x),
      .out_node_y_o(node_y)
  );

  logic enable, lookup, lookup_retry, lookup_hit, replay_valid, replay_take, retry_valid;
  logic [AddressBits-1:0] lookup_address;
  logic [ContextBits-1:0] lookup_context, replay_context, retry_context;
  logic [HeightBits-1:0] texel;
  logic slot_step, slot_dead, stalled, full;
  logic [ContextBits:0] resident;

  traverse #(
      .MaxLevel(MaxLevel),
      .HeightBits(HeightBits),
      .FractionBits(FractionBits),
      .DirectionBits(DirectionBits),
      .MantissaBits(MantissaBits),
      .TileBits(TileBits),
      .IdBits(IdBits),
      .Stages(Stages),
      .Contexts(Contexts),
      .AddressBits(AddressBits)
  ) u_traverse (
      .clk_i,
      .rst_ni,
      .cfg_root_level_i(root_level_q),
      .cfg_border_i(border_q),
      .cfg_down_i(down_q),
      .cfg_up_i(up_q),
      .cfg_stop_level_i(stop_level_q),
      .cfg_t_end_i(t_end_q),
      .cfg_morton_i(morton_q),
      .cfg_level_base_i(level_base_q),
      .in_valid_i(ray_offered),
      .in_ready_o(ray_taken),
      .in_id_i(ray_id),
      .in_dead_i(ray_dead),
      .in_mx_i(mx),
      .in_my_i(my),
      .in_mz_i(mz),
      .in_ox_i(ox),
      .in_oy_i(oy),
      .in_oz_i(oz),
      .in_ex_i(ex),
      .in_ey_i(ey),
      .in_ez_i(ez),
      .in_still_x_i(still_x),
      .in_still_y_i(still_y),
      .in_still_z_i(still_z),
      .in_flip_x_i(flip_x),
      .in_flip_y_i(flip_y),
      .in_rising_i(rising),
      .in_t_start_i(t_start),
      .in_t_max_i(t_max),
      .in_t_root_i(t_root),
      .in_level_i(level),
      .in_node_x_i(node_x),
      .in_node_y_i(node_y),
      .enable_o(enable),
      .lookup_valid_o(lookup),
      .lookup_retry_o(lookup_retry),
      .lookup_address_o(lookup_address),
      .lookup_context_o(lookup_context),
      .lookup_hit_i(lookup_hit),
      .replay_valid_i(replay_valid),
      .replay_take_o(replay_take),
      .replay_context_i(replay_context),
      .retry_valid_i(retry_valid),
      .retry_context_i(retry_context),
      .texel_i(texel),
      .hit_valid_o,
      .hit_ready_i,
      .hit_id_o,
      .hit_status_o,
      .hit_face_o,
      .hit_level_o,
      .hit_i_o,
      .hit_j_o,
      .hit_t_o,
      .hit_steps_o,
      .slot_id_o(event_id_o),
      .slot_step_o(slot_step),
      .slot_dead_o(slot_dead),
      .stalled_o(stalled),
      .full_o(full),
      .resident_o(resident)
  );

  logic miss, merge, refuse, evict;
  logic [MshrBits:0] mshrs;

  height_l1 #(
      .SizeBytes(SizeBytes),
      .LineBytes(LineBytes),
      .Ways(Ways),
      .Mshrs(Mshrs),
      .Contexts(Contexts),
      .AddressBits(AddressBits),
      .HeightBits(HeightBits)
  ) u_height_l1 (
      .clk_i,
      .rst_ni,
      .enable_i(enable),
      .lookup_valid_i(lookup),
      .lookup_retry_i(lookup_retry),
      .lookup_address_i(lookup_address),
      .lookup_context_i(lookup_context),
      .lookup_hit_o(lookup_hit),
      .replay_valid_o(replay_valid),
      .replay_take_i(replay_take),
      .replay_context_o(replay_context),
      .retry_valid_o(retry_valid),
      .retry_context_o(retry_context),
      .texel_o(texel),
      .request_valid_o(axi_ar_valid_o),
      .request_ready_i(axi_ar_ready_i),
      .request_mshr_o(axi_ar_id_o),
      .request_address_o(axi_ar_addr_o),
      .fill_valid_i(axi_r_valid_i),
      .fill_mshr_i(axi_r_id_i),
      .fill_data_i(axi_r_data_i),
      .miss_o(miss),
      .merge_o(merge),
      .refuse_o(refuse),
      .evict_o(evict),
      .mshrs_o(mshrs)
  );

  assign axi_ar_len_o = 8'd0;
  assign axi_ar_size_o = 3'($clog2(LineBytes));
  assign axi_ar_burst_o = 2'b01;
  assign axi_r_ready_o = 1'b1;

  assign event_replay_o = enable & replay_take;
  logic [2:0] slot_kind;  // if the pipe moves
  always_comb begin
    if (slot_step) slot_kind = HmtSlotStep;
    else if (miss) slot_kind = HmtSlotMiss;
    else if (merge) slot_kind = HmtSlotMerge;
    else if (refuse) slot_kind = HmtSlotRefused;
    else if (slot_dead) slot_kind = HmtSlotDead;
    else slot_kind = HmtSlotBubble;
  end
  assign event_slot_o = stalled ? HmtSlotStall : slot_kind;

  // ---- Counters, with the model's names. Each cycle counts in one of them by what it was; sums are read as such.
  logic [63:0] ray_setup_rays_q;
  logic [63:0] traverse_rays_q;
  logic [63:0] traverse_hits_q;
  logic [63:0] traverse_slots_dead_q;
  logic [63:0] traverse_bubble_contexts_full_q;
  logic [63:0] traverse_bubble_no_ray_q;
  logic [63:0] traverse_bubble_drain_q;
  logic [63:0] traverse_stall_hit_queue_q;
  logic [63:0] traverse_replays_q;
  logic [63:0] height_l1_hits_q;
  logic [63:0] height_l1_misses_q;
  logic [63:0] height_l1_merges_q;
  logic [63:0] height_l1_refused_q;
  logic [63:0] height_l1_fills_q;
  logic [63:0] height_l1_evictions_q;
  logic [63:0] traverse_resident_cycles_q;
  logic [63:0] height_l1_mshr_cycles_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      ray_setup_rays_q <= '0;
      traverse_rays_q <= '0;
      traverse_hits_q <= '0;
      traverse_slots_dead_q <= '0;
      traverse_bubble_contexts_full_q <= '0;
      traverse_bubble_no_ray_q <= '0;
      traverse_bubble_drain_q <= '0;
      traverse_stall_hit_queue_q <= '0;
      traverse_replays_q <= '0;
      height_l1_hits_q <= '0;
      height_l1_misses_q <= '0;
      height_l1_merges_q <= '0;
      height_l1_refused_q <= '0;
      height_l1_fills_q <= '0;
      height_l1_evictions_q <= '0;
      traverse_resident_cycles_q <= '0;
      height_l1_mshr_cycles_q <= '0;
    end else begin
      if (stalled) begin
        traverse_stall_hit_queue_q <= traverse_stall_hit_queue_q + 64'd1;
      end else if (slot_step) begin
        if (replay_take) traverse_replays_q <= traverse_replays_q + 64'd1;
        else height_l1_hits_q <= height_l1_hits_q + 64'd1;
      end else if (slot_kind == HmtSlotBubble) begin
        if (full) traverse_bubble_contexts_full_q <= traverse_bubble_contexts_full_q + 64'd1;
        else if (ray_none_i & setup_empty) traverse_bubble_drain_q <= traverse_bubble_drain_q + 64'd1;
        else traverse_bubble_no_ray_q <= traverse_bubble_no_ray_q + 64'd1;
      end else begin
        if (miss) height_l1_misses_q <= height_l1_misses_q + 64'd1;
        if (merge) height_l1_merges_q <= height_l1_merges_q + 64'd1;
        if (refuse) height_l1_refused_q <= height_l1_refused_q + 64'd1;
        if (slot_dead) traverse_slots_dead_q <= traverse_slots_dead_q + 64'd1;
      end
      if (ray_valid_i & ray_ready_o) ray_setup_rays_q <= ray_setup_rays_q + 64'd1;
      if (hit_valid_o & hit_ready_i) begin
        traverse_rays_q <= traverse_rays_q + 64'd1;
        if (hit_status_o) traverse_hits_q <= traverse_hits_q + 64'd1;
      end
      if (axi_r_valid_i) begin
        height_l1_fills_q <= height_l1_fills_q + 64'd1;
        if (evict) height_l1_evictions_q <= height_l1_evictions_q + 64'd1;
      end
      traverse_resident_cycles_q <= traverse_resident_cycles_q + 64'(resident);
      height_l1_mshr_cycles_q <= height_l1_mshr_cycles_q + 64'(mshrs);
    end
  end

  always_comb begin
    reg_data_o = '0;
    if (reg_read_i) begin
      case (reg_address_i)
        HmtAtMode: begin
          reg_data_o[HmtModeRootLevel+:HmtLevelBits] = root_level_q;
          reg_data_o[HmtModeBorder] = border_q;
          reg_data_o[HmtModeStart+:2] = start_q;
          reg_data_o[HmtModeDown+:2] = down_q;
          reg_data_o[HmtModeUp+:3] = up_q;
          reg_data_o[HmtModeStopLevel+:HmtLevelBits] = stop_level_q;
          reg_data_o[HmtModeMorton] = morton_q;
        end
        HmtAtTimeEnd: reg_data_o = 64'(t_end_q);
        HmtAtRootBound: reg_data_o = 64'(root_bound_q);
        HmtAtCounter + 6'd0: reg_data_o = ray_setup_rays_q;
        HmtAtCounter + 6'd1: reg_data_o = traverse_rays_q;
        HmtAtCounter + 6'd2: reg_data_o = traverse_hits_q;
        HmtAtCounter + 6'd3: reg_data_o = height_l1_hits_q + traverse_replays_q;  // traverse_slots_step
        HmtAtCounter + 6'd4: reg_data_o = height_l1_misses_q + height_l1_merges_q;  // traverse_slots_miss
        HmtAtCounter + 6'd5: reg_data_o = height_l1_refused_q;  // traverse_slots_refused
        HmtAtCounter + 6'd6: reg_data_o = traverse_slots_dead_q;
        HmtAtCounter + 6'd7: reg_data_o = traverse_bubble_contexts_full_q;
        HmtAtCounter + 6'd8: reg_data_o = traverse_bubble_no_ray_q;
        HmtAtCounter + 6'd9: reg_data_o = traverse_bubble_drain_q;
        HmtAtCounter + 6'd10: reg_data_o = traverse_stall_hit_queue_q;
        HmtAtCounter + 6'd11: reg_data_o = traverse_replays_q;
        HmtAtCounter + 6'd12: reg_data_o = height_l1_hits_q + height_l1_misses_q + height_l1_merges_q + height_l1_refused_q;  // accesses
        HmtAtCounter + 6'd13: reg_data_o = height_l1_hits_q;
        HmtAtCounter + 6'd14: reg_data_o = height_l1_misses_q;
        HmtAtCounter + 6'd15: reg_data_o = height_l1_merges_q;
        HmtAtCounter + 6'd16: reg_data_o = height_l1_refused_q;
        HmtAtCounter + 6'd17: reg_data_o = height_l1_fills_q;
        HmtAtCounter + 6'd18: reg_data_o = height_l1_evictions_q;
        HmtAtCounter + 6'd19: reg_data_o = traverse_resident_cycles_q;
        HmtAtCounter + 6'd20: reg_data_o = height_l1_mshr_cycles_q;
        default: ;
      endcase
    end
  end

endmodule
