// height_l1: the private cache of pyramid texels of one pipeline; non-blocking, misses parked and merged.
//
// Ports: one lookup a cycle, answered in the same cycle; replays and retries offered to traverse; requests out
// (valid/ready, in order of allocation); fills in, always taken. The texel follows one enabled cycle later.
// Timing: a lookup in cycle c sees the lines that had landed by c - 1. A miss allocates the free MSHR of lowest
// index, or is merged into the pending one of its line, or, with none free, goes to the retry FIFO (a place for
// every context). A request leaves in the cycle of its allocation at the earliest. The waiters of a fill that
// lands in c are replayed from c + 1 on, with the texel, without another lookup; the MSHR is free in the cycle
// after its last waiter went. The victim, the least recently used way, is chosen and made most recently used at
// allocation; its old line can be read until the fill lands.

module height_l1 #(
    parameter int SizeBytes = 16384,
    parameter int LineBytes = 64,
    parameter int Ways = 4,
    parameter int Mshrs = 8,
    parameter int Contexts = 32,
    parameter int AddressBits = 24,
    parameter int HeightBits = 8,
    // Widths that follow.
    parameter int ContextBits = (Contexts > 1) ? $clog2(Contexts) : 1,
    parameter int MshrBits = (Mshrs > 1) ? $clog2(Mshrs) : 1
) (
    input logic clk_i,
    input logic rst_ni,

    input  logic                   enable_i,          // the pipe moves: what is asked happens, the texel follows
    input  logic                   lookup_valid_i,
    input  logic                   lookup_retry_i,
    input  logic [AddressBits-1:0] lookup_address_i,  // bytes
    input  logic [ContextBits-1:0] lookup_context_i,
    output logic                   lookup_hit_o,
    output logic                   replay_valid_o,
    input  logic                   replay_take_i,
    output logic [ContextBits-1:0] replay_context_o,
    output logic                   retry_valid_o,
    output logic [ContextBits-1:0] retry_context_o,
    output logic [ HeightBits-1:0] texel_o,

    output logic                   request_valid_o,
    input  logic                   request_ready_i,
    output logic [   MshrBits-1:0] request_mshr_o,
    output logic [AddressBits-1:0] request_address_o,
    input  logic                   fill_valid_i,
    input  logic [   MshrBits-1:0] fill_mshr_i,
    input  logic [8*LineBytes-1:0] fill_data_i,

    output logic              miss_o,     // if the pipe moves: allocates
    output logic              merge_o,
    output logic              refuse_o,
    output logic              evict_o,    // a fill replaces a line
    output logic [MshrBits:0] mshrs_o     // taken
);

  localparam int OffsetBits = $clog2(LineBytes);
  localparam int Sets = SizeBytes / LineBytes / Ways;
  localparam int SetBits = (Sets > 1) ? $clog2(Sets) : 1;
  localparam int LineBits = AddressBits - OffsetBits;
  localparam int WayBits = (Ways > 1) ? $clog2(Ways) : 1;
  localparam int Lines = Sets * Ways;
  localparam int LineIndexBits = (Lines > 1) ? $clog2(Lines) : 1;
  localparam int WordBytes = 8;
  localparam int Words = LineBytes / WordBytes;
  localparam int WordBits = OffsetBits - 3;
  localparam int TexelBytes = (HeightBits > 8) ? 2 : 1;

  // ---- Tags and ages. A way that was chosen as a victim keeps its old line until the fill lands.
  logic [Lines-1:0] valid_q;
  logic [LineBits-1:0] line_q[Lines];           // set-major
  logic [Sets-1:0] used_q;                        // sets ever used
  logic [Ways*WayBits-1:0] oldest_first_q[Sets];  // ways of a set, the least recently used in the lowest bits

  // ---- MSHRs
  logic [Mshrs-1:0] taken_q, pending_q;  // pending: the line has not landed
  logic [LineBits-1:0] mshr_line_q[Mshrs];
  logic [WayBits-1:0] mshr_way_q[Mshrs];
  logic [ContextBits-1:0] first_q[Mshrs];  // waiters: a chain of contexts
  logic [ContextBits-1:0] last_q[Mshrs];
  logic [ContextBits-1:0] next_q[Contexts];
  logic [MshrBits:0] mshr_fill_q;

  // ---- FIFOs: requests to send, landed MSHRs, refused contexts
  logic [MshrBits-1:0] request_q[Mshrs];
  logic [MshrBits-1:0] request_read_q, request_write_q;
  logic [MshrBits:0] request_fill_q;
  logic [MshrBits-1:0] landed_q[Mshrs];
  logic [MshrBits-1:0] landed_read_q, landed_write_q;
  logic [MshrBits:0] landed_fill_q;
  logic [ContextBits-1:0] retry_q[Contexts];
  logic [ContextBits-1:0] retry_read_q, retry_write_q;
  logic [ContextBits:0] retry_fill_q;

  function automatic logic [MshrBits-1:0] next_mshr(input logic [MshrBits-1:0] pointer);
    next_mshr = (pointer == MshrBits'(Mshrs - 1)) ? '0 : pointer + 1'b1;
  endfunction
  function automatic logic [ContextBits-1:0] next_context(input logic [ContextBits-1:0] pointer);
    next_context = (pointer == ContextBits'(Contexts - 1)) ? '0 : pointer + 1'b1;
  endfunction

  // ---- Lookup. What it finds follows from registers; it happens if the pipe moves.
  wire [LineBits-1:0] line = lookup_address_i[AddressBits-1:OffsetBits];
  wire [SetBits-1:0] set = (Sets > 1) ? line[SetBits-1:0] : '0;
  logic found;
  logic [WayBits-1:0] found_way;
  logic [Ways-1:0] set_valid;
  always_comb begin
    found = 1'b0;
    found_way = '0;
    set_valid = '0;
    if (lookup_valid_i) begin
      set_valid = valid_q[32'(set)*Ways+:Ways];
      for (int unsigned w = 0; w < Ways; w++) begin
        if (set_valid[w] && line_q[32'(set)*Ways+w] == line) begin
          found = 1'b1;
          found_way = WayBits'(w);
        end
      end
    end
  end

  wire missing = lookup_valid_i & ~found;
  wire all_taken = &taken_q;
  logic merges;
  logic [MshrBits-1:0] merge_mshr, free_mshr;
  always_comb begin
    merges = 1'b0;
    merge_mshr = '0;
    free_mshr = '0;
    if (missing) begin
      for (int unsigned m = 0; m < Mshrs; m++) begin
        if (pending_q[m] && mshr_line_q[m] == line) begin
          merges = 1'b1;
          merge_mshr = MshrBits'(m);
        end
        if (!taken_q[Mshrs-1-m]) free_mshr = MshrBits'(Mshrs - 1 - m);
      end
    end
  end
  wire allocates = missing & ~merges & ~all_taken;
  wire refuses = missing & ~merges & all_taken;
  assign lookup_hit_o = found;
  assign merge_o = merges;
  assign miss_o = allocates;
  assign refuse_o = refuses;

  // The ways of the set, the least recently used in the lowest bits; never used: in the order of their numbers.
  logic [Ways*WayBits-1:0] ages;
  always_comb begin
    for (int unsigned w = 0; w < Ways; w++) ages[w*WayBits+:WayBits] = WayBits'(w);
    if (lookup_valid_i && used_q[set]) ages = oldest_first_q[set];
  end
  wire [WayBits-1:0] victim = ages[WayBits-1:0];

  // ---- Replays and retries
  logic [MshrBits-1:0] head;
  logic last_waiter;
  always_comb begin
    head = '0;
    last_waiter = 1'b0;
    replay_context_o = '0;
    if (replay_valid_o) begin
      head = landed_q[landed_read_q];
      replay_context_o = first_q[head];
      last_waiter = replay_context_o == last_q[head];
    end
  end
  wire frees = replay_take_i & last_waiter;  // if the pipe moves
  assign replay_valid_o = landed_fill_q != '0;
  assign retry_valid_o = (retry_fill_q != '0) & ~all_taken;
  assign retry_context_o = retry_q[retry_read_q];

  // ---- Requests: the MSHR allocated in this cycle if none waits
  wire request_waits = request_fill_q != '0;
  assign request_valid_o = request_waits | (enable_i & allocates);
  always_comb begin
    request_mshr_o = free_mshr;
    request_address_o = {line, {OffsetBits{1'b0}}};
    if (request_waits) begin
      request_mshr_o = request_q[request_read_q];
      request_address_o = {mshr_line_q[request_q[request_read_q]], {OffsetBits{1'b0}}};
    end
  end

  // ---- Fills
  logic [LineBits-1:0] fill_line;
  logic [LineIndexBits-1:0] fill_index;
  always_comb begin
    fill_line = '0;
    fill_index = '0;
    evict_o = 1'b0;
    if (fill_valid_i) begin
      fill_line = mshr_line_q[fill_mshr_i];
      fill_index = LineIndexBits'(mshr_way_q[fill_mshr_i])
          + ((Sets > 1) ? LineIndexBits'(32'(fill_line[SetBits-1:0]) * Ways) : '0);
      evict_o = valid_q[fill_index];
    end
  end
  assign mshrs_o = mshr_fill_q;

  // ---- Data of the lines and of landed MSHRs: a line is written, a word is read.
  wire [LineIndexBits-1:0] read_index = LineIndexBits'(32'(set) * Ways + 32'(found_way));
  wire [WordBits-1:0] read_word = lookup_address_i[OffsetBits-1:3];
  localparam int LineDataBits = $clog2(Lines * Words);
  localparam int MshrDataBits = $clog2(Mshrs * Words);
  logic [63:0] line_data_q[Lines*Words];
  logic [63:0] mshr_data_q[Mshrs*Words];
  logic [63:0] line_word_q, mshr_word_q;
  logic [2:0] byte_q;
  logic replayed_q;
  always_ff @(posedge clk_i) begin
    if (fill_valid_i) begin
      for (int unsigned w = 0; w < Words; w++) begin
        line_data_q[LineDataBits'({fill_index, WordBits'(w)})] <= fill_data_i[w*64+:64];
        mshr_data_q[MshrDataBits'({fill_mshr_i, WordBits'(w)})] <= fill_data_i[w*64+:64];
      end
    end
    if (enable_i && (found || replay_take_i)) begin
      if (found) line_word_q <= line_data_q[LineDataBits'({read_index, read_word})];
      if (replay_take_i) mshr_word_q <= mshr_data_q[MshrDataBits'({head, read_word})];
      byte_q <= lookup_address_i[2:0];
      replayed_q <= replay_take_i;
    end
  end
  wire [63:0] word = replayed_q ? mshr_word_q : line_word_q;
  assign texel_o = (TexelBytes == 1) ? HeightBits'(word >> {byte_q, 3'b000})
                                     : HeightBits'(word >> {byte_q[2:1], 4'b0000});

  // What was used last goes behind all others of its set: the youngest way is there already.
  wire [WayBits-1:0] touched = found ? found_way : victim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_q <= '0;
      used_q <= '0;
      taken_q <= '0;
      pending_q <= '0;
      mshr_fill_q <= '0;
      request_read_q <= '0;
      request_write_q <= '0;
      request_fill_q <= '0;
      landed_read_q <= '0;
      landed_write_q <= '0;
      landed_fill_q <= '0;
      retry_read_q <= '0;
      retry_write_q <= '0;
      retry_fill_q <= '0;
    end else begin
      if (enable_i) begin
        if (allocates || (found && ages[(Ways-1)*WayBits+:WayBits] != found_way)) begin : touch
          // From the touched way's place on, each moves up one.
          logic [Ways*WayBits-1:0] after;
          logic swaps;
          after = ages;
          for (int unsigned k = 0; k + 1 < Ways; k++) begin
            swaps = after[k*WayBits+:WayBits] == touched;
            after[k*WayBits+:WayBits] = swaps ? ages[(k+1)*WayBits+:WayBits] : after[k*WayBits+:WayBits];
            after[(k+1)*WayBits+:WayBits] = swaps ? touched : after[(k+1)*WayBits+:WayBits];
          end
          oldest_first_q[set] <= after;
        end
        if (missing) begin
          if (allocates) begin
            used_q[set] <= 1'b1;
            taken_q[free_mshr] <= 1'b1;
            pending_q[free_mshr] <= 1'b1;
            mshr_line_q[free_mshr] <= line;
            mshr_way_q[free_mshr] <= victim;
            first_q[free_mshr] <= lookup_context_i;
            last_q[free_mshr] <= lookup_context_i;
            request_q[request_write_q] <= free_mshr;
            if (request_waits || !request_ready_i) request_write_q <= next_mshr(request_write_q);
          end
          if (merges) begin
            next_q[last_q[merge_mshr]] <= lookup_context_i;
            last_q[merge_mshr] <= lookup_context_i;
          end
          if (refuses) begin
            retry_q[retry_write_q] <= lookup_context_i;
            retry_write_q <= next_context(retry_write_q);
          end
        end
        if (lookup_retry_i) retry_read_q <= next_context(retry_read_q);
        if (refuses != lookup_retry_i) retry_fill_q <= refuses ? retry_fill_q + 1'b1 : retry_fill_q - 1'b1;
        if (replay_take_i) begin
          if (last_waiter) begin
            taken_q[head] <= 1'b0;
            landed_read_q <= next_mshr(landed_read_q);
          end else begin
            first_q[head] <= next_q[first_q[head]];
          end
        end
        if (allocates != frees) mshr_fill_q <= allocates ? mshr_fill_q + 1'b1 : mshr_fill_q - 1'b1;
      end
      // A request leaves in the cycle of its allocation if none waits.
      if (request_ready_i && request_waits) request_read_q <= next_mshr(request_read_q);
      if ((enable_i & allocates) != (request_valid_o & request_ready_i)) begin
        request_fill_q <= (enable_i & allocates) ? request_fill_q + 1'b1 : request_fill_q - 1'b1;
      end
      if (fill_valid_i) begin
        line_q[fill_index] <= fill_line;
        landed_q[landed_write_q] <= fill_mshr_i;
        valid_q[fill_index] <= 1'b1;
        pending_q[fill_mshr_i] <= 1'b0;
        landed_write_q <= next_mshr(landed_write_q);
      end
      if (fill_valid_i != (enable_i & frees)) begin
        landed_fill_q <= fill_valid_i ? landed_fill_q + 1'b1 : landed_fill_q - 1'b1;
      end
    end
  end

endmodule
