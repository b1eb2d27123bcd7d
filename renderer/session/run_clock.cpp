#include "renderer/session/run_clock.h"

#include <algorithm>

namespace asos {
namespace {

constexpr std::chrono::milliseconds pace_step{100};
constexpr std::chrono::milliseconds forecast_step{50};
constexpr std::chrono::seconds pace_window{10};
constexpr std::chrono::milliseconds pace_enough{250};

double seconds(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

}  // namespace

void RunClock::leave_out(std::size_t pass) {
  const std::lock_guard lock(mutex_);
  forecast_.leave_out(pass);
  made_.reset();
}

void RunClock::guess(std::size_t pass) {
  const std::lock_guard lock(mutex_);
  forecast_.guess(pass);
}

void RunClock::begin_forecast() {
  const std::lock_guard lock(mutex_);
  if (pace_.empty()) pace_.push_back({Clock::now(), 0.0});
}

void RunClock::count_block(std::size_t pass, std::size_t block, double seconds) {
  const std::lock_guard lock(mutex_);
  forecast_.add(pass, block, seconds);
  record_pace();
}

void RunClock::count_step(double seconds, std::optional<double> left) {
  const std::lock_guard lock(mutex_);
  forecast_.add(seconds);
  left_ = left;
  record_pace();
}

// The caller holds the mutex. Records the pace of the last seconds, which reflects the processors
// that are available.
void RunClock::record_pace() {
  const Clock::time_point now = Clock::now();
  if (now - pace_.back().time < pace_step) return;
  pace_.push_back({now, forecast_.seconds_done()});
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

// The caller holds the mutex. Subtracts the work done since the latest forecast. Forecasts again
// after forecast_step, or once a quarter of the forecast work is done.
std::optional<double> RunClock::work_left(Clock::time_point now) const {
  constexpr double most_of_it = 0.25;
  if (left_) return left_;
  const double done = forecast_.seconds_done();
  const bool holds = made_ && made_->left && now - made_->time < forecast_step &&
                     done - made_->done <= most_of_it * *made_->left;
  if (!holds) made_ = Forecast{forecast_.seconds_left(), done, now};
  if (!made_->left) return std::nullopt;
  return *made_->left - (done - made_->done);
}

// The caller holds the mutex. A guessed growth is good enough for the order of a percentage, but
// not for a time.
double RunClock::seconds_left(Clock::time_point now) const {
  if (complete_) return 0.0;
  if (pace_.empty() || closed_ || (!left_ && forecast_.guesses())) return -1.0;
  const std::optional<double> left = work_left(now);
  const double passed = seconds(now - pace_.front().time);
  const double done = forecast_.seconds_done() - pace_.front().seconds;
  if (!left || passed < seconds(pace_enough) || done <= 0.0) return -1.0;
  return *left * passed / done;
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
  const double done = forecast_.seconds_done();
  if (complete_) {
    fraction_ = 1.0;
  } else if (const std::optional<double> left = work_left(now); left && done > 0.0) {
    fraction_ = std::max(fraction_, done / (done + *left));
  }
  progress.fraction = fraction_;
  progress.seconds = std::max(0.0, seconds(now - start_ - rested_));
  progress.seconds_left = seconds_left(now);
  return progress;
}

}  // namespace asos
