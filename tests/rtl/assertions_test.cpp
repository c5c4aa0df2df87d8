#include <gtest/gtest.h>
#include <verilated.h>

#include <fstream>
#include <functional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "Vheight_l1_assertions.h"
#include "Vhmt_top_assertions.h"
#include "Vray_setup_assertions.h"
#include "Vtraverse_assertions.h"

// Every assertion of rtl/ alone, on inputs by hand: silent up to the last cycle, which breaks what it states.

namespace cuesta::rtl {
namespace {

/// The inputs of one cycle, set over those of the cycle before.
template <class V>
using Cycle = std::function<void(V&)>;

template <class V>
struct Case {
  std::string assertion;
  std::vector<Cycle<V>> cycles;  ///< the last one breaks the assertion
};

std::set<std::string> fired_in(const std::string& output) {
  static const std::regex message(R"(Assertion failed in [\w.]+\.(\w+):)");
  std::set<std::string> names;
  for (std::sregex_iterator it(output.begin(), output.end(), message), end; it != end; ++it)
    names.insert((*it)[1]);
  return names;
}

template <class V>
std::set<std::string> run(const std::vector<Cycle<V>>& cycles, size_t first, size_t last, V& rtl) {
  testing::internal::CaptureStdout();
  for (size_t k = first; k < last; ++k) {
    cycles[k](rtl);
    rtl.clk_i = 0;
    rtl.eval();
    rtl.clk_i = 1;
    rtl.eval();
  }
  return fired_in(testing::internal::GetCapturedStdout());
}

/// `quiet`: inputs of a unit in which nothing happens.
template <class V>
void check(const std::string& file, const Cycle<V>& quiet, const std::vector<Case<V>>& cases) {
  std::set<std::string> checked;
  for (const Case<V>& test : cases) {
    VerilatedContext context;
    context.fatalOnError(false);
    V rtl(&context, "unit");
    std::vector<Cycle<V>> cycles = {[&](V& v) {
                                      quiet(v);
                                      v.rst_ni = 0;
                                    },
                                    [](V& v) { v.rst_ni = 1; }};
    cycles.insert(cycles.end(), test.cycles.begin(), test.cycles.end());
    EXPECT_EQ(run(cycles, 0, cycles.size() - 1, rtl), std::set<std::string>{}) << test.assertion;
    EXPECT_TRUE(run(cycles, cycles.size() - 1, cycles.size(), rtl).contains(test.assertion))
        << test.assertion;
    checked.insert(test.assertion);
  }
  std::ifstream source(file);
  const std::string text((std::istreambuf_iterator<char>(source)), {});
  std::set<std::string> written;
  static const std::regex assertion(R"((\w+) : assert\b)");
  for (std::sregex_iterator it(text.begin(), text.end(), assertion), end; it != end; ++it)
    written.insert((*it)[1]);
  EXPECT_EQ(checked, written) << "assertions of " << file;
}

template <class V>
std::vector<Cycle<V>> times(size_t count, const Cycle<V>& cycle, std::vector<Cycle<V>> then) {
  then.insert(then.begin(), count, cycle);
  return then;
}

TEST(Assertions, OfHmtTopEachFire) {
  using V = Vhmt_top_assertions;
  const Cycle<V> enter = [](V& v) { v.ray_enters_i = 1; };
  const Cycle<V> hit_waits = [](V& v) { v.ray_enters_i = 0, v.hit_valid_i = 1; };
  const Cycle<V> request_waits = [](V& v) { v.request_valid_i = 1; };
  const Cycle<V> request = [](V& v) { v.request_valid_i = v.request_ready_i = 1; };
  const Cycle<V> quiet = [](V& v) {
    v.reg_write_i = v.ray_enters_i = v.hit_valid_i = v.hit_ready_i = v.request_valid_i = v.request_ready_i =
        v.fill_valid_i = v.slot_kinds_i = 0;
    v.hit_i = v.request_mshr_i = v.request_address_i = v.fill_mshr_i = 0;
  };
  check<V>("rtl/hmt_top_assertions.sv", quiet,
           {{"hit_stays_until_ready", {enter, hit_waits, [](V& v) { v.hit_valid_i = 0; }}},
            {"hit_is_stable", {enter, hit_waits, [](V& v) { v.hit_i = 1; }}},
            {"request_stays_until_ready", {request_waits, [](V& v) { v.request_valid_i = 0; }}},
            {"request_is_stable", {request_waits, [](V& v) { v.request_address_i = 64; }}},
            {"request_id_is_free", {request, request}},
            {"fill_was_requested", {[](V& v) { v.fill_valid_i = 1; }}},
            {"one_kind_a_cycle", {[](V& v) { v.slot_kinds_i = 0b010010; }}},
            {"no_more_rays_than_places", times<V>(41, enter, {[](V& v) { v.ray_enters_i = 0; }})},
            {"a_hit_has_a_ray", {[](V& v) { v.hit_valid_i = v.hit_ready_i = 1; }}},
            {"configured_while_empty", {enter, [](V& v) { v.reg_write_i = 1; }}}});
}

TEST(Assertions, OfRaySetupEachFire) {
  using V = Vray_setup_assertions;
  constexpr int kQueueDepth = 8, kLatency = 24;  // the module's defaults
  const Cycle<V> quiet = [](V& v) {
    v.enters_i = v.out_valid_i = v.out_ready_i = v.out_i = v.fill_i = 0;
    v.empty_i = 1;
  };
  const Cycle<V> enter = [](V& v) { v.enters_i = 1; };
  const Cycle<V> inside = [](V& v) { v.enters_i = v.empty_i = 0, v.fill_i = 1; };
  const Cycle<V> offered = [](V& v) { v.out_valid_i = 1; };
  auto offered_then = [&](const Cycle<V>& last) {
    std::vector<Cycle<V>> cycles = times<V>(kLatency - 1, inside, {offered, last});
    cycles.insert(cycles.begin(), enter);
    return cycles;
  };
  std::vector<Cycle<V>> overflow;
  for (int k = 0; k <= kQueueDepth; ++k) {
    overflow.push_back([k](V& v) { v.enters_i = 1, v.fill_i = static_cast<uint8_t>(k), v.empty_i = k == 0; });
  }
  std::vector<Cycle<V>> early = times<V>(kLatency - 2, inside, {offered});
  early.insert(early.begin(), enter);
  check<V>("rtl/ray_setup/ray_setup_assertions.sv", quiet,
           {{"context_stays_until_taken", offered_then([](V& v) { v.out_valid_i = 0; })},
            {"context_is_stable", offered_then([](V& v) { v.out_i = 1; })},
            {"queue_never_overflows", overflow},
            {"context_has_a_ray", {offered}},
            {"context_not_before_its_latency", early},
            {"fill_is_the_number_of_rays", {[](V& v) { v.fill_i = 1; }}},
            {"empty_means_no_ray", {[](V& v) { v.empty_i = 0; }}}});
}

TEST(Assertions, OfTraverseEachFire) {
  using V = Vtraverse_assertions;
  const Cycle<V> quiet = [](V& v) {
    v.ended_i = v.goes_on_i = v.fresh_i = v.in_ready_i = v.lookup_valid_i = v.lookup_retry_i =
        v.replay_take_i = v.replay_valid_i = v.retry_valid_i = 0;
    v.select_context_i = v.context_i = v.fill_i = 0;
    v.resident_i = 0;
    v.enable_i = 1;
  };
  const Cycle<V> one = [](V& v) { v.resident_i = 0b10, v.fill_i = 1, v.select_context_i = v.context_i = 1; };
  check<V>(
      "rtl/traverse/traverse_assertions.sv", quiet,
      {{"at_most_contexts_resident", {[](V& v) { v.resident_i = ~0u, v.fill_i = 33; }}},
       {"fill_counts_the_residents", {one, [](V& v) { v.fill_i = 2; }}},
       {"selected_ray_is_resident", {one, [](V& v) { v.ended_i = 1, v.select_context_i = 2; }}},
       {"nothing_enters_while_stalled", {one, [](V& v) { v.ended_i = v.in_ready_i = 1, v.enable_i = 0; }}},
       {"stands_still_for_a_hit_alone", {one, [](V& v) { v.enable_i = 0; }}},
       {"replay_only_where_offered", {one, [](V& v) { v.replay_take_i = 1; }}},
       {"retry_only_where_offered", {one, [](V& v) { v.lookup_retry_i = v.lookup_valid_i = 1; }}},
       {"retry_is_a_lookup", {one, [](V& v) { v.lookup_retry_i = v.retry_valid_i = 1; }}},
       {"replay_is_no_lookup",
        {one, [](V& v) { v.goes_on_i = v.lookup_valid_i = v.replay_take_i = v.replay_valid_i = 1; }}},
       {"going_ray_is_looked_up",
        {one, [](V& v) { v.goes_on_i = v.lookup_valid_i = 1; }, [](V& v) { v.context_i = 2; }}},
       {"replay_goes_before_the_rest", {one, [](V& v) { v.replay_valid_i = v.lookup_valid_i = 1; }}},
       {"parked_ray_is_resident",
        {one, [](V& v) { v.replay_valid_i = v.replay_take_i = 1; }, [](V& v) { v.context_i = 3; }}},
       {"new_ray_takes_a_free_context", {one, [](V& v) { v.fresh_i = 1; }}}});
}

TEST(Assertions, OfHeightL1EachFire) {
  using V = Vheight_l1_assertions;
  const Cycle<V> quiet = [](V& v) {
    v.lookup_i = v.hit_i = v.miss_i = v.merge_i = v.refuse_i = v.replay_i = v.retry_i = v.replay_valid_i =
        v.frees_i = v.fill_valid_i = v.request_leaves_i = 0;
    v.replay_context_i = v.head_i = v.free_mshr_i = v.merge_mshr_i = v.fill_mshr_i = 0;
    v.taken_i = v.pending_i = v.mshr_fill_i = v.request_fill_i = v.landed_fill_i = v.retry_fill_i = 0;
  };
  const Cycle<V> pending = [](V& v) { v.taken_i = v.pending_i = 0b1, v.mshr_fill_i = 1; };
  const Cycle<V> landed = [](V& v) { v.taken_i = 0b1, v.mshr_fill_i = v.landed_fill_i = 1; };
  const Cycle<V> replay_waits = [](V& v) { v.replay_valid_i = 1; };
  check<V>("rtl/height_l1/height_l1_assertions.sv", quiet,
           {{"replay_stays_until_taken", {replay_waits, [](V& v) { v.replay_valid_i = 0; }}},
            {"replay_is_stable", {replay_waits, [](V& v) { v.replay_context_i = 1; }}},
            {"lookup_has_one_answer", {[](V& v) { v.lookup_i = v.hit_i = v.miss_i = 1; }}},
            {"no_answer_without_a_lookup", {[](V& v) { v.miss_i = 1; }}},
            {"miss_takes_a_free_mshr", {pending, [](V& v) { v.lookup_i = v.miss_i = 1; }}},
            {"merge_joins_a_pending_mshr", {landed, [](V& v) { v.lookup_i = v.merge_i = 1; }}},
            {"refused_only_with_all_taken", {pending, [](V& v) { v.lookup_i = v.refuse_i = 1; }}},
            {"fill_has_a_pending_mshr", {landed, [](V& v) { v.fill_valid_i = 1; }}},
            {"freed_mshr_has_landed", {pending, [](V& v) { v.frees_i = 1; }}},
            {"pending_is_taken", {pending, [](V& v) { v.taken_i = 0b10, v.landed_fill_i = 1; }}},
            {"fill_counts_the_mshrs", {pending, [](V& v) { v.mshr_fill_i = 2; }}},
            {"landed_fifo_holds_what_has_landed", {landed, [](V& v) { v.landed_fill_i = 0; }}},
            {"replay_has_an_mshr", {pending, [](V& v) { v.replay_i = 1; }}},
            {"requests_never_overflow", {[](V& v) { v.request_fill_i = 9; }}},
            {"request_has_a_miss", {[](V& v) { v.request_leaves_i = 1; }}},
            {"retries_never_overflow", {[](V& v) { v.retry_fill_i = 33; }}},
            {"retry_has_a_ray", {[](V& v) { v.retry_i = 1; }}}});
}

}  // namespace
}  // namespace cuesta::rtl
