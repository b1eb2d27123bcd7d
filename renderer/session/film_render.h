#pragma once

#include "renderer/result.h"
#include "renderer/session/render_session.h"
#include "renderer/session/tile_bell.h"

#include <functional>
#include <optional>

namespace asos {

/// Renders snapshots one after the other, each into a film that the calling thread waits for: used
/// by everything that renders without a window.
class FilmRender {
 public:
  FilmRender();

  /// Returns the whole picture; nullopt once `go_on` returns false, or where the scene's boundaries
  /// could not be found. `go_on` is called some dozens of times a second, `on_progress` about ten
  /// times a second and at the end. Either may be empty; both are called from this thread.
  /// With a limit, in seconds of rendering, the picture comes in passes and is the best of that
  /// time: at least a sample for each block, which takes a fraction of a second. `ends_early`, if
  /// any, ends it before the limit once it returns true; it is called as often as `go_on`.
  [[nodiscard]] std::optional<RenderResult> render(
      Snapshot snapshot, const std::function<bool()>& go_on,
      const std::function<void(const Progress&)>& on_progress,
      std::optional<double> time_limit_seconds = {}, const std::function<bool()>& ends_early = {});

 private:
  void collect(Film& film);

  TileBell bell_;
  RenderSession session_;
};

/// Refuses pictures that this machine's memory cannot hold, before anything is allocated.
[[nodiscard]] Result<void> check_picture_fits(const RenderSettings& settings);

}  // namespace asos
