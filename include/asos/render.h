#pragma once

#include "asos/error.h"
#include "asos/picture.h"
#include "asos/scene.h"
#include "asos/settings.h"

#include <functional>
#include <optional>
#include <stop_token>

namespace asos::api {

struct Progress {
  bool running = false;
  bool paused = false;
  bool finished = false;                    ///< every pixel is final
  bool failed = false;                      ///< no more pixels will become final: lack of memory
  double fraction = 0.0;                    ///< of the forecast work, 0 to 1
  double seconds = 0.0;                     ///< of rendering, without pauses
  std::optional<double> seconds_left = {};  ///< estimate; none: not known yet
};

struct RenderOptions {
  /// Called about ten times a second, and at the end, from the thread that called `render`.
  std::function<void(const Progress&)> on_progress = {};
  /// A request to stop ends `render` with `cancelled` within some hundredths of a second.
  std::stop_token stop = {};
  /// Seconds of rendering, at least 0: the best picture of that time. None: to the end.
  std::optional<double> time_limit_seconds = {};
};

/// Renders a picture and waits for it. The pixels depend on neither threads nor time, but for a
/// time limit. May be called from any thread, several at once. Fails with `invalid_argument`
/// (settings, camera), `cannot_open` (the sky's file), `unsupported`, `cancelled` or
/// `out_of_memory`.
[[nodiscard]] ASOS_API Result<Picture> render(const Scene& scene, const Camera& camera,
                                              const Settings& settings,
                                              const RenderOptions& options = {});

}  // namespace asos::api
