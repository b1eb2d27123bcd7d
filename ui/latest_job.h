#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace asos::ui {

/// Whether the outcome of a request counts if a newer request came while it was computed.
enum class Overtaken { dropped, kept };

/// Works on the newest request on its own thread. A request that is replaced before it is started
/// is never worked on. The destructor waits for running work. `work` runs on that thread, as does
/// `wake` (may be empty), which is called when an outcome is ready.
template <typename Request, typename Outcome>
class LatestJob {
 public:
  using Work = std::function<Outcome(const Request&)>;

  LatestJob(Work work, std::function<void()> wake, Overtaken overtaken)
      : work_(std::move(work)),
        wake_(std::move(wake)),
        overtaken_(overtaken),
        thread_([this](const std::stop_token& stop) { run(stop); }) {}

  void ask(Request request) {
    {
      const std::scoped_lock lock(mutex_);
      if (overtaken_ == Overtaken::dropped) outcome_.reset();
      request_ = std::move(request);
    }
    requested_.notify_one();
  }

  /// Returns the newest outcome, once.
  [[nodiscard]] std::optional<Outcome> take_outcome() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(outcome_, std::nullopt);
  }

  /// Whether a request is waiting or running, or an outcome has not been taken.
  [[nodiscard]] bool pending() const {
    const std::scoped_lock lock(mutex_);
    return request_ || working_ || outcome_;
  }

 private:
  void run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      std::optional<Request> request;
      {
        std::unique_lock lock(mutex_);
        if (!requested_.wait(lock, stop, [this] { return request_.has_value(); })) return;
        request = std::exchange(request_, std::nullopt);
        working_ = true;
      }
      Outcome outcome = work_(*request);
      {
        const std::scoped_lock lock(mutex_);
        working_ = false;
        if (request_ && overtaken_ == Overtaken::dropped) continue;
        outcome_ = std::move(outcome);
      }
      if (wake_) wake_();
    }
  }

  Work work_;
  std::function<void()> wake_;
  Overtaken overtaken_;
  mutable std::mutex mutex_;
  std::condition_variable_any requested_;
  std::optional<Request> request_;  // not begun
  bool working_ = false;
  std::optional<Outcome> outcome_;
  std::jthread thread_;  // last, so that the thread stops before the members it uses are destroyed
};

}  // namespace asos::ui
