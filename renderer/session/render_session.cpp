#include "renderer/session/render_session.h"

#include "renderer/comparison/method.h"
#include "renderer/session/render_run.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <pthread.h>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace asos {

namespace {

// Gives workers a lower priority than the window's thread. Otherwise the window's frames would wait
// for a busy processor, and typing would lag.
void give_way_to_window() {
  constexpr int steps_of_nice = 5;
  const id_t thread = static_cast<id_t>(gettid());
  const int usual = getpriority(PRIO_PROCESS, thread);
  (void)setpriority(PRIO_PROCESS, thread, usual + steps_of_nice);
}

}  // namespace

int worker_count(int threads, bool beside_window) {
  const auto cores = static_cast<int>(std::thread::hardware_concurrency());
  return worker_count_on(cores, threads, beside_window);
}

int worker_count_on(int cores, int threads, bool beside_window) {
  if (threads > 0) return threads;
  return std::max(1, beside_window && cores > 2 ? cores - 1 : cores);
}

/// Belongs to the controlling thread, except for the parts that the run protects itself.
struct RenderSession::State {
  std::function<void()> on_tiles;
  std::optional<RenderRun> run;
  std::vector<std::jthread> workers;
  bool nothing_to_do = false;  ///< the last snapshot was not renderable
  bool paused = false;

  void stop() {
    for (std::jthread& worker : workers) worker.request_stop();
    join();
  }
  void join() {
    workers.clear();
    if (run) run->close();
  }
};

RenderSession::RenderSession(std::function<void()> on_tiles) : state_(std::make_unique<State>()) {
  state_->on_tiles = std::move(on_tiles);
}

RenderSession::~RenderSession() {
  state_->stop();
}

void RenderSession::restart(Snapshot snapshot) {
  state_->stop();
  state_->run.reset();
  state_->nothing_to_do = !snapshot.scene || !validated(snapshot.settings) ||
                          !check_method(*snapshot.scene, snapshot.settings);
  if (state_->nothing_to_do) return;
  const bool beside_window = snapshot.beside_window;
  const int workers = worker_count(snapshot.settings.threads, beside_window);
  RenderRun& run = state_->run.emplace(std::move(snapshot), state_->on_tiles);
  if (state_->paused) run.pause();
  for (int i = 0; i < workers; ++i) {
    state_->workers.emplace_back([&run, beside_window](const std::stop_token& stop) {
      pthread_setname_np(pthread_self(), "asos render");  // name in process monitors
      if (beside_window) give_way_to_window();
      run.work(stop);
    });
  }
}

void RenderSession::pause() {
  state_->paused = true;
  if (state_->run) state_->run->pause();
}

void RenderSession::resume() {
  state_->paused = false;
  if (state_->run) state_->run->resume();
}

void RenderSession::cancel() {
  state_->stop();
}

void RenderSession::wait() {
  for (std::jthread& worker : state_->workers) worker.join();
  state_->join();
}

PixelRect RenderSession::visible() const {
  return state_->run ? state_->run->visible() : PixelRect{};
}

std::vector<FinishedTile> RenderSession::take_finished() {
  if (!state_->run) return {};
  return state_->run->take_finished();
}

Progress RenderSession::progress() const {
  if (state_->run) return state_->run->progress();
  Progress progress;
  progress.finished = state_->nothing_to_do;
  progress.fraction = state_->nothing_to_do ? 1.0 : 0.0;
  return progress;
}

Reached RenderSession::reached() const {
  return state_->run ? state_->run->reached() : Reached{};
}

RenderStatistics RenderSession::statistics() const {
  return state_->run ? state_->run->statistics() : RenderStatistics{};
}

}  // namespace asos
