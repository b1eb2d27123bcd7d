#pragma once

#include "app/opened_scene.h"
#include "app/render_arguments.h"

#include <optional>
#include <vector>

namespace asos {

/// One of the pictures that a command line asks for.
struct FrameRequest {
  std::optional<CameraTurn> turn;
  std::optional<int> of_clip;    ///< its number in an animation
  std::optional<ClipTime> time;  ///< see OpenedScene::time
};

/// The pictures that the command line asks for: one, unless it asks for frames.
[[nodiscard]] std::vector<FrameRequest> frames_of(const RenderArguments& arguments,
                                                  const SceneContents& contents,
                                                  const std::optional<ClipTime>& time);

/// The first of them, as far as it can be told without the scene.
[[nodiscard]] FrameRequest first_frame(const RenderArguments& arguments);

/// The arguments of this picture alone: where it is seen from, and what it is called.
[[nodiscard]] RenderArguments arguments_of(const RenderArguments& arguments,
                                           const FrameRequest& frame);

/// The pictures of `frames` that are of times beyond the end of their animation.
[[nodiscard]] std::size_t beyond_the_end(const std::vector<FrameRequest>& frames,
                                         const SceneContents& contents);

}  // namespace asos
