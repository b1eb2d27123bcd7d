#pragma once

#include <ctime>

namespace asos::test {

/// CPU time in seconds of all threads of this process. Unlike wall-clock time, other load does not
/// increase it.
inline double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace asos::test
