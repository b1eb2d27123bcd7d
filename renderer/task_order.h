#pragma once

#include <atomic>
#include <cstdint>

namespace asos {

/// Declares the order of TBB tasks (and Embree's, which use TBB) to the thread sanitizer. Tasks
/// begin after the code that starts them, and end before it continues. The libraries guarantee
/// that, but they are not instrumented, so the sanitizer cannot see it.
class TaskOrder {
 public:
  /// Exists while tasks are started and waited for.
  class Sending {
   public:
    Sending() { end_of_what_was_before(); }
    ~Sending() { begin_after_it(); }
    Sending(const Sending&) = delete;
    Sending& operator=(const Sending&) = delete;
  };
  /// Exists during a task.
  class Task {
   public:
    Task() { begin_after_it(); }
    ~Task() { end_of_what_was_before(); }
    Task(const Task&) = delete;
    Task& operator=(const Task&) = delete;
  };

 private:
  static void end_of_what_was_before() { ends.fetch_add(1, std::memory_order_release); }
  static void begin_after_it() { (void)ends.load(std::memory_order_acquire); }

  static inline std::atomic<std::uint32_t> ends{0};
};

}  // namespace asos
