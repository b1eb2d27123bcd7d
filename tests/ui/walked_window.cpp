#include "tests/ui/walked_window.h"

#include "ui/gl/gl.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <stdexcept>
#include <thread>

namespace asos::test {
using namespace ui;

namespace {

// Number of frames without events after which the loop is considered stuck.
constexpr int endless = 200;

double wall_seconds() {
  using Clock = std::chrono::steady_clock;
  static const Clock::time_point start = Clock::now();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

WalkedWindow::WalkedWindow(glm::ivec2 size) : size_(size) {
  Result<std::unique_ptr<OsmesaContext>> made = OsmesaContext::make(size.x, size.y);
  if (!made) throw std::runtime_error(made.error().message());
  context_ = std::move(*made);
  // Frames are laid out and uploaded, but not rasterised, which is the driver's work.
  gl::glEnable(GL_RASTERIZER_DISCARD);
  processor_since_ = thread_seconds();
  wall_since_ = wall_seconds();
}

double WalkedWindow::now_seconds() const {
  return wall_seconds() + seconds_per_frame * static_cast<double>(frames_);
}

void WalkedWindow::note_heard() {
  const double processor_ms = 1e3 * (thread_seconds() - processor_since_);
  const double wall_ms = 1e3 * (wall_seconds() - wall_since_);
  most_.frames = std::max(most_.frames, std::exchange(frames_since_, 0));
  if (processor_ms > most_.processor_ms) {
    most_.processor_ms = processor_ms;
    most_.processor_action = action_;
  }
  if (wall_ms > most_.wall_ms) {
    most_.wall_ms = wall_ms;
    most_.wall_action = action_;
  }
}

void WalkedWindow::wait(std::optional<double> seconds) {
  note_heard();
  if (!steps.empty()) {
    const Step step = std::move(steps.front());
    steps.pop_front();
    action_ = step.action;
    step.run(*this);
  } else if (idle) {
    idle(*this);
  }
  // Gives other threads some time, but sleeps no longer, because the next step is input.
  if (!seconds || *seconds > 0.0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  processor_since_ = thread_seconds();
  wall_since_ = wall_seconds();
}

void WalkedWindow::present() {
  ++frames_;
  if (++frames_since_ > endless && give_up) give_up();
}

void WalkedWindow::resize(glm::ivec2 size) {
  size_ = size;
  happened_.needs_redraw = true;
  if (visible() && !context_->resize(size.x, size.y))
    throw std::runtime_error("OSMesa refused the size");
}

}  // namespace asos::test
