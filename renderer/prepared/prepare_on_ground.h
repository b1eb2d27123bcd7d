#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/scene/scene.h"

#include <functional>
#include <memory>

namespace asos {

/// The ground that a scene is built with.
struct GroundChoice {
  Ground ground = Ground::off;
  const World* as = nullptr;  ///< as in put_on_ground
};

/// Chooses the ground of a flattened scene. `dark`: the scene itself has almost no light
/// (AnimationInvariants::has_default_lighting).
using ChooseGround = std::function<GroundChoice(const World& world, bool dark)>;

/// Prepares a scene that stands on a ground from the beginning: the same as `prepare` followed by
/// with_ground, but its hierarchies are built once. The ground may be missing: with_ground adds it
/// then. Null: no ground.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> prepare_on_ground(
    const Scene& scene, const RenderFeatures& forced, const AnimationInvariants* stage,
    const ChooseGround& choose);

}  // namespace asos
