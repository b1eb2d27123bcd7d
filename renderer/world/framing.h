#pragma once

#include "renderer/world/world.h"

namespace asos {

/// The fraction of the tighter direction of a picture that a framed scene fills.
inline constexpr double framed_share = 0.9;

/// A camera that frames a whole scene.
struct FramedView {
  Camera camera;
  double subject_distance = 1.0;  ///< from the eye to the depth of the scene's centre; above 0
};

/// Moves `camera`, without turning it, so that `world` is centred in its picture and fills
/// `framed_share` of it across or down, whichever is tighter. For an orthographic camera, sets the
/// height, too. A scene without extent is framed as if it were a unit cube; an invalid aspect ratio
/// counts as 1.
[[nodiscard]] FramedView frame_world(const World& world, const Camera& camera, double aspect_ratio);

/// Returns a perspective camera's distance from `pivot`, or the height of an orthographic one's
/// picture. All of `world` stays within `framed_share` of the picture while the camera looks at
/// `pivot` and turns about the vertical axis (+Y) through it. Exact for all angles.
[[nodiscard]] double room_to_turn(const World& world, const Camera& camera, glm::dvec3 pivot,
                                  double aspect_ratio);

/// Adds the surfaces of `other`, which has the same origin, to those that framing `world` uses, so
/// that a scene at several times is framed as one. `world` is unusable for other purposes
/// afterwards. Neither may have placed meshes.
void frame_also(World& world, const World& other);

}  // namespace asos
