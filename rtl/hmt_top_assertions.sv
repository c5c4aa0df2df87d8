// What holds at the ports of hmt_top: of its environment (fills) and of itself. Bound by rtl/assertions.sv.

module hmt_top_assertions #(
    parameter int Mshrs = 8,
    parameter int MostRays = 40,   // in set-up and in contexts
    parameter int HitBits = 64,    // all fields of a hit
    parameter int AddressBits = 32,
    // Widths that follow.
    parameter int MshrBits = (Mshrs > 1) ? $clog2(Mshrs) : 1,
    parameter int RayBits = $clog2(MostRays + 2)
) (
    input logic clk_i,
    input logic rst_ni,

    input logic                   reg_write_i,
    input logic                   ray_enters_i,
    input logic                   hit_valid_i,
    input logic                   hit_ready_i,
    input logic [    HitBits-1:0] hit_i,
    input logic                   request_valid_i,
    input logic                   request_ready_i,
    input logic [   MshrBits-1:0] request_mshr_i,
    input logic [AddressBits-1:0] request_address_i,
    input logic                   fill_valid_i,
    input logic [   MshrBits-1:0] fill_mshr_i,
    input logic [            5:0] slot_kinds_i      // step, miss, merge, refused, dead, stall
);

  logic hit_waits_q, request_waits_q;
  logic [HitBits-1:0] hit_q;
  logic [MshrBits+AddressBits-1:0] request_q;
  logic [Mshrs-1:0] asked_q;  // requested, not filled
  logic [RayBits-1:0] rays_q;
  wire hit_leaves = hit_valid_i & hit_ready_i;
  wire request_leaves = request_valid_i & request_ready_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      hit_waits_q <= 1'b0;
      hit_q <= '0;
      request_waits_q <= 1'b0;
      request_q <= '0;
      asked_q <= '0;
      rays_q <= '0;
    end else begin
      hit_waits_q <= hit_valid_i & ~hit_ready_i;
      hit_q <= hit_i;
      request_waits_q <= request_valid_i & ~request_ready_i;
      request_q <= {request_mshr_i, request_address_i};
      if (fill_valid_i) asked_q[fill_mshr_i] <= 1'b0;
      if (request_leaves) asked_q[request_mshr_i] <= 1'b1;
      rays_q <= rays_q + RayBits'(ray_enters_i) - RayBits'(hit_leaves);

      if (hit_waits_q) begin
        hit_stays_until_ready : assert (hit_valid_i);
        hit_is_stable : assert (!hit_valid_i || hit_i == hit_q);
      end
      if (request_waits_q) begin
        request_stays_until_ready : assert (request_valid_i);
        request_is_stable : assert (!request_valid_i || {request_mshr_i, request_address_i} == request_q);
      end
      request_id_is_free : assert (!request_leaves || !asked_q[request_mshr_i]);
      fill_was_requested : assert (!fill_valid_i || asked_q[fill_mshr_i]);
      one_kind_a_cycle : assert ((slot_kinds_i & (slot_kinds_i - 6'd1)) == '0);
      no_more_rays_than_places : assert (rays_q <= RayBits'(MostRays));
      a_hit_has_a_ray : assert (!hit_leaves || rays_q != '0);
      configured_while_empty : assert (!reg_write_i || rays_q == '0);
    end
  end

endmodule
