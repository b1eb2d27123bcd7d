#pragma once

#include "app/values.h"
#include "renderer/geometry/camera_fit.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"
#include "renderer/settings/settings.h"
#include "renderer/world/world.h"

#include <optional>
#include <string>

namespace asos {

/// A frame of a turn of `count` frames around a scene.
struct CameraTurn {
  int frame = 0;
  int count = 1;
};

/// Values of a camera's lens from the command line, in place of its own.
struct LensChoice {
  std::optional<double> radius, f_stop, focus, turn_deg;
  std::optional<int> blades;

  [[nodiscard]] bool any() const { return radius || f_stop || focus || turn_deg || blades; }
};

/// Which camera the command line asks for. At most one of `index` and `look_at` is set; where
/// neither is, it is the file's first camera, or one that frames the scene.
struct CameraChoice {
  std::optional<int> index;
  std::optional<LookAt> look_at;    ///< in the author's coordinates
  std::optional<Camera> given{};    ///< where neither is set; relative to World::origin
  std::optional<double> fov_y_deg;  ///< in place of a perspective camera's own
  CameraFit fit = CameraFit::fit;   ///< of a camera of the file, with its own vertical angle
  bool planes = true;               ///< its near and far planes cut the scene
  LensChoice lens{};
  std::optional<CameraTurn> turn{};  ///< about what it looks at, or else the scene's middle
};

/// The camera for a picture of `aspect_ratio` (width over height), relative to the world's origin.
/// Fails where the file has no such camera, or a field of view or a lens is asked of an
/// orthographic one.
[[nodiscard]] Result<Camera> choose_camera(const World& world, const CameraChoice& choice,
                                           double aspect_ratio);

/// Says that a camera of the file is shown with another vertical angle than its own, so that it
/// fits the picture; empty: it is not.
[[nodiscard]] std::string fit_remark(const World& world, const CameraChoice& choice,
                                     double aspect_ratio);

/// A remark where the camera's lens, or an option for it, has no effect; empty: none.
[[nodiscard]] std::string lens_remark(const Camera& camera, const LensChoice& lens, Method method);

/// Says that the picture lacks what the camera cuts off (Camera::near_depth and far_depth), as far
/// as a grid of rays meets it; empty: it meets nothing of that.
[[nodiscard]] std::string planes_remark(const RenderScene& scene, const Camera& camera,
                                        const RenderSettings& settings);

}  // namespace asos
