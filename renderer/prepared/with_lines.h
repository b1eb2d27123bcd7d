#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"

#include <memory>

namespace asos {

/// Returns the properties of a picture that lines and points depend on.
[[nodiscard]] inline LinePicture line_picture(const Camera& camera,
                                              const RenderSettings& settings) {
  return {camera, settings.height, settings.line_width};
}

/// Returns the scene with its lines and points drawn for a picture (draw_lines), replacing those
/// for an earlier one. Returns the same scene if it has none, or if none were or are drawn. Shares
/// materials and lighting with `scene`; its boundaries are unknown again. Errors: more
/// triangles than a scene may have, lack of memory.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> with_lines(
    std::shared_ptr<const RenderScene> scene, const LinePicture& picture);

}  // namespace asos
