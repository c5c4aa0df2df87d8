#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "models/units/architecture.h"
#include "models/units/ports/port_stalls.h"

namespace cuesta::twins {

/// dram, clock by clock: banks that precharge, activate and issue columns; a data bus per channel that serves in
/// order of arrival; a response port per pipeline at which the oldest answer that is ready lands.
class DramTwin {
 public:
  struct Request {
    int pipeline;
    bool write;
    int tag;  ///< the reader's MSHR
    uint64_t address;
    int owner;  ///< the ray it belongs to
  };

  struct Counts {
    int64_t reads = 0, writes = 0;
    int64_t row_hits = 0, row_misses = 0, row_conflicts = 0;
    int64_t bus_clocks = 0;
  };

  /// What one request cost, told when its place on the bus is fixed.
  struct Cost {
    Request request;
    bool activated;
    int64_t bus_clocks;
  };

  DramTwin(const DramParameters& parameters, int line_bytes, int burst_bytes, int pipelines,
           const PortStalls& stalls)
      : parameters_(parameters),
        line_bytes_(line_bytes),
        burst_bytes_(burst_bytes),
        stalls_(stalls),
        channels_(static_cast<size_t>(parameters.channels),
                  Channel{std::vector<Bank>(static_cast<size_t>(parameters.banks)), {}, 0}),
        reads_(static_cast<size_t>(pipelines)),
        writes_(static_cast<size_t>(pipelines)) {}

  /// The MSHR whose fill lands at pipeline's height_l1 in `cycle`: the one served first of those that are ready,
  /// if the port is not blocked. Asked once a cycle and pipeline.
  std::optional<int> landing_read(int pipeline, Cycle cycle);
  /// How many bursts of the pipeline are acknowledged in `cycle`. Asked once a cycle and pipeline.
  int landing_writes(int pipeline, Cycle cycle);

  /// A request leaves its unit in `cycle`. Within a cycle: ordered by pipeline, a read before a write.
  void send(const Request& request, Cycle cycle) {
    on_the_way_.push_back({request, cycle + parameters_.request_latency_cycles, 0});
  }

  /// Takes what arrives in `cycle` and runs the memory clocks that begin before cycle + 1.
  void evaluate(Cycle cycle);

  const Counts& counts() const { return counts_; }
  /// The costs fixed in the last evaluate().
  const std::vector<Cost>& new_costs() const { return new_costs_; }
  bool idle() const;

 private:
  struct Travelling {
    Request request;
    Cycle cycle;    ///< of arrival
    int64_t order;  ///< of service
  };
  struct Served {
    Request request;
    int64_t order;
    int bank;
    uint64_t row;
    int64_t from;         ///< first memory clock in which the controller sees it
    int64_t column = -1;  ///< memory clock of its column command
    bool activated = false;
    bool conflicted = false;
  };
  struct Bank {
    std::optional<uint64_t> row;        ///< open, or being opened
    int64_t activated = 0;              ///< memory clock of the last activation
    int64_t command_done = 0;           ///< the precharge or activation under way ends
    int64_t ready = 0;                  ///< the next command may be given
    bool column_waits_for_bus = false;  ///< ready is not known yet
  };
  struct Channel {
    std::vector<Bank> banks;
    std::deque<Served> queue;  ///< in order of service, until the place on the bus is fixed
    int64_t bus_free = 0;
  };
  struct Answer {
    int tag;
    int64_t order;
    Cycle ready;
  };

  void accept(const Travelling& arrived);
  void clock(Channel& channel, int64_t now);
  /// Gives the bank's commands for `request` that are possible at clock `now`.
  void command(Bank& bank, Served& request, int64_t now);
  void fix_bus(Channel& channel);
  int64_t bytes(const Request& request) const { return request.write ? burst_bytes_ : line_bytes_; }

  DramParameters parameters_;
  int line_bytes_, burst_bytes_;
  const PortStalls& stalls_;
  std::vector<Channel> channels_;
  std::deque<Travelling> on_the_way_;
  std::vector<std::vector<Answer>> reads_, writes_;  ///< answers on their way, per pipeline
  int64_t next_clock_ = 0;
  int64_t next_order_ = 0;
  Counts counts_;
  std::vector<Cost> new_costs_;
};

}  // namespace cuesta::twins
