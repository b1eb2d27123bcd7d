#pragma once

#include "renderer/task_order.h"

#include <algorithm>
#include <cstddef>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

namespace asos {

/// Calls visit(begin, end) for ranges of the numbers below `count`, on all processors and in any
/// order. Each range has at least `fewest` numbers, if there are as many. Returns when all calls
/// are done. If a call throws, the exception is rethrown after the running calls have ended.
template <typename Visit>
void in_task_ranges(std::size_t count, std::size_t fewest, const Visit& visit) {
  const TaskOrder::Sending sending;
  const auto run = [&visit](const tbb::blocked_range<std::size_t>& range) {
    const TaskOrder::Task task;
    visit(range.begin(), range.end());
  };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, fewest), run);
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
