#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace asos {

/// Wakes the threads that wait for a session's tiles. Workers ring it, so it has a mutex of its
/// own.
class TileBell {
 public:
  void ring() {
    const std::lock_guard lock(mutex_);
    ++rings_;
    tiles_wait_ = true;
    condition_.notify_all();
  }
  /// Call before the tiles are taken.
  void quiet() {
    const std::lock_guard lock(mutex_);
    tiles_wait_ = false;
  }
  [[nodiscard]] std::uint64_t rings() {
    const std::lock_guard lock(mutex_);
    return rings_;
  }
  /// Waits until there are tiles or more than `seen` rings. Returns false after `timeout`.
  bool wait(std::uint64_t seen, std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    return condition_.wait_for(lock, timeout, [&] { return tiles_wait_ || rings_ != seen; });
  }
  /// Waits until there are tiles, or for `timeout`.
  void wait(std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    condition_.wait_for(lock, timeout, [&] { return tiles_wait_; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable condition_;
  std::uint64_t rings_ = 0;
  bool tiles_wait_ = false;
};

}  // namespace asos
