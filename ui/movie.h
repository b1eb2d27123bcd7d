#pragma once

#include "renderer/film/tone.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"
#include "renderer/scene/contents.h"
#include "renderer/session/render_session.h"

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace asos::ui {

/// A turntable or an animation to render and save, frame by frame.
struct MovieOrder {
  Snapshot snapshot;  ///< the view of the first frame, or of all frames of an animation
  DisplayTransform display;
  std::string stem;  ///< path without the extension
  bool mp4 = false;  ///< false: numbered PNG files STEM-0000.png and so on
  int frames = 1;
  double fps = 24.0;
  glm::dvec3 middle{0.0};        ///< that a turntable circles
  std::optional<int> animation;  ///< animation to play with a fixed camera; none: a turntable
  /// Edited lights that replace those of every pose of an animation; none: the pose's own.
  std::optional<std::vector<Light>> lights;
  std::optional<MaterialDfrs> dfrs;
};

/// Number of frames of an animation of this length, the first and last included.
[[nodiscard]] int frames_of(double seconds, double fps);

/// Renders the frames and, for an MP4, encodes them with ffmpeg. Returns the path or the error;
/// nothing if it was stopped, which leaves no files. If ffmpeg fails, the frames stay and the error
/// names their folder. `on_progress` gets the finished fraction.
[[nodiscard]] std::optional<Result<std::string>> write_movie(
    const MovieOrder& order, const std::stop_token& stop,
    const std::function<void(double)>& on_progress);

/// Arguments for ffmpeg to encode FOLDER/000000.png and so on into `path`.
[[nodiscard]] std::vector<std::string> ffmpeg_command(const std::string& ffmpeg,
                                                      const std::string& folder, double fps,
                                                      const std::string& path);

}  // namespace asos::ui
