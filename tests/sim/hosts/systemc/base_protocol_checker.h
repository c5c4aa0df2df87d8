#pragma once

#include <tlm.h>
#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>

#include <cstring>
#include <map>
#include <set>
#include <string>
#include <systemc>
#include <tuple>
#include <vector>

#include "sim/hosts/systemc/memory_tag.h"

namespace cuesta::systemc {

/// Stands between an initiator and a target, lets everything pass, and writes down each rule of the base protocol
/// (IEEE 1666-2011, 15.2) and of memory_out that a call breaks.
class BaseProtocolChecker : public sc_core::sc_module {
 public:
  tlm_utils::simple_target_socket<BaseProtocolChecker> from{"from"};
  tlm_utils::simple_initiator_socket<BaseProtocolChecker> to{"to"};

  std::vector<std::string> faults;
  uint64_t begun = 0, ended = 0;
  size_t most_in_flight = 0;
  std::vector<sc_core::sc_time> request_times;

  explicit BaseProtocolChecker(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {
    from.register_nb_transport_fw(this, &BaseProtocolChecker::forward);
    from.register_b_transport(this, &BaseProtocolChecker::blocking);
    from.register_transport_dbg(this, &BaseProtocolChecker::debug);
    to.register_nb_transport_bw(this, &BaseProtocolChecker::backward);
  }

  size_t in_flight() const { return transactions_.size(); }

 private:
  using Payload = tlm::tlm_generic_payload;
  enum class State { kRequest, kAccepted, kResponse };
  struct Transaction {
    State state = State::kRequest;
    std::tuple<tlm::tlm_command, uint64_t, unsigned char*, unsigned, unsigned> attributes;
    std::vector<unsigned char> data;  ///< of a write
    std::tuple<int, bool, int> identity;
  };

  static auto attributes_of(const Payload& p) {
    return std::tuple(p.get_command(), static_cast<uint64_t>(p.get_address()), p.get_data_ptr(),
                      p.get_data_length(), p.get_streaming_width());
  }

  void rule(bool holds, const char* text) {
    if (!holds) faults.emplace_back(text);
  }

  void begin(Payload& p) {
    rule(requesting_ == nullptr, "BEGIN_REQ before the request before it was accepted");
    rule(transactions_.count(&p) == 0, "BEGIN_REQ of a payload that is in flight");
    rule(p.has_mm() && p.get_ref_count() > 0,
         "BEGIN_REQ of a payload without memory management or reference");
    rule(p.get_response_status() == tlm::TLM_INCOMPLETE_RESPONSE, "BEGIN_REQ with a response status");
    Transaction t;
    t.attributes = attributes_of(p);
    if (p.is_write()) t.data.assign(p.get_data_ptr(), p.get_data_ptr() + p.get_data_length());
    if (const auto* tag = p.get_extension<MemoryTag>()) t.identity = {tag->pipeline, tag->write, tag->slot};
    rule(identities_.insert(t.identity).second, "two outstanding transactions of one identity");
    transactions_[&p] = std::move(t);
    requesting_ = &p;
    ++begun;
    most_in_flight = std::max(most_in_flight, transactions_.size());
    request_times.push_back(sc_core::sc_time_stamp());
  }

  void accept(Payload& p) {
    rule(transactions_.count(&p) != 0 && transactions_[&p].state == State::kRequest,
         "END_REQ out of its place");
    if (transactions_.count(&p) != 0) transactions_[&p].state = State::kAccepted;
    if (requesting_ == &p) requesting_ = nullptr;
  }

  void respond(Payload& p) {
    rule(responding_ == nullptr, "BEGIN_RESP before the response before it was ended");
    if (transactions_.count(&p) == 0)
      return static_cast<void>(faults.emplace_back("BEGIN_RESP of a payload that is not in flight"));
    if (requesting_ == &p) requesting_ = nullptr;
    check_stable(p);
    rule(transactions_[&p].state != State::kResponse, "BEGIN_RESP twice");
    rule(p.get_response_status() != tlm::TLM_INCOMPLETE_RESPONSE, "BEGIN_RESP without a response status");
    transactions_[&p].state = State::kResponse;
    responding_ = &p;
  }

  void end(Payload& p) {
    const auto found = transactions_.find(&p);
    if (found == transactions_.end()) {
      faults.emplace_back("a payload that is not in flight ends");
      return;
    }
    if (requesting_ == &p) requesting_ = nullptr;
    if (responding_ == &p) responding_ = nullptr;
    identities_.erase(found->second.identity);
    transactions_.erase(found);
    ++ended;
  }

  void check_stable(const Payload& p) {
    const Transaction& t = transactions_.at(const_cast<Payload*>(&p));
    rule(t.attributes == attributes_of(p), "attributes of a payload change in flight");
    rule(t.data.empty() || std::memcmp(t.data.data(), p.get_data_ptr(), t.data.size()) == 0,
         "the data of a write change in flight");
    rule(p.get_ref_count() > 0, "a payload in flight has no reference");
  }

  tlm::tlm_sync_enum forward(Payload& p, tlm::tlm_phase& phase, sc_core::sc_time& delay) {
    if (phase == tlm::BEGIN_REQ) {
      begin(p);
    } else if (phase == tlm::END_RESP) {
      rule(responding_ == &p, "END_RESP without BEGIN_RESP");
      end(p);
    } else {
      faults.emplace_back("a phase that no initiator sends");
    }
    const bool request = phase == tlm::BEGIN_REQ;
    const tlm::tlm_sync_enum sync = to->nb_transport_fw(p, phase, delay);
    if (!request) return sync;
    if (sync == tlm::TLM_COMPLETED) {
      check_stable(p);
      end(p);
    } else if (sync == tlm::TLM_UPDATED && phase == tlm::END_REQ) {
      accept(p);
    } else if (sync == tlm::TLM_UPDATED) {
      respond(p);
    }
    return sync;
  }

  tlm::tlm_sync_enum backward(Payload& p, tlm::tlm_phase& phase, sc_core::sc_time& delay) {
    if (phase == tlm::END_REQ) {
      accept(p);
    } else if (phase == tlm::BEGIN_RESP) {
      respond(p);
    } else {
      faults.emplace_back("a phase that no target sends");
    }
    const bool response = phase == tlm::BEGIN_RESP;
    const tlm::tlm_sync_enum sync = from->nb_transport_bw(p, phase, delay);
    if (response && sync != tlm::TLM_ACCEPTED) end(p);
    return sync;
  }

  void blocking(Payload& p, sc_core::sc_time& delay) { to->b_transport(p, delay); }
  unsigned debug(Payload& p) { return to->transport_dbg(p); }

  std::map<Payload*, Transaction> transactions_;
  std::set<std::tuple<int, bool, int>> identities_;
  Payload* requesting_ = nullptr;
  Payload* responding_ = nullptr;
};

}  // namespace cuesta::systemc
