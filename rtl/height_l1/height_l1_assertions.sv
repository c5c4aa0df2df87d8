// What holds inside height_l1. Bound by rtl/assertions.sv.

module height_l1_assertions #(
    parameter int Mshrs = 8,
    parameter int Contexts = 32,
    // Widths that follow.
    parameter int ContextBits = (Contexts > 1) ? $clog2(Contexts) : 1,
    parameter int MshrBits = (Mshrs > 1) ? $clog2(Mshrs) : 1
) (
    input logic clk_i,
    input logic rst_ni,

    input logic                   lookup_i,          // it happens: the pipe moves
    input logic                   hit_i,
    input logic                   miss_i,
    input logic                   merge_i,
    input logic                   refuse_i,
    input logic                   replay_i,
    input logic                   retry_i,
    input logic                   replay_valid_i,
    input logic [ContextBits-1:0] replay_context_i,
    input logic                   frees_i,
    input logic [   MshrBits-1:0] head_i,            // MSHR that is replayed
    input logic [   MshrBits-1:0] free_mshr_i,
    input logic [   MshrBits-1:0] merge_mshr_i,
    input logic                   fill_valid_i,
    input logic [   MshrBits-1:0] fill_mshr_i,
    input logic                   request_leaves_i,
    input logic [      Mshrs-1:0] taken_i,
    input logic [      Mshrs-1:0] pending_i,
    input logic [     MshrBits:0] mshr_fill_i,
    input logic [     MshrBits:0] request_fill_i,
    input logic [     MshrBits:0] landed_fill_i,
    input logic [  ContextBits:0] retry_fill_i
);

  logic [MshrBits:0] taken, landed;
  always_comb begin
    taken = '0;
    landed = '0;
    for (int unsigned m = 0; m < Mshrs; m++) begin
      taken = taken + {{MshrBits{1'b0}}, taken_i[m]};
      landed = landed + {{MshrBits{1'b0}}, taken_i[m] & ~pending_i[m]};
    end
  end

  logic replay_waits_q;
  logic [ContextBits-1:0] replay_context_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      replay_waits_q <= 1'b0;
      replay_context_q <= '0;
    end else begin
      replay_waits_q <= replay_valid_i & ~replay_i;
      replay_context_q <= replay_context_i;

      if (replay_waits_q) begin
        replay_stays_until_taken : assert (replay_valid_i);
        replay_is_stable : assert (!replay_valid_i || replay_context_i == replay_context_q);
      end
      if (lookup_i) begin
        lookup_has_one_answer : assert ({2'b00, hit_i} + {2'b00, miss_i} + {2'b00, merge_i} + {2'b00, refuse_i} == 3'd1);
      end
      no_answer_without_a_lookup : assert (lookup_i || !(miss_i | merge_i | refuse_i));
      miss_takes_a_free_mshr : assert (!miss_i || !taken_i[free_mshr_i]);
      merge_joins_a_pending_mshr : assert (!merge_i || pending_i[merge_mshr_i]);
      refused_only_with_all_taken : assert (!refuse_i || &taken_i);
      fill_has_a_pending_mshr : assert (!fill_valid_i || pending_i[fill_mshr_i]);
      freed_mshr_has_landed : assert (!frees_i || (taken_i[head_i] && !pending_i[head_i]));
      pending_is_taken : assert ((pending_i & ~taken_i) == '0);
      fill_counts_the_mshrs : assert (mshr_fill_i == taken);
      landed_fifo_holds_what_has_landed : assert (landed_fill_i == landed);
      replay_has_an_mshr : assert (!replay_i || landed_fill_i != '0);
      requests_never_overflow : assert (request_fill_i <= (MshrBits + 1)'(Mshrs));
      request_has_a_miss : assert (!request_leaves_i || miss_i || request_fill_i != '0);
      retries_never_overflow : assert (retry_fill_i <= (ContextBits + 1)'(Contexts));
      retry_has_a_ray : assert (!retry_i || retry_fill_i != '0);
    end
  end

endmodule
