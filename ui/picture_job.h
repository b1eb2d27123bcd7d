#pragma once

#include "renderer/film/image_io.h"
#include "renderer/result.h"
#include "renderer/session/render_session.h"

#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace asos {

/// A picture to be rendered into a file.
struct PictureOrder {
  Snapshot snapshot;
  std::string path;  ///< an EXR where it ends in .exr, else a PNG
  DisplayTransform display;
  ImageText text;
};

/// Renders a picture of any size into a file, on threads of its own, in bounded memory. One picture
/// at a time; one controlling thread. The destructor cancels.
class PictureJob {
 public:
  /// Cancels what is under way.
  void start(PictureOrder order);
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
  void run(const std::stop_token& stop, const PictureOrder& order);

  std::string path_;
  std::chrono::steady_clock::time_point start_;
  mutable std::mutex mutex_;
  bool running_ = false;
  double fraction_ = 0.0;
  std::optional<Result<std::string>> outcome_;
  std::jthread thread_;  // last: stops before what it uses goes
};

}  // namespace asos
