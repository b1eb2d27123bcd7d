#include "renderer/session/render_session.h"

#include "renderer/comparison/method.h"
#include "renderer/session/coarse_passes.h"
#include "renderer/session/planned_render.h"
#include "renderer/session/render_steps.h"
#include "renderer/session/run_clock.h"
#include "renderer/session/sample_rounds.h"
#include "renderer/session/tile_collector.h"

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

/// The render of one snapshot: the remaining work, the finished tiles, and the speed. Workers call
/// `work` and share nothing else. A session creates one for each restart and drops it after its
/// workers have ended, so that no tile can outlive its snapshot.
class RenderRun {
 public:
  RenderRun(Snapshot snapshot, std::function<void()> on_tiles);

  /// Takes work until none is left or `stop` is requested. Any number of threads.
  void work(const std::stop_token& stop);

  [[nodiscard]] PixelRect visible() const { return render_.plan.visible; }
  [[nodiscard]] std::vector<FinishedTile> take_finished() { return tiles_.take_finished(); }
  [[nodiscard]] Progress progress() const { return clock_.progress(); }
  [[nodiscard]] Reached reached() const;
  [[nodiscard]] RenderStatistics statistics() const { return tiles_.statistics(); }
  /// Pauses all but the coarse passes after the current pieces of work, and resumes them.
  void pause() { clock_.pause(); }
  void resume() { clock_.resume(); }
  void prefer(const PixelRect& part) {
    samples_.prefer(render_.plan, part);
    steps_.prefer(part);
  }
  /// Called after the workers have ended: stops the clock.
  void close() { clock_.close(); }

 private:
  void work_rounds(std::size_t first, const std::stop_token& stop);
  void count(bool finished_picture);

  const PlannedRender render_;
  TileCollector tiles_;
  CoarsePasses coarse_;
  SampleRounds samples_;
  RenderSteps steps_;
  RunClock clock_;
};

RenderRun::RenderRun(Snapshot snapshot, std::function<void()> on_tiles)
    : render_(std::move(snapshot)),
      tiles_(render_.plan, std::move(on_tiles)),
      samples_(render_),
      steps_(render_, samples_) {}

void RenderRun::work(const std::stop_token& stop) {
  if (render_.snapshot.progressive) coarse_.work(render_, tiles_, stop);
  (void)steps_.blocks_can_start(render_);  // begins the search after the first picture
  clock_.begin_forecast();
  const bool own = samples_.make_the_picture();
  if (render_.snapshot.progressive) {
    work_rounds(0, stop);
  } else if (own) {
    work_rounds(samples_.rounds().size() - 1, stop);
  }
  if (own || stop.stop_requested()) return;
  if (render_.snapshot.progressive) {
    if (!samples_.wait_for_rounds(samples_.rounds().size(), stop)) return;
    steps_.begin();
  }
  count(steps_.work(render_, tiles_, clock_, stop));
}

Reached RenderRun::reached() const {
  Reached reached = tiles_.reached();
  if (!render_.snapshot.progressive || reached.pass != Reached::Pass::samples) return reached;
  const std::vector<int>& rounds = samples_.rounds();
  const auto done = std::count_if(rounds.begin(), rounds.end(),
                                  [&](int samples) { return samples <= reached.samples; });
  reached.rounds = static_cast<int>(rounds.size());
  const auto running = static_cast<int>(done) + 1;
  if (running <= reached.rounds)
    reached.round = running;
  else if (samples_.make_the_picture())
    reached.round = reached.rounds;
  return reached;
}

// Once the last tile is published, the picture is complete, and its user is notified.
void RenderRun::count(bool finished_picture) {
  if (!finished_picture) return;
  clock_.complete();
  tiles_.notify();
}

// Steps continue the samples of the rounds, so a worker finds the right order only after the
// others. A picture of samples alone ends soonest without waiting.
void RenderRun::work_rounds(std::size_t first, const std::stop_token& stop) {
  const bool ordered = !samples_.make_the_picture();
  for (std::size_t round = first; round < samples_.rounds().size(); ++round) {
    if (ordered && !samples_.put_what_moves_first(round, stop)) return;
    count(samples_.work(render_, round, tiles_, clock_, stop));
    if (stop.stop_requested()) return;
  }
}

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
  PixelRect preferred;

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
  run.prefer(state_->preferred);
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

void RenderSession::prefer(const PixelRect& part) {
  state_->preferred = part;
  if (state_->run) state_->run->prefer(part);
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
