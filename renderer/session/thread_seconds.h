#pragma once

#include <ctime>

namespace asos {

/// Returns the processor time of the calling thread, in seconds; unaffected by other threads.
[[nodiscard]] inline double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace asos
