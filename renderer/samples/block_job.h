#pragma once

#include "renderer/film/block_result.h"
#include "renderer/geometry/pixel_rect.h"
#include "renderer/geometry/view.h"
#include "renderer/prepared/moving_picture.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/settings/settings.h"

#include <stop_token>

namespace asos {

/// A block of a picture for a method to render, with everything that its pixels may depend on.
/// Stores references.
struct BlockJob {
  const RenderScene& scene;
  const View& view;
  const RenderSettings& settings;
  PixelRect block;  ///< in the whole picture, independent of the crop
  std::stop_token stop = {};
  /// The scene and the view while the shutter is open; null: both stand still.
  const MovingPicture* motion = nullptr;

  /// The same block with other settings.
  [[nodiscard]] BlockJob with(const RenderSettings& other) const {
    return {scene, view, other, block, stop, motion};
  }
  /// The same block at one moment of `motion`.
  [[nodiscard]] BlockJob at(int moment) const {
    return {motion->scene(moment), motion->view(moment), settings, block, stop};
  }
};

}  // namespace asos
