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
#include <stop_token>
#include <utility>
#include <vector>

namespace asos {

/// Measures a run: its duration without pauses, the pace of its blocks, and the estimated end. Any
/// thread.
class RunClock {
 public:
  /// Starts the clock. `growth`: see CostForecast.
  explicit RunClock(std::size_t blocks, std::vector<double> growth = {})
      : forecast_(blocks, std::move(growth)) {}

  /// See CostForecast.
  void leave_out(std::size_t pass);
  void guess(std::size_t pass);
  /// Starts the first pass that is forecast; only the first call counts.
  void begin_forecast();
  /// Records a finished block of a pass, and the worker's processor time for it.
  void count_block(std::size_t pass, std::size_t block, double seconds);
  /// Records a finished step that belongs to no pass, and the expected processor time of all
  /// further ones; none: unknown.
  void count_step(double seconds, std::optional<double> left);
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

  /// The latest forecast. It is kept, since a forecast reads every block, and progress is queried
  /// several times in each frame.
  struct Forecast {
    std::optional<double> left;  // processor seconds
    double done = 0.0;           // processor seconds done by then
    Clock::time_point time;
  };

  void record_pace();
  [[nodiscard]] std::optional<double> work_left(Clock::time_point now) const;
  [[nodiscard]] double seconds_left(Clock::time_point now) const;

  const Clock::time_point start_ = Clock::now();

  mutable std::mutex mutex_;
  std::condition_variable_any resumed_;
  std::atomic<bool> paused_ = false;  // changed under the mutex
  Clock::time_point paused_since_;
  Clock::duration rested_{0};  // duration of earlier pauses
  CostForecast forecast_;
  mutable std::optional<Forecast> made_;  // none: something other than work has changed since
  std::optional<double> left_;            // after the last step that belongs to no pass
  mutable double fraction_ = 0.0;         // last reported; never decreases
  std::deque<Pace> pace_;                 // of the last seconds
  bool complete_ = false;
  bool failed_ = false;
  bool closed_ = false;
  Clock::time_point end_;
};

}  // namespace asos
