#pragma once

#include "renderer/task_order.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

namespace asos {

/// The first exception of the calls of a loop. TBB never sees one: when it cancels a group of tasks
/// while another thread ends, it may read that thread's freed data (seen with 2021.8).
class FirstException {
 public:
  /// Calls `visit`, unless a call has thrown before.
  template <typename Visit>
  void call(const Visit& visit) noexcept {
    if (thrown_.load(std::memory_order_relaxed)) return;
    try {
      visit();
    } catch (...) {
      if (!thrown_.exchange(true)) exception_ = std::current_exception();
    }
  }
  /// Call after the loop has ended.
  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  std::atomic<bool> thrown_{false};
  std::exception_ptr exception_;
};

/// Calls visit(begin, end) for ranges of the numbers below `count`, on all processors and in any
/// order. Each range has at least `fewest` numbers, if there are as many. Returns when all calls
/// are done. If a call throws, no further ones begin, and the first exception is rethrown after the
/// running calls have ended.
template <typename Visit>
void in_task_ranges(std::size_t count, std::size_t fewest, const Visit& visit) {
  FirstException exception;
  const auto run = [&](const tbb::blocked_range<std::size_t>& range) {
    const TaskOrder::Task task;
    exception.call([&] { visit(range.begin(), range.end()); });
  };
  {
    const TaskOrder::Sending sending;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, fewest), run);
  }
  exception.rethrow();
}

/// Calls visit(i) for the numbers below `count`, in the same way.
template <typename Visit>
void in_tasks(std::size_t count, const Visit& visit) {
  in_task_ranges(count, 1, [&visit](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) visit(i);
  });
}

/// Sorts on all processors. Under the thread sanitizer, which cannot see the synchronization, on
/// one.
template <typename Iterator, typename Less>
void sort_in_tasks(Iterator begin, Iterator end, const Less& less) {
#ifdef __SANITIZE_THREAD__
  std::sort(begin, end, less);
#else
  tbb::parallel_sort(begin, end, less);
#endif
}

}  // namespace asos
