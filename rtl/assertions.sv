// Binds the assertions to the units they watch. For Verilator alone (Icarus 11 knows no bind), in builds for tests.

bind hmt_top hmt_top_assertions #(
    .Mshrs(Mshrs),
    .MostRays(SetupQueueDepth + Contexts),
    .HitBits(IdBits + 4 + HmtLevelBits + 2 * PlaneBits + TimeBits + 32),
    .AddressBits(AddressBits)
) u_assertions (
    .clk_i,
    .rst_ni,
    .reg_write_i,
    .ray_enters_i(ray_valid_i & ray_ready_o),
    .hit_valid_i(hit_valid_o),
    .hit_ready_i,
    .hit_i({hit_id_o, hit_status_o, hit_face_o, hit_level_o, hit_i_o, hit_j_o, hit_t_o, hit_steps_o}),
    .request_valid_i(axi_ar_valid_o),
    .request_ready_i(axi_ar_ready_i),
    .request_mshr_i(axi_ar_id_o),
    .request_address_i(axi_ar_addr_o),
    .fill_valid_i(axi_r_valid_i),
    .fill_mshr_i(axi_r_id_i),
    .slot_kinds_i({{5{enable}} & {slot_step, miss, merge, refuse, slot_dead}, stalled})
);

bind ray_setup ray_setup_assertions #(
    .QueueDepth(QueueDepth),
    .LatencyCycles(LatencyCycles),
    .ContextBits(IdBits + 3 * (MantissaBits + 1 + ProductBits + ShiftBits) + 7 + 3 * TimeBits + HmtLevelBits +
                 2 * PlaneBits)
) u_assertions (
    .clk_i,
    .rst_ni,
    .enters_i(enters),
    .out_valid_i(out_valid_o),
    .out_ready_i,
    .out_i({out_id_o, out_dead_o, out_mx_o, out_my_o, out_mz_o, out_ox_o, out_oy_o, out_oz_o, out_ex_o, out_ey_o,
            out_ez_o, out_still_x_o, out_still_y_o, out_still_z_o, out_flip_x_o, out_flip_y_o, out_rising_o,
            out_t_start_o, out_t_max_o, out_t_root_o, out_level_o, out_node_x_o, out_node_y_o}),
    .empty_i(empty_o),
    .fill_i(fill_q)
);

`ifndef HMT_OTHER_TRAVERSE  // they look inside
bind traverse traverse_assertions #(
    .Contexts(Contexts)
) u_assertions (
    .clk_i,
    .rst_ni,
    .enable_i(enable),
    .ended_i(ended),
    .goes_on_i(goes_on),
    .select_context_i(select_context),
    .fresh_i(fresh),
    .in_ready_i(in_ready_o),
    .lookup_valid_i(lookup_valid_o),
    .lookup_retry_i(lookup_retry_o),
    .replay_take_i(replay_take_o),
    .replay_valid_i,
    .retry_valid_i,
    .context_i(context_0),
    .resident_i(resident_q),
    .fill_i(fill_q)
);
`endif

bind height_l1 height_l1_assertions #(
    .Mshrs(Mshrs),
    .Contexts(Contexts)
) u_assertions (
    .clk_i,
    .rst_ni,
    .lookup_i(enable_i & lookup_valid_i),
    .hit_i(lookup_hit_o),
    .miss_i(enable_i & miss_o),
    .merge_i(enable_i & merge_o),
    .refuse_i(enable_i & refuse_o),
    .replay_i(enable_i & replay_take_i),
    .retry_i(enable_i & lookup_retry_i),
    .replay_valid_i(replay_valid_o),
    .replay_context_i(replay_context_o),
    .frees_i(enable_i & frees),
    .head_i(head),
    .free_mshr_i(free_mshr),
    .merge_mshr_i(merge_mshr),
    .fill_valid_i,
    .fill_mshr_i,
    .request_leaves_i(request_valid_o & request_ready_i),
    .taken_i(taken_q),
    .pending_i(pending_q),
    .mshr_fill_i(mshr_fill_q),
    .request_fill_i(request_fill_q),
    .landed_fill_i(landed_fill_q),
    .retry_fill_i(retry_fill_q)
);
