#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"

#include <memory>

namespace asos {

/// The picture that `settings` ask of a camera, as far as lines and points are concerned.
[[nodiscard]] inline StrokePicture stroke_picture(const Camera& camera,
                                                  const RenderSettings& settings) {
  return {camera, settings.height, settings.line_width};
}

/// The scene with its lines and points drawn for a picture (draw_strokes), whatever picture they
/// were drawn for before; the same scene where it has none, or is to have none and has had none.
/// Shares materials and lighting with `scene`; its boundaries are looked for anew. Errors: more
/// triangles than a scene may have, lack of memory.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> with_strokes(
    std::shared_ptr<const RenderScene> scene, const StrokePicture& picture);

}  // namespace asos
