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

/// A turntable or an animation to be saved, frame by frame.
struct MovieOrder {
  Snapshot snapshot;  ///< the view at first, or at all times
  DisplayTransform display;
  std::string stem;  ///< the path without its ending
  bool mp4 = false;  ///< else numbered PNGs: STEM-0000.png and so on
  int frames = 1;
  double fps = 24.0;
  glm::dvec3 middle{0.0};        ///< that a turntable circles
  std::optional<int> animation;  ///< it is played, and the camera stays; none: a turntable
  /// The scene's edits, which each pose of an animation gets; none: the pose's own.
  std::optional<std::vector<Light>> lights;
  std::optional<MaterialDfrs> dfrs;
};

/// The frames of an animation that lasts so long, the first and the last one included.
[[nodiscard]] int frames_of(double seconds, double fps);

/// Renders the frames, and joins them by ffmpeg where an MP4 is wanted. The path that was written,
/// or why not; nothing where it was stopped, which leaves no file. Where ffmpeg fails, the frames
/// stay and the error says where. `on_progress` is told the finished share.
[[nodiscard]] std::optional<Result<std::string>> write_movie(
    const MovieOrder& order, const std::stop_token& stop,
    const std::function<void(double)>& on_progress);

/// The arguments by which ffmpeg makes `path` of FOLDER/000000.png and so on.
[[nodiscard]] std::vector<std::string> ffmpeg_command(const std::string& ffmpeg,
                                                      const std::string& folder, double fps,
                                                      const std::string& path);

}  // namespace asos::ui
