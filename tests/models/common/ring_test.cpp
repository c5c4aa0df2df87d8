#include "models/common/ring.h"

#include <gtest/gtest.h>

#include <deque>

#include "models/common/random.h"

namespace cuesta {
namespace {

TEST(Ring, HoldsWhatADequeHoldsUpToItsRoom) {
  Random random(11);
  for (const size_t room : {1, 2, 3, 5, 8, 33, 64}) {
    Ring<int> ring(room);
    std::deque<int> deque;
    for (int k = 0; k < 5000; ++k) {
      if (deque.size() < room && (deque.empty() || random.chance(0.6))) {
        ring.push_back(k);
        deque.push_back(k);
      } else {
        ring.pop_front();
        deque.pop_front();
      }
      ASSERT_EQ(ring.size(), deque.size()) << "room " << room << ", action " << k;
      ASSERT_EQ(ring.empty(), deque.empty());
      for (size_t i = 0; i < deque.size(); ++i)
        ASSERT_EQ(ring[i], deque[i]) << "room " << room << ", action " << k;
      if (!deque.empty()) {
        ASSERT_EQ(ring.front(), deque.front());
      }
    }
  }
}

}  // namespace
}  // namespace cuesta
