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

/// A picture to render into a file.
struct PictureOrder {
  Snapshot snapshot;
  std::string path;  ///< an EXR if it ends in .exr, otherwise a PNG
  DisplayTransform display;
  ImageText text;
};

/// Renders the picture in bounded memory. Returns the path or the error; nothing if it was stopped.
[[nodiscard]] std::optional<Result<std::string>> write_picture(
    const PictureOrder& order, const std::stop_token& stop,
    const std::function<void(double)>& on_progress);

/// Writes a picture of any size, or a movie, on its own threads, one at a time. Must be controlled
/// from one thread. The destructor cancels.
class PictureJob {
 public:
  /// Reports the finished fraction, and returns the path or the error; nothing if it was stopped.
  using Work = std::function<std::optional<Result<std::string>>(
      const std::stop_token&, const std::function<void(double)>&)>;

  /// Cancels the running job and starts another. `path` is the name to show meanwhile.
  void start(std::string path, Work work);
  /// Cancels the running job and leaves no file.
  void cancel();

  struct State {
    std::string path;
    double fraction = 0.0;       ///< finished, 0 to 1
    double seconds_left = -1.0;  ///< negative: not known yet
  };
  /// The state of the running job.
  [[nodiscard]] std::optional<State> state() const;
  /// Whether a job is running, or its outcome has not been taken.
  [[nodiscard]] bool pending() const;
  /// Returns the path or the error, once. Nothing for a cancelled job.
  [[nodiscard]] std::optional<Result<std::string>> take_outcome();

 private:
  void run(const std::stop_token& stop, const Work& work);

  std::string path_;
  std::chrono::steady_clock::time_point start_;
  mutable std::mutex mutex_;
  bool running_ = false;
  double fraction_ = 0.0;
  std::optional<Result<std::string>> outcome_;
  std::jthread thread_;  // last, so that the thread stops before the members it uses are destroyed
};

}  // namespace asos::ui
