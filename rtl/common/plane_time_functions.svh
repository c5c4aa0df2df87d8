// The arithmetic of a plane time (the time at which a ray crosses a plane, or reaches a height), for modules with the
// parameters ProductBits, MantissaBits, FractionBits, TimeBits and
// ShiftBits. Times saturate at t_end; a negative one is given as 0.

  // Product of a plane (or height) and a slope, less the offset.
  function automatic logic signed [ProductBits-1:0] product(input logic signed [ProductBits-1:0] k,
                                                            input logic [MantissaBits:0] mantissa,
                                                            input logic signed [ProductBits-1:0] offset);
    // The low bits of a product are the same with signs and without.
    product = $signed(($unsigned(k) * {{(ProductBits - MantissaBits - 1) {1'b0}}, mantissa}) << FractionBits) - offset;
  endfunction

  // The time of a product, at least 0.
  function automatic logic [TimeBits-1:0] time_of(input logic signed [ProductBits-1:0] p, input logic still,
                                                  input logic [ShiftBits-1:0] shift,
                                                  input logic [TimeBits-1:0] t_end);
    logic [TimeBits-1:0] limit;
    limit = t_end >> shift;
    // A negative product is above every limit when read without its sign.
    if (!still && $unsigned(p) <= {{(ProductBits - TimeBits) {1'b0}}, limit}) time_of = p[TimeBits-1:0] << shift;
    else time_of = p[ProductBits-1] ? '0 : t_end;
  endfunction

  function automatic logic [TimeBits-1:0] later(input logic [TimeBits-1:0] a, input logic [TimeBits-1:0] b);
    later = (a > b) ? a : b;
  endfunction

  // Whether the time of a product is at most t, for a t below t_end.
  function automatic logic at_most(input logic signed [ProductBits-1:0] p, input logic still,
                                   input logic [ShiftBits-1:0] shift, input logic [TimeBits-1:0] t);
    logic [TimeBits-1:0] limit;
    limit = t >> shift;
    at_most = p[ProductBits-1] | (~still & ($unsigned(p) <= {{(ProductBits - TimeBits) {1'b0}}, limit}));
  endfunction

