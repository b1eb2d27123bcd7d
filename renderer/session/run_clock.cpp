#include "renderer/session/run_clock.h"

#include "renderer/session/tuning.h"

#include <algorithm>

namespace asos {
namespace {

using namespace tuning;

double seconds(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

}  // namespace

void RunClock::begin_forecast() {
  const std::lock_guard lock(mutex_);
  if (pace_.empty()) pace_.push_back({Clock::now(), 0.0});
}

void RunClock::count(double seconds, std::optional<double> left, bool guess) {
  const std::lock_guard lock(mutex_);
  done_ += seconds;
  if (left) {
    left_ = left;
    guess_ = guess;
  } else if (left_) {
    left_ = std::max(0.0, *left_ - seconds);
  }
  record_pace();
}

// The caller holds the mutex. Records the pace of the last seconds, which reflects the processors
// that are available.
void RunClock::record_pace() {
  const Clock::time_point now = Clock::now();
  if (now - pace_.back().time < pace_step) return;
  pace_.push_back({now, done_});
  while (pace_.size() > 2 && now - pace_[1].time > pace_window) pace_.pop_front();
}

void RunClock::complete() {
  const std::lock_guard lock(mutex_);
  complete_ = true;
  end_ = Clock::now();
}

void RunClock::fail() {
  {
    const std::lock_guard lock(mutex_);
    failed_ = true;
  }
  close();
}

void RunClock::close() {
  const std::lock_guard lock(mutex_);
  if (!complete_ && !closed_) end_ = paused_ ? paused_since_ : Clock::now();
  closed_ = true;
}

void RunClock::pause() {
  const std::lock_guard lock(mutex_);
  if (paused_) return;
  paused_ = true;
  paused_since_ = Clock::now();
}

void RunClock::resume() {
  {
    const std::lock_guard lock(mutex_);
    if (!paused_) return;
    // The clock and the pace continue from their values at the pause.
    const Clock::duration rest = Clock::now() - paused_since_;
    rested_ += rest;
    for (Pace& pace : pace_) pace.time += rest;
    paused_ = false;
  }
  resumed_.notify_all();
}

bool RunClock::wait_while_paused(const std::stop_token& stop) {
  if (paused_) {
    std::unique_lock lock(mutex_);
    resumed_.wait(lock, stop, [this] { return !paused_; });
  }
  return !stop.stop_requested();
}

// The caller holds the mutex.
double RunClock::seconds_left(Clock::time_point now) const {
  if (complete_) return 0.0;
  if (pace_.empty() || closed_ || !left_ || guess_) return -1.0;
  const double passed = seconds(now - pace_.front().time);
  const double done = done_ - pace_.front().seconds;
  if (passed < seconds(least_pace) || done <= 0.0) return -1.0;
  return *left_ * passed / done;
}

Progress RunClock::progress() const {
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = complete_ || closed_ ? end_
                                : paused_            ? paused_since_
                                                     : Clock::now();
  Progress progress;
  progress.finished = complete_;
  progress.failed = failed_;
  progress.paused = paused_ && !complete_ && !closed_;
  progress.running = !complete_ && !closed_ && !paused_;
  if (complete_)
    fraction_ = 1.0;
  else if (left_ && done_ > 0.0)
    fraction_ = std::max(fraction_, done_ / (done_ + *left_));
  progress.fraction = fraction_;
  progress.seconds = std::max(0.0, seconds(now - start_ - rested_));
  progress.seconds_left = seconds_left(now);
  return progress;
}

}  // namespace asos
