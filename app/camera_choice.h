#pragma once

#include "app/values.h"
#include "renderer/result.h"
#include "renderer/world/world.h"

#include <optional>

namespace asos {

/// A frame of a turn of `count` frames around a scene.
struct CameraTurn {
  int frame = 0;
  int count = 1;
};

/// Which camera the command line asks for. At most one of `index` and `look_at` is set; where
/// neither is, it is the file's first camera, or one that frames the scene.
struct CameraChoice {
  std::optional<int> index;
  std::optional<LookAt> look_at;     ///< in the author's coordinates
  std::optional<Camera> given{};     ///< where neither is set; relative to World::origin
  std::optional<double> fov_y_deg;   ///< in place of a perspective camera's own
  std::optional<CameraTurn> turn{};  ///< about what it looks at, or else the scene's middle
};

/// The camera for a picture of `aspect_ratio` (width over height), relative to the world's origin.
/// Fails where the file has no such camera, or a field of view is asked of an orthographic one.
[[nodiscard]] Result<Camera> choose_camera(const World& world, const CameraChoice& choice,
                                           double aspect_ratio);

}  // namespace asos
