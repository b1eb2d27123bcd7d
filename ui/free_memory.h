#pragma once

#include "ui/latest_job.h"

#include <malloc.h>

namespace asos::ui {

/// Returns freed memory to the system, on its own thread. glibc keeps it in a heap for each thread,
/// which after a few scenes is several times the memory in use.
class FreeMemory {
 public:
  FreeMemory() : job_(give_back, {}, Overtaken::kept) {}
  void give_back_soon() { job_.ask(0); }
  /// Call once a frame.
  void update() { (void)job_.take_outcome(); }
  [[nodiscard]] bool pending() const { return job_.pending(); }

 private:
  static int give_back(const int&) {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
    return 0;
  }

  LatestJob<int, int> job_;
};

}  // namespace asos::ui
