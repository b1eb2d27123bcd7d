#pragma once

#include "renderer/session/cost_forecast.h"
#include "renderer/session/render_session.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

namespace asos {

/// The time that a run takes: how long it has lasted without its rests, how fast its blocks come,
/// and when all will be there. Any thread.
class RunClock {
 public:
  /// Starts. See CostForecast.
  explicit RunClock(std::size_t blocks, std::vector<double> growth = {})
      : forecast_(blocks, std::move(growth)) {}

  /// See CostForecast.
  void leave_out(std::size_t pass);
  void set_likeness(std::span<const double> values);
  /// The first pass that is forecast begins; only the first call counts.
  void begin_forecast();
  /// A block of a pass is finished, which took a worker's processor so long.
  void count_block(std::size_t pass, std::size_t block, double seconds);
  /// All pixels are final. Time stands still from here, as after `close`.
  void complete();
  /// No more pixels will be final. Time stands still from here, too.
  void fail();
  /// The workers have ended.
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
    double seconds;  // of processors
  };

  /// The forecast when it was last made: it looks at every block, and progress is asked for several
  /// times in each frame.
  struct Forecast {
    std::optional<double> left;  // seconds of processors
    double done = 0.0;           // the same, by then
    Clock::time_point time;
  };

  [[nodiscard]] std::optional<double> work_left(Clock::time_point now) const;
  [[nodiscard]] double seconds_left(Clock::time_point now) const;

  const Clock::time_point start_ = Clock::now();

  mutable std::mutex mutex_;
  std::condition_variable_any resumed_;
  std::atomic<bool> paused_ = false;  // changed under the mutex
  Clock::time_point paused_since_;
  Clock::duration rested_{0};  // before
  CostForecast forecast_;
  mutable std::optional<Forecast> made_;  // none: something other than work has changed since
  mutable double fraction_ = 0.0;         // that was told: it never goes back
  std::deque<Pace> pace_;                 // of the last seconds
  bool complete_ = false;
  bool failed_ = false;
  bool closed_ = false;
  Clock::time_point end_;
};

}  // namespace asos
