#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/settings/background.h"
#include "renderer/settings/choices.h"
#include "renderer/shading/sky.h"

#include <glm/glm.hpp>

#include <memory>

namespace asos {

/// How a scene is shown where nobody chose otherwise.
struct DefaultLook {
  std::shared_ptr<const Sky> sky;  ///< null: the neutral one
  Ground ground = Ground::off;
};

/// A scene without lights of its own stands on the ground in the environment `softboxes`; an
/// interior, and a scene seen from below, has no ground. Other scenes have the neutral sky.
[[nodiscard]] DefaultLook default_look(const RenderScene& scene, const Camera& camera);
/// The same for the file's first camera, or the one that frames the scene.
[[nodiscard]] DefaultLook default_look(const RenderScene& scene);

/// The background of a sky where nobody chose otherwise: a grey gradient for environments with
/// panels, whose parts would distract behind a model; the sky itself for others.
[[nodiscard]] Background default_background(const Sky* sky);

}  // namespace asos
