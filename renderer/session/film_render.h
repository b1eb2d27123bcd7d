#pragma once

#include "renderer/session/render_session.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>

namespace asos {

/// Renders snapshots without coarse passes, one after the other, each into a film that the calling
/// thread waits for: what all that render without a window have in common.
class FilmRender {
 public:
  FilmRender();

  /// The whole picture, or nothing once `go_on`, which is asked some dozens of times a second, says
  /// no, or where the scene's boundaries could not be found. `on_progress` is called about ten
  /// times a second, and at the end. Either may be empty; both are called from this thread.
  [[nodiscard]] std::optional<RenderResult> render(
      Snapshot snapshot, const std::function<bool()>& go_on,
      const std::function<void(const Progress&)>& on_progress);

 private:
  void wait_for_tiles();

  // Workers notify these when there are tiles.
  std::mutex mutex_;
  std::condition_variable condition_;
  bool knocked_ = false;
  RenderSession session_;
};

}  // namespace asos
