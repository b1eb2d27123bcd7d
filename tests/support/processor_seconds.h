#pragma once

#include <ctime>

namespace asos::test {

/// Processor time that this process has taken so far, in all of its threads, in seconds: unlike
/// the time on the wall it does not grow because others use the machine.
inline double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace asos::test
