#include "sim/session/parallel.h"

#include <gtest/gtest.h>

#include <chrono>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>

namespace cuesta {
namespace {

TEST(ParallelFor, RunsEveryNumberOnceOnAnyNumberOfThreads) {
  for (const int threads : {1, 2, 5}) {
    std::vector<std::atomic<int>> runs(300);
    EXPECT_TRUE(
        parallel_for(runs.size(), threads, [&](size_t number, const std::atomic<bool>&) { ++runs[number]; }));
    for (const std::atomic<int>& count : runs) ASSERT_EQ(count, 1) << threads;
  }
  EXPECT_TRUE(parallel_for(0, 3, [](size_t, const std::atomic<bool>&) { FAIL(); }));
}

TEST(ParallelFor, TasksRunAtTheSameTime) {
  std::atomic<int> inside = 0;
  parallel_for(2, 2, [&](size_t, const std::atomic<bool>&) {
    ++inside;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (inside < 2 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  });
  EXPECT_EQ(inside, 2) << "one waited for the other's end";
}

TEST(ParallelFor, TheExceptionOfTheLowestNumberIsThrownOnceAllHaveEnded) {
  for (const int threads : {1, 3}) {
    std::atomic<int> running = 0;
    try {
      parallel_for(3, threads, [&](size_t number, const std::atomic<bool>&) {
        ++running;
        // All three are inside before one throws, so that each throws.
        while (threads == 3 && running < 3) std::this_thread::yield();
        throw std::runtime_error(std::to_string(number));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "0");
      EXPECT_EQ(running, threads == 3 ? 3 : 1) << "a task began after the one that threw";
    }
  }
}

TEST(ParallelFor, SaidToStopItBeginsNothingMoreAndTellsTheTasks) {
  std::atomic<size_t> begun = 0;
  const auto endless = [&](size_t, const std::atomic<bool>& stop) {
    ++begun;
    while (!stop) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  EXPECT_FALSE(parallel_for(50, 2, endless, [] { return false; }));
  EXPECT_EQ(begun, 2u);
}

/// The squares that are taken, each with its number, over so many tasks; `last` is the last one wanted.
std::vector<int> squares(int threads, int tasks, int last) {
  std::vector<int> taken;
  int made = 0;
  ordered_groups(
      threads,
      [&] {
        const auto task = [number = made] {
          std::this_thread::sleep_for(std::chrono::milliseconds(number % 3 == 0 ? 3 : 0));
          return number * number;
        };
        return made++ < tasks ? std::optional(task) : std::nullopt;
      },
      [&](int square) {
        taken.push_back(square);
        return square < last * last;
      },
      [] { return true; });
  return taken;
}

TEST(OrderedGroups, ResultsAreTakenInTheirOrderWhateverTheThreads) {
  std::vector<int> all(20);
  for (int k = 0; k < 20; ++k) all[static_cast<size_t>(k)] = k * k;
  for (const int threads : {1, 2, 7, 40}) EXPECT_EQ(squares(threads, 20, 100), all) << threads;
}

TEST(OrderedGroups, BehindTheLastWantedResultNothingIsTaken) {
  for (const int threads : {1, 2, 7}) {
    const std::vector<int> taken = squares(threads, 20, 9);
    EXPECT_EQ(taken.size(), 10u) << threads;
    EXPECT_EQ(taken.back(), 81) << threads;
  }
}

TEST(OrderedGroups, AnExceptionComesInItsTurn) {
  for (const int threads : {1, 4}) {
    std::vector<int> taken;
    int made = 0;
    const auto next = [&] {
      return std::optional([number = made++] {
        if (number == 2) throw std::runtime_error("two");
        return number;
      });
    };
    const auto take = [&](int number) {
      taken.push_back(number);
      return true;
    };
    EXPECT_THROW(ordered_groups(threads, next, take, [] { return true; }), std::runtime_error);
    EXPECT_EQ(taken, (std::vector<int>{0, 1})) << threads;
  }
}

TEST(OrderedGroups, IsAskedBeforeEachGroupWhetherToGoOn) {
  int asked = 0;
  std::vector<int> taken;
  ordered_groups(
      3, [] { return std::optional([] { return 1; }); },
      [&](int one) {
        taken.push_back(one);
        return true;
      },
      [&] { return ++asked <= 2; });
  EXPECT_EQ(taken.size(), 6u);
}

}  // namespace
}  // namespace cuesta
