#pragma once

#include "asos/render.h"

#include <chrono>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace asos::api {

/// Renders in the background, coarse pixels first, and hands out tiles as they come. All members
/// but constructor and destructor may be called from any thread at once.
class ASOS_API Session {
 public:
  /// `on_tiles` is called from a worker thread when tiles wait, and at the end of a render. It must
  /// neither throw nor call the session.
  explicit Session(std::function<void()> on_tiles = {});
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  /// Cancels the render and waits for its workers.
  ~Session();

  /// Cancels the running render and starts a new one. Blocks until the former workers have stopped.
  /// Fails as `render` does; the former render is cancelled only on success.
  Result<void> start(const Scene& scene, const Camera& camera, const Settings& settings);
  /// Starts the last render anew in other light. Fails with `invalid_argument` for a light that is
  /// not valid, or before `start`.
  Result<void> relight(std::span<const Light> lights);
  /// Stops the workers and waits for them. Tiles that are ready stay.
  void cancel();
  /// Holds back final pixels until `resume`; coarse ones still come.
  void pause();
  void resume();

  [[nodiscard]] Progress progress() const;
  /// Waits until tiles are ready or the render has ended. Returns false after `timeout`.
  [[nodiscard]] bool wait(std::chrono::milliseconds timeout);

  /// Copies the tiles that have come since the last call into `rgb`: linear R, G, B of the picture
  /// (or crop), row by row from the top left. Returns their rectangles; each tile is handed out
  /// once. Fails with `invalid_argument` unless `rgb` has 3 * width * height values.
  [[nodiscard]] Result<std::vector<Rect>> take_tiles(std::span<float> rgb);
  /// Returns all that was rendered so far. Hands out no tile. Fails with `invalid_argument` before
  /// `start`.
  [[nodiscard]] Result<Picture> picture() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace asos::api
