#pragma once

#include "app/opened_scene.h"
#include "app/render_arguments.h"

#include <optional>
#include <vector>

namespace asos {

/// One of the pictures to render.
struct FrameRequest {
  std::optional<CameraTurn> turn;
  std::optional<int> of_clip;    ///< its number in an animation
  std::optional<ClipTime> time;  ///< see OpenedScene::time
};

/// The pictures that the command line selects: one, or several frames.
[[nodiscard]] std::vector<FrameRequest> frames_of(const RenderArguments& arguments,
                                                  const SceneContents& contents,
                                                  const std::optional<ClipTime>& time);

/// The first of these pictures, without its time, which is known only with the scene.
[[nodiscard]] FrameRequest first_frame(const RenderArguments& arguments);

/// The arguments of this picture alone, with its camera and file names.
[[nodiscard]] RenderArguments arguments_of(const RenderArguments& arguments,
                                           const FrameRequest& frame);

/// Number of `frames` after the end of their animation.
[[nodiscard]] std::size_t beyond_the_end(const std::vector<FrameRequest>& frames,
                                         const SceneContents& contents);

}  // namespace asos
