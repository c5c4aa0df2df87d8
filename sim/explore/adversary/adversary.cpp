#include "sim/explore/adversary/adversary.h"

#include <algorithm>
#include <vector>

namespace cuesta {
namespace {

constexpr size_t kMembers = 10;
constexpr uint64_t kPatience = 2000;  ///< tries without a better case before the population is begun anew

struct Member {
  AdversaryCase it;
  double score;
};

bool is_worse(const Member& a, const Member& b) { return a.score < b.score; }

/// Picks the better of two members.
size_t parent(Random& random, const std::vector<Member>& members) {
  const size_t a = random.below(members.size()), b = random.below(members.size());
  return members[a].score >= members[b].score ? a : b;
}

}  // namespace

AdversaryResult run_adversary(const AdversaryScorer& scorer, const AdversaryOptions& options,
                              const AdversaryWatch& watch) {
  AdversaryResult result;
  Random random(options.seed);
  std::vector<Member> members;
  uint64_t improved = 0;  // the try that last bettered the population
  double best_here = -1;  // of this population
  while (watch(result.tries, std::max(0.0, result.score))) {
    const bool anew = !options.learns || members.size() < kMembers;
    size_t from = 0;
    AdversaryCase child;
    if (anew) {
      child = random_adversary_case(random, options.bounds);
    } else {
      from = parent(random, members);
      child = random.chance(0.15) ? crossed(random, members[from].it, members[parent(random, members)].it)
                                  : changed(random, members[from].it, options.bounds);
    }
    const AdversaryScore scored = scorer.score(child.grid, child.traced());
    ++result.tries;
    if (!scored.fault.empty()) {
      result.best = std::move(child);
      result.score = scored.score;
      result.best_try = result.tries;
      result.fault = scored.fault;
      return result;
    }
    if (scored.score > result.score) {
      result.best = child;
      result.score = scored.score;
      result.best_try = result.tries;
    }
    if (!options.learns) continue;
    if (scored.score > best_here) {
      best_here = scored.score;
      improved = result.tries;
    }
    if (anew) {
      members.push_back({std::move(child), scored.score});
    } else if (scored.score >= members[from].score) {
      // A child no worse than its parent: in its place, or for variety in the worst one's.
      auto place = scored.score > members[from].score
                       ? std::min_element(members.begin(), members.end(), is_worse)
                       : members.begin() + static_cast<ptrdiff_t>(from);
      *place = {std::move(child), scored.score};
    }
    if (result.tries - improved > kPatience) {
      members.clear();
      best_here = -1;
      improved = result.tries;
      ++result.restarts;
    }
  }
  return result;
}

}  // namespace cuesta
