// What holds inside traverse and between it and height_l1. Bound by rtl/assertions.sv.

module traverse_assertions #(
    parameter int Contexts = 32,
    // Widths that follow.
    parameter int ContextBits = (Contexts > 1) ? $clog2(Contexts) : 1
) (
    input logic clk_i,
    input logic rst_ni,

    input logic                   enable_i,
    input logic                   ended_i,          // the ray at select
    input logic                   goes_on_i,
    input logic [ContextBits-1:0] select_context_i,
    input logic                   fresh_i,          // a new ray takes the slot, if the pipe moves
    input logic                   in_ready_i,
    input logic                   lookup_valid_i,
    input logic                   lookup_retry_i,
    input logic                   replay_take_i,
    input logic                   replay_valid_i,
    input logic                   retry_valid_i,
    input logic [ContextBits-1:0] context_i,        // issued in this cycle
    input logic [   Contexts-1:0] resident_i,
    input logic [  ContextBits:0] fill_i
);

  logic [ContextBits:0] count;
  always_comb begin
    count = '0;
    for (int unsigned k = 0; k < Contexts; k++) count = count + {{ContextBits{1'b0}}, resident_i[k]};
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
    end else begin
      at_most_contexts_resident : assert (fill_i <= (ContextBits + 1)'(Contexts));
      fill_counts_the_residents : assert (fill_i == count);
      selected_ray_is_resident : assert (!(ended_i | goes_on_i) || resident_i[select_context_i]);
      nothing_enters_while_stalled : assert (enable_i || !in_ready_i);
      stands_still_for_a_hit_alone : assert (enable_i || ended_i);
      replay_only_where_offered : assert (!replay_take_i || replay_valid_i);
      retry_only_where_offered : assert (!lookup_retry_i || retry_valid_i);
      retry_is_a_lookup : assert (!lookup_retry_i || lookup_valid_i);
      replay_is_no_lookup : assert (!replay_take_i || !lookup_valid_i);
      going_ray_is_looked_up : assert (!goes_on_i || (lookup_valid_i && context_i == select_context_i));
      replay_goes_before_the_rest : assert (goes_on_i || !replay_valid_i || !lookup_valid_i);
      parked_ray_is_resident : assert (!(replay_take_i | lookup_retry_i) || resident_i[context_i]);
      new_ray_takes_a_free_context : assert (!(fresh_i & enable_i) || !resident_i[context_i] ||
                                             (ended_i && context_i == select_context_i));
    end
  end

endmodule
