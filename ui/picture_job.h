#pragma once

#include "renderer/film/image_io.h"
#include "renderer/result.h"
#include "renderer/session/render_session.h"

#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace asos::ui {

/// A picture to be rendered into a file.
struct PictureOrder {
  Snapshot snapshot;
  std::string path;  ///< an EXR where it ends in .exr, else a PNG
  DisplayTransform display;
  ImageText text;
};

/// Renders the picture in bounded memory. The path, or why not; nothing where it was stopped.
[[nodiscard]] std::optional<Result<std::string>> write_picture(
    const PictureOrder& order, const std::stop_token& stop,
    const std::function<void(double)>& on_progress);

/// Writes a picture of any size, or a movie, on threads of its own. One at a time; one controlling
/// thread. The destructor cancels.
class PictureJob {
 public:
  /// The path that was written, or why not; nothing where it was stopped. Tells the finished share.
  using Work = std::function<std::optional<Result<std::string>>(
      const std::stop_token&, const std::function<void(double)>&)>;

  /// Cancels what is under way. `path` names the file in the meantime.
  void start(std::string path, Work work);
  /// Leaves nothing of the file.
  void cancel();

  struct State {
    std::string path;
    double fraction = 0.0;       ///< finished, 0 to 1
    double seconds_left = -1.0;  ///< negative: not known yet
  };
  /// The state of the picture that is under way.
  [[nodiscard]] std::optional<State> state() const;
  /// Whether a picture is under way, or its outcome has not been taken.
  [[nodiscard]] bool pending() const;
  /// The file that was written, or why it was not; once. Nothing of one that was cancelled.
  [[nodiscard]] std::optional<Result<std::string>> take_outcome();

 private:
  void run(const std::stop_token& stop, const Work& work);

  std::string path_;
  std::chrono::steady_clock::time_point start_;
  mutable std::mutex mutex_;
  bool running_ = false;
  double fraction_ = 0.0;
  std::optional<Result<std::string>> outcome_;
  std::jthread thread_;  // last: stops before what it uses goes
};

}  // namespace asos::ui
