#include "renderer/session/film_render.h"

#include <chrono>
#include <utility>

namespace asos {
namespace {

constexpr std::chrono::milliseconds patience{20};
constexpr std::chrono::milliseconds report_step{100};

}  // namespace

FilmRender::FilmRender()
    : session_([this] {
        const std::lock_guard lock(mutex_);
        knocked_ = true;
        condition_.notify_one();
      }) {}

void FilmRender::wait_for_tiles() {
  std::unique_lock lock(mutex_);
  condition_.wait_for(lock, patience, [this] { return knocked_; });
  knocked_ = false;
}

std::optional<RenderResult> FilmRender::render(
    Snapshot snapshot, const std::function<bool()>& go_on,
    const std::function<void(const Progress&)>& on_progress) {
  using Clock = std::chrono::steady_clock;
  snapshot.progressive = false;
  session_.restart(std::move(snapshot));
  RenderResult result;
  const PixelRect visible = session_.visible();
  result.film = Film(visible.width, visible.height);
  auto next_report = Clock::now() + report_step;
  for (bool finished = false; !finished;) {
    if (go_on && !go_on()) {
      session_.cancel();
      return std::nullopt;
    }
    // Asked before the tiles are taken: what was published up to the end is then among them.
    const Progress progress = session_.progress();
    finished = progress.finished;
    for (const FinishedTile& tile : session_.take_finished()) result.film.put(tile);
    const Clock::time_point now = Clock::now();
    if (on_progress && (finished || now >= next_report)) {
      on_progress(progress);
      next_report = now + report_step;
    }
    if (progress.failed) {
      session_.cancel();
      return std::nullopt;
    }
    if (!finished) wait_for_tiles();
  }
  session_.wait();
  result.seconds = session_.progress().seconds;
  result.statistics = session_.statistics();
  return result;
}

RenderResult render_to_end(Snapshot snapshot,
                           const std::function<void(const Progress&)>& on_progress) {
  return FilmRender().render(std::move(snapshot), {}, on_progress).value();
}

}  // namespace asos
