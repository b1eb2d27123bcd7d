#include "app/render_job.h"

#include <fmt/format.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <unistd.h>

namespace asos {
namespace {

// Interval at which the progress bar and interrupts are updated while no tiles arrive.
constexpr std::chrono::milliseconds patience{100};

// Wakes the thread that collects tiles from the workers' callback.
class Bell {
 public:
  void ring() {
    const std::lock_guard lock(mutex_);
    rung_ = true;
    condition_.notify_one();
  }
  void wait(std::chrono::milliseconds at_most) {
    std::unique_lock lock(mutex_);
    condition_.wait_for(lock, at_most, [this] { return rung_; });
    rung_ = false;
  }

 private:
  std::mutex mutex_;
  std::condition_variable condition_;
  bool rung_ = false;
};

}  // namespace

Result<void> check_picture_fits(const RenderSettings& settings) {
  const PixelRect part = settings.visible();
  // Memory per pixel: radiance, level, pending tiles, and the encoder's copy.
  constexpr double bytes_a_pixel = 40.0;
  const double needed =
      bytes_a_pixel * static_cast<double>(part.width) * static_cast<double>(part.height);
  const double present =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (needed <= present) return {};
  return tl::unexpected(
      Error{fmt::format("{}x{} pixels", part.width, part.height),
            fmt::format("this needs about {:.0f} GB of memory, and the machine has {:.0f} GB",
                        needed / 1e9, present / 1e9)});
}

std::optional<RenderedPicture> run_render_job(Snapshot snapshot, ProgressBar& bar,
                                              const InterruptGuard& interrupt,
                                              std::optional<double> time_limit_seconds) {
  const PixelRect part = snapshot.settings.visible();
  RenderedPicture picture;
  picture.threads = worker_count(snapshot.settings.threads);
  picture.film = Film(part.width, part.height);

  Bell bell;
  RenderSession session([&bell] { bell.ring(); });
  snapshot.progressive = time_limit_seconds.has_value();
  session.restart(std::move(snapshot));
  const auto collect = [&] {
    for (const FinishedTile& tile : session.take_finished()) picture.film.put(tile);
  };
  const auto past_limit = [&](const Progress& progress) {
    return time_limit_seconds && progress.seconds >= *time_limit_seconds &&
           session.reached().pass != Reached::Pass::nothing;
  };
  auto drawn = std::chrono::steady_clock::now();
  for (bool finished = false; !finished;) {
    bell.wait(time_limit_seconds ? patience / 5 : patience);
    // Read before the tiles are taken, so that the last tiles are not missed.
    const Progress progress = session.progress();
    if (interrupt.interrupted() || progress.failed) {
      session.cancel();
      return std::nullopt;
    }
    finished = progress.finished;
    collect();
    if (!finished && past_limit(progress)) {
      session.cancel();
      collect();
      // The workers may have finished meanwhile.
      if (!session.progress().finished) picture.stopped_at = session.reached();
      break;
    }
    if (const auto now = std::chrono::steady_clock::now(); now - drawn >= patience) {
      bar.show(progress);
      drawn = now;
    }
  }
  session.wait();  // which stops the clock
  picture.seconds = session.progress().seconds;
  picture.statistics = session.statistics();
  bar.wipe();
  return picture;
}

}  // namespace asos
