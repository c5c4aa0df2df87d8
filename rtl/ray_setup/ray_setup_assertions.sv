// What holds at the ports of ray_setup. Bound by rtl/assertions.sv.

module ray_setup_assertions #(
    parameter int QueueDepth = 8,
    parameter int LatencyCycles = 24,
    parameter int ContextBits = 64,  // all fields of what traverse is given
    // Widths that follow.
    parameter int PointerBits = (QueueDepth > 1) ? $clog2(QueueDepth) : 1,
    parameter int AgeBits = $clog2(LatencyCycles + 1)
) (
    input logic clk_i,
    input logic rst_ni,

    input logic                   enters_i,
    input logic                   out_valid_i,
    input logic                   out_ready_i,
    input logic [ContextBits-1:0] out_i,
    input logic                   empty_i,
    input logic [  PointerBits:0] fill_i
);

  logic waits_q;
  logic [ContextBits-1:0] out_q;
  logic [PointerBits:0] rays_q;
  logic [AgeBits-1:0] since_empty_q;  // cycles since it was empty, up to LatencyCycles

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      waits_q <= 1'b0;
      out_q <= '0;
      rays_q <= '0;
      since_empty_q <= '0;
    end else begin
      waits_q <= out_valid_i & ~out_ready_i;
      out_q <= out_i;
      rays_q <= rays_q + {{PointerBits{1'b0}}, enters_i} - {{PointerBits{1'b0}}, out_valid_i & out_ready_i};
      if (rays_q == '0 && !enters_i) since_empty_q <= '0;
      else if (since_empty_q != AgeBits'(LatencyCycles)) since_empty_q <= since_empty_q + 1'b1;

      if (waits_q) begin
        context_stays_until_taken : assert (out_valid_i);
        context_is_stable : assert (!out_valid_i || out_i == out_q);
      end
      queue_never_overflows : assert (!enters_i || rays_q < (PointerBits + 1)'(QueueDepth));
      context_has_a_ray : assert (!out_valid_i || rays_q != '0);
      context_not_before_its_latency : assert (!out_valid_i || rays_q == '0 || since_empty_q == AgeBits'(LatencyCycles));
      fill_is_the_number_of_rays : assert (fill_i == rays_q);
      empty_means_no_ray : assert (empty_i == (rays_q == '0));
    end
  end

endmodule
