#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"

#include <cstdint>
#include <memory>
#include <span>

namespace asos {

/// Returns the scene as it was prepared: with its own lights and defocusing ratios.
[[nodiscard]] std::shared_ptr<const RenderScene> without_edits(
    const std::shared_ptr<const RenderScene>& scene);

/// Returns a scene without the objects whose flags are set, and without their light. `hidden` has
/// one flag for each part that is an object (objects_without_ground). Origin, ground and default
/// lighting stay, so that nothing else changes. The result shares hierarchies and marks of
/// coplanar surfaces with `whole`; rays pass through hidden surfaces. `rig`: Geometry::rig of the
/// result. Lines and points have to be drawn again (with_lines). Errors: lack of memory.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> without_objects(
    const std::shared_ptr<const RenderScene>& whole, std::span<const std::uint8_t> hidden,
    std::shared_ptr<PosableScene> rig);

}  // namespace asos
