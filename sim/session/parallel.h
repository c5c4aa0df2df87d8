#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <optional>
#include <type_traits>
#include <vector>

namespace cuesta {

/// Runs task(0) ... task(count - 1) on up to `threads` threads, each taking the next number when it is free. `task`
/// gets a flag that is set once nothing more is wanted; a long task looks at it. The calling thread asks `go_on` (may
/// be empty) about ten times a second; false: no further task begins. When a task throws, no further one begins
/// either, and once all threads have ended the exception of the lowest number is thrown. Returns whether every task
/// was run.
bool parallel_for(size_t count, int threads,
                  const std::function<void(size_t number, const std::atomic<bool>& stop)>& task,
                  const std::function<bool()>& go_on = {});

/// Runs tasks group by group, `threads` of them at a time, and takes what they return in the order in which they were
/// made: what is taken does not depend on the threads' pace. On the calling thread, `next()` gives an optional
/// function to run, nullopt when there is no more for now; `take(result)` says false when nothing more shall be taken,
/// and the rest of the group is dropped; `go_on()` is asked before each group. An exception of a task is thrown in its
/// turn, after the results before it were taken.
template <class Next, class Take, class GoOn>
void ordered_groups(int threads, Next next, Take take, GoOn go_on) {
  using Task = typename std::invoke_result_t<Next>::value_type;
  using Result = std::invoke_result_t<Task&>;
  while (go_on()) {
    std::vector<Task> tasks;
    while (tasks.size() < static_cast<size_t>(threads)) {
      std::optional<Task> task = next();
      if (!task) break;
      tasks.push_back(std::move(*task));
    }
    if (tasks.empty()) return;
    std::vector<std::optional<Result>> results(tasks.size());
    std::vector<std::exception_ptr> failures(tasks.size());
    parallel_for(tasks.size(), threads, [&](size_t number, const std::atomic<bool>&) {
      try {
        results[number] = tasks[number]();
      } catch (...) {
        failures[number] = std::current_exception();
      }
    });
    for (size_t number = 0; number < tasks.size(); ++number) {
      if (failures[number]) std::rethrow_exception(failures[number]);
      if (!take(std::move(*results[number]))) return;
    }
  }
}

}  // namespace cuesta
