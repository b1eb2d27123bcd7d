#include "renderer/session/film_render.h"

#include <fmt/format.h>

#include <chrono>
#include <unistd.h>
#include <utility>

namespace asos {
namespace {

constexpr std::chrono::milliseconds patience{20};
constexpr std::chrono::milliseconds report_step{100};

}  // namespace

FilmRender::FilmRender() : session_([this] { bell_.ring(); }) {}

void FilmRender::collect(Film& film) {
  bell_.quiet();
  for (const FinishedTile& tile : session_.take_finished()) film.put(tile);
}

std::optional<RenderResult> FilmRender::render(
    Snapshot snapshot, const std::function<bool()>& go_on,
    const std::function<void(const Progress&)>& on_progress,
    std::optional<double> time_limit_seconds, const std::function<bool()>& ends_early) {
  using Clock = std::chrono::steady_clock;
  snapshot.progressive = time_limit_seconds.has_value();
  session_.restart(std::move(snapshot));
  RenderResult result;
  const PixelRect visible = session_.visible();
  result.film = Film(visible.width, visible.height);
  const auto past_limit = [&](const Progress& progress) {
    return time_limit_seconds &&
           (progress.seconds >= *time_limit_seconds || (ends_early && ends_early())) &&
           session_.reached().pass != Reached::Pass::nothing;
  };
  auto next_report = Clock::now() + report_step;
  for (bool finished = false; !finished;) {
    // Read before the tiles are taken, which then include everything published up to the end.
    const Progress progress = session_.progress();
    if ((go_on && !go_on()) || progress.failed) {
      session_.cancel();
      return std::nullopt;
    }
    finished = progress.finished;
    collect(result.film);
    if (!finished && past_limit(progress)) {
      session_.cancel();
      collect(result.film);
      // The workers may have come to the end by then.
      if (!session_.progress().finished) result.stopped_at = session_.reached();
      break;
    }
    const Clock::time_point now = Clock::now();
    if (on_progress && (finished || now >= next_report)) {
      on_progress(progress);
      next_report = now + report_step;
    }
    if (!finished) bell_.wait(patience);
  }
  session_.wait();  // which stops the clock
  result.seconds = session_.progress().seconds;
  result.statistics = session_.statistics();
  return result;
}

RenderResult render_to_end(Snapshot snapshot,
                           const std::function<void(const Progress&)>& on_progress) {
  return FilmRender().render(std::move(snapshot), {}, on_progress).value();
}

Result<void> check_picture_fits(const RenderSettings& settings) {
  const PixelRect part = settings.visible();
  // Radiance, level, tiles on their way, and the encoder's copy.
  constexpr double bytes_a_pixel = 40.0;
  const double needed =
      bytes_a_pixel * static_cast<double>(part.width) * static_cast<double>(part.height);
  const double present =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (needed <= present) return {};
  return unexpected(
      Error{fmt::format("{}x{} pixels", part.width, part.height),
            fmt::format("this needs about {:.0f} GB of memory, and the machine has {:.0f} GB",
                        needed / 1e9, present / 1e9)});
}

}  // namespace asos
