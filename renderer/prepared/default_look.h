#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/settings/background.h"
#include "renderer/settings/choices.h"
#include "renderer/shading/sky.h"

#include <glm/glm.hpp>

#include <memory>

namespace asos {

/// The default look of a scene.
struct DefaultLook {
  std::shared_ptr<const Sky> sky;  ///< null: the neutral one
  Ground ground = Ground::off;
};

/// Returns the default look. A scene without its own lights stands on the ground in the environment
/// `softboxes`. An interior, and a scene seen from below, has no ground. Other scenes have the
/// neutral sky.
[[nodiscard]] DefaultLook default_look(const RenderScene& scene, const Camera& camera);
/// Returns the look for the file's first camera, or for the one that frames the scene.
[[nodiscard]] DefaultLook default_look(const RenderScene& scene);

/// Returns the ground of the default look of a scene whose hierarchy is not built yet. `dark`: the
/// scene itself has almost no light. A camera within its bounds is taken for that of an interior.
[[nodiscard]] Ground likely_ground(const World& world, bool dark, const Camera& camera);

/// Returns the default background of a sky. For environments with panels, which would distract
/// behind a model, it is the radiance of the ground far from the default lights, so that the ground
/// has no visible rim. For others it is the sky itself.
[[nodiscard]] Background default_background(const Sky* sky);

}  // namespace asos
