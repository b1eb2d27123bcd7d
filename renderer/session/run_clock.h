#pragma once

#include "renderer/session/render_session.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <stop_token>

namespace asos {

/// The time that a run takes: how long it has lasted without its rests, how fast its blocks come,
/// and when all will be there. Any thread.
class RunClock {
 public:
  /// Starts, for that many blocks of the final pass.
  explicit RunClock(std::size_t blocks) : blocks_(blocks) {}

  /// The final pass begins; only the first call counts.
  void begin_final_pass();
  /// A block of the final pass is finished.
  void count_block();
  /// All pixels are final. Time stands still from here, as after `close`.
  void complete();
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
    std::size_t blocks;
  };

  [[nodiscard]] double seconds_left(Clock::time_point now) const;

  const std::size_t blocks_;
  const Clock::time_point start_ = Clock::now();

  mutable std::mutex mutex_;
  std::condition_variable_any resumed_;
  std::atomic<bool> paused_ = false;  // changed under the mutex
  Clock::time_point paused_since_;
  Clock::duration rested_{0};  // before
  std::size_t finished_blocks_ = 0;
  std::deque<Pace> pace_;  // of the last seconds
  bool complete_ = false;
  bool closed_ = false;
  Clock::time_point end_;
};

}  // namespace asos
