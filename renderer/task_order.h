#pragma once

#include <atomic>
#include <cstdint>

namespace asos {

/// Tasks of TBB's, and of Embree's by it, begin after what sends them and end before it goes on.
/// The libraries see to that; but they are not instrumented, and so the thread sanitizer does not
/// know unless this tells it.
class TaskOrder {
 public:
  /// Lives while tasks are sent and waited for.
  class Sending {
   public:
    Sending() { end_of_what_was_before(); }
    ~Sending() { begin_after_it(); }
    Sending(const Sending&) = delete;
    Sending& operator=(const Sending&) = delete;
  };
  /// Lives as long as what a task does.
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
