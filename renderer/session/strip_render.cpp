#include "renderer/session/strip_render.h"

#include "renderer/comparison/method.h"
#include "renderer/session/work_plan.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>

namespace asos {
namespace {

constexpr std::chrono::milliseconds report_step{100};

/// Whole groups, so that none is rendered for two strips.
int rows_of(int width, int strip_pixels) {
  return std::max(1, strip_pixels / width / group_size) * group_size;
}

/// Lets workers wake who collects their tiles.
class Knock {
 public:
  void knock() {
    const std::scoped_lock lock(mutex_);
    knocked_ = true;
    condition_.notify_one();
  }
  void wait() {
    std::unique_lock lock(mutex_);
    condition_.wait_for(lock, report_step, [this] { return knocked_; });
    knocked_ = false;
  }

 private:
  std::mutex mutex_;
  std::condition_variable condition_;
  bool knocked_ = false;
};

}  // namespace

Result<StripsEnd> render_strips(const Snapshot& snapshot, PictureWriter& writer,
                                const std::stop_token& stop,
                                const std::function<void(double)>& on_progress, int strip_pixels) {
  if (const auto valid = validated(snapshot.settings); !valid) return unexpected(valid.error());
  if (const auto able = check_method(*snapshot.scene, snapshot.settings); !able)
    return unexpected(able.error());
  const PixelRect whole = snapshot.settings.visible();
  Knock knock;
  RenderSession session([&knock] { knock.knock(); });
  const int bottom = whole.y + whole.height;
  for (int y = whole.y; y < bottom;) {
    // Strips end where groups do, whatever the crop begins with.
    const int rows = rows_of(whole.width, strip_pixels);
    const PixelRect strip{whole.x, y, whole.width, std::min(bottom, (y / rows + 1) * rows) - y};
    Snapshot part = snapshot;
    part.settings.crop = strip;
    part.progressive = false;
    session.restart(std::move(part));
    Film film(strip.width, strip.height);
    for (bool finished = false; !finished;) {
      knock.wait();
      if (stop.stop_requested()) return StripsEnd::stopped;
      const Progress progress = session.progress();
      finished = progress.finished;
      for (const FinishedTile& tile : session.take_finished()) film.put(tile);
      if (on_progress) on_progress((y - whole.y + progress.fraction * strip.height) / whole.height);
    }
    if (const auto written = writer.add_rows(film.radiance); !written)
      return unexpected(written.error());
    y += strip.height;
  }
  return StripsEnd::finished;
}

}  // namespace asos
