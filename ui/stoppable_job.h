#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace asos::ui {

/// Runs one piece of work at a time on its own thread. The work can publish intermediate results
/// and can be asked to stop. Only the destructor waits for it. All members must be called from one
/// controlling thread.
template <typename Outcome>
class StoppableJob {
 public:
  using Tell = std::function<void(Outcome)>;
  using Work = std::function<void(const std::stop_token&, const Tell&)>;

  /// Only while not busy.
  void start(Work work) {
    thread_ = {};  // the previous work has ended
    {
      const std::scoped_lock lock(mutex_);
      outcome_.reset();
      working_ = true;
    }
    thread_ = std::jthread([this, work = std::move(work)](const std::stop_token& stop) {
      work(stop, [this](Outcome outcome) {
        const std::scoped_lock lock(mutex_);
        outcome_ = std::move(outcome);
      });
      const std::scoped_lock lock(mutex_);
      working_ = false;
    });
  }
  void stop() { thread_.request_stop(); }
  /// Whether a stop was requested.
  [[nodiscard]] bool stopping() const { return thread_.get_stop_token().stop_requested(); }
  [[nodiscard]] bool busy() const {
    const std::scoped_lock lock(mutex_);
    return working_;
  }
  /// Whether the work is running, or its last result has not been taken.
  [[nodiscard]] bool pending() const {
    const std::scoped_lock lock(mutex_);
    return working_ || outcome_;
  }
  /// Returns the last published result, once.
  [[nodiscard]] std::optional<Outcome> take_outcome() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(outcome_, std::nullopt);
  }

 private:
  mutable std::mutex mutex_;
  bool working_ = false;
  std::optional<Outcome> outcome_;
  std::jthread thread_;  // last, so that the thread stops before the members it uses are destroyed
};

}  // namespace asos::ui
