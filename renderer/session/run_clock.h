#pragma once

#include "renderer/session/render_session.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>

namespace asos {

/// Measures a run: its duration without pauses, its work in processor time, and the estimated end.
/// Any thread.
class RunClock {
 public:
  /// Starts to measure the pace of the work; only the first call counts.
  void begin_forecast();
  /// Records a finished piece of work after this processor time, and the expected one of all
  /// further work; none: as before, less this piece. A `guess` may be wrong by a factor of ten: it
  /// is good enough for the order of a percentage, but not for a time.
  void count(double seconds, std::optional<double> left, bool guess = false);
  /// Call when all pixels are final. Stops the clock, as `close` does.
  void complete();
  /// Call when no more pixels will become final. Stops the clock, too.
  void fail();
  /// Call when the workers have ended.
  void close();

  void pause();
  void resume();
  /// Waits for `resume`, if there was a pause; false once `stop` is requested.
  [[nodiscard]] bool wait_while_paused(const std::stop_token& stop);

  [[nodiscard]] Progress progress() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Pace {
    Clock::time_point time;
    double seconds;  // processor time of all workers
  };

  void record_pace();
  [[nodiscard]] double seconds_left(Clock::time_point now) const;

  const Clock::time_point start_ = Clock::now();

  mutable std::mutex mutex_;
  std::condition_variable_any resumed_;
  std::atomic<bool> paused_ = false;  // changed under the mutex
  Clock::time_point paused_since_;
  Clock::duration rested_{0};      // duration of earlier pauses
  double done_ = 0.0;              // processor seconds
  std::optional<double> left_;     // processor seconds
  bool guess_ = false;             // left_ is one
  mutable double fraction_ = 0.0;  // last reported; never decreases
  std::deque<Pace> pace_;          // of the last seconds
  bool complete_ = false;
  bool failed_ = false;
  bool closed_ = false;
  Clock::time_point end_;
};

}  // namespace asos
