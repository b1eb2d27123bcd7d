#pragma once

#include "renderer/geometry/camera_fit.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"
#include "renderer/settings/settings.h"
#include "renderer/settings/value_text.h"
#include "renderer/world/world.h"

#include <optional>
#include <string>

namespace asos {

/// A frame of a turntable of `count` frames around a scene.
struct CameraTurn {
  int frame = 0;
  int count = 1;
};

/// Lens parameters from the command line that replace the camera's own.
struct LensChoice {
  std::optional<double> radius, f_stop, focus, turn_deg;
  std::optional<int> blades;

  [[nodiscard]] bool any() const { return radius || f_stop || focus || turn_deg || blades; }
};

/// The camera that the command line selects. At most one of `index` and `look_at` is set. Without
/// either it is the file's first camera, or one that frames the scene.
struct CameraChoice {
  std::optional<int> index;
  std::optional<LookAt> look_at;    ///< in the author's coordinates
  std::optional<Camera> given{};    ///< used if neither is set; relative to World::origin
  std::optional<double> fov_y_deg;  ///< replaces a perspective camera's own
  CameraFit fit = CameraFit::fit;   ///< for cameras of the file
  bool planes = true;               ///< near and far planes clip the scene
  LensChoice lens{};
  std::optional<CameraTurn> turn{};  ///< about the camera's subject, or else the scene's centre
};

/// Returns the camera for a picture of `aspect_ratio` (width over height), relative to the world's
/// origin. Fails if the file has no such camera, or if a field of view or a lens is set for an
/// orthographic one.
[[nodiscard]] Result<Camera> choose_camera(const World& world, const CameraChoice& choice,
                                           double aspect_ratio);

/// A note if the picture shows a camera of the file with a changed vertical field of view to fit
/// the aspect ratio; empty: it does not.
[[nodiscard]] std::string fit_remark(const World& world, const CameraChoice& choice,
                                     double aspect_ratio);

/// A warning if the camera's lens, or an option for it, has no effect, or if the lens is wider than
/// the distance of its focus plane, so that hardly anything is sharp; empty: none. `camera` is
/// focused.
[[nodiscard]] std::string lens_remark(const Camera& camera, const LensChoice& lens, Method method);

/// A warning if the camera's near or far plane (Camera::near_depth, far_depth) clips surfaces,
/// tested with a grid of rays; empty: no ray meets a clipped surface.
[[nodiscard]] std::string planes_remark(const RenderScene& scene, const Camera& camera,
                                        const RenderSettings& settings);

}  // namespace asos
