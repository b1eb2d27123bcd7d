#pragma once

#include "renderer/world/world.h"

namespace asos {

/// The share of the tighter of its two directions that a scene takes in a picture that frames it.
inline constexpr double framed_share = 0.9;

/// A camera that frames a whole scene.
struct FramedView {
  Camera camera;
  double subject_distance = 1.0;  ///< from its eye to the depth of the scene's middle; above 0
};

/// Moves `camera`, without turning it, so that what its picture of this shape shows of all of
/// `world` is in the picture's middle and takes `framed_share` of it across or down, whichever is
/// tighter. An orthographic camera gets the height that does it, too. A scene without extent is
/// framed as if it were a unit cube; an aspect ratio that is none counts as 1.
[[nodiscard]] FramedView frame_world(const World& world, const Camera& camera, double aspect_ratio);

/// How far from `pivot` a perspective camera that looks at it has to be, or how high the picture of
/// an orthographic one, for all of `world` to stay within `framed_share` of the picture while the
/// camera turns about the vertical (+Y) through `pivot`: exactly, whatever the angle.
[[nodiscard]] double room_to_turn(const World& world, const Camera& camera, glm::dvec3 pivot,
                                  double aspect_ratio);

/// Adds the surfaces of `other`, which has the same origin, to those that framing `world` looks at:
/// the scene at several times is framed as one. `world` is good for nothing else then. Neither may
/// have placed meshes.
void frame_also(World& world, const World& other);

}  // namespace asos
