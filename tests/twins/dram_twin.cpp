#include "tests/twins/dram_twin.h"

#include <algorithm>

namespace cuesta::twins {
namespace {

int64_t ceiling(int64_t a, int64_t b) { return (a + b - 1) / b; }

}  // namespace

std::optional<int> DramTwin::landing_read(int pipeline, Cycle cycle) {
  if (stalls_.blocked(Port::kMemoryResponse, pipeline, cycle)) return {};
  std::vector<Answer>& answers = reads_[pipeline];
  auto first = answers.end();
  for (auto answer = answers.begin(); answer != answers.end(); ++answer) {
    if (answer->ready <= cycle && (first == answers.end() || answer->order < first->order)) first = answer;
  }
  if (first == answers.end()) return {};
  const int tag = first->tag;
  answers.erase(first);
  return tag;
}

int DramTwin::landing_writes(int pipeline, Cycle cycle) {
  return static_cast<int>(
      std::erase_if(writes_[pipeline], [&](const Answer& a) { return a.ready == cycle; }));
}

void DramTwin::evaluate(Cycle cycle) {
  new_costs_.clear();
  while (!on_the_way_.empty() && on_the_way_.front().cycle <= cycle) {
    accept(on_the_way_.front());
    on_the_way_.pop_front();
  }
  // What arrives in the next cycle is seen from clock ceil((cycle + 1) * num / den) on.
  const int64_t end = ceiling((cycle + 1) * parameters_.clock_num, parameters_.clock_den);
  for (; next_clock_ < end; ++next_clock_) {
    for (Channel& channel : channels_) {
      if (!channel.queue.empty()) clock(channel, next_clock_);
    }
  }
}

void DramTwin::accept(const Travelling& arrived) {
  const DramParameters& p = parameters_;
  const auto granule = static_cast<uint64_t>(std::max(line_bytes_, burst_bytes_));
  uint64_t place = arrived.request.address / granule;
  Channel& channel = channels_[place % static_cast<uint64_t>(p.channels)];
  place /= static_cast<uint64_t>(p.channels);
  place /= std::max<uint64_t>(1, static_cast<uint64_t>(p.row_bytes) / granule);
  Served served{};
  served.request = arrived.request;
  served.order = next_order_++;
  served.bank = static_cast<int>(place % static_cast<uint64_t>(p.banks));
  served.row = place / static_cast<uint64_t>(p.banks);
  served.from = ceiling(arrived.cycle * p.clock_num, p.clock_den);
  served.column = -1;
  channel.queue.push_back(served);
}

void DramTwin::clock(Channel& channel, int64_t now) {
  std::vector<bool> bank_has_older(channel.banks.size(), false);
  for (Served& request : channel.queue) {
    if (request.column >= 0) continue;  // waits for the bus; column_waits_for_bus keeps its bank
    if (bank_has_older[request.bank]) continue;
    bank_has_older[request.bank] = true;
    if (request.from <= now) command(channel.banks[request.bank], request, now);
  }
  fix_bus(channel);
}

void DramTwin::command(Bank& bank, Served& request, int64_t now) {
  if (bank.column_waits_for_bus || now < bank.ready || now < bank.command_done) return;
  if (bank.row && *bank.row != request.row) {  // another row: precharge
    if (now < bank.activated + parameters_.tRAS) return;
    bank.row.reset();
    bank.command_done = now + parameters_.tRP;
    request.conflicted = true;
    if (now < bank.command_done) return;
  }
  if (!bank.row) {  // nothing open: activate
    bank.row = request.row;
    bank.activated = now;
    bank.command_done = now + parameters_.tRCD;
    request.activated = true;
    if (now < bank.command_done) return;
  }
  request.column = now;
  bank.column_waits_for_bus = true;
}

void DramTwin::fix_bus(Channel& channel) {
  while (!channel.queue.empty() && channel.queue.front().column >= 0) {
    const Served served = channel.queue.front();
    channel.queue.pop_front();
    const int64_t clocks = ceiling(bytes(served.request), parameters_.bus_bytes);
    const int64_t data = std::max(served.column + parameters_.tCL, channel.bus_free);
    channel.bus_free = data + clocks;
    Bank& bank = channel.banks[served.bank];
    bank.ready = data - parameters_.tCL + clocks;
    bank.column_waits_for_bus = false;
    const Cycle ready = ceiling((data + clocks) * parameters_.clock_den, parameters_.clock_num) +
                        parameters_.response_latency_cycles;
    auto& answers = served.request.write ? writes_ : reads_;
    answers[served.request.pipeline].push_back({served.request.tag, served.order, ready});

    ++(served.request.write ? counts_.writes : counts_.reads);
    ++(served.conflicted ? counts_.row_conflicts : served.activated ? counts_.row_misses : counts_.row_hits);
    counts_.bus_clocks += clocks;
    new_costs_.push_back({served.request, served.activated, clocks});
  }
}

bool DramTwin::idle() const {
  auto none = [](const auto& list) { return list.empty(); };
  return on_the_way_.empty() &&
         std::all_of(channels_.begin(), channels_.end(), [](const Channel& c) { return c.queue.empty(); }) &&
         std::all_of(reads_.begin(), reads_.end(), none) && std::all_of(writes_.begin(), writes_.end(), none);
}

}  // namespace cuesta::twins
