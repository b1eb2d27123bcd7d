#pragma once

#include "asos/scene.h"
#include "renderer/prepared/prepare_on_ground.h"
#include "renderer/prepared/render_scene.h"

#include <memory>
#include <optional>
#include <vector>

namespace asos::api {

struct Scene::Impl {
  std::shared_ptr<const RenderScene> scene;
  /// The caller's lights, in the author's coordinates, whatever the sky is; none: its own.
  std::optional<std::vector<asos::Light>> given_lights = {};
  /// The scene comes from a file, so saved pictures contain a description to render them again.
  bool from_file = false;

  [[nodiscard]] bool relit() const { return given_lights.has_value(); }
};

/// Returns the scene with these lights (see Scene::Impl) and its luminous surfaces.
[[nodiscard]] asos::Result<std::shared_ptr<const RenderScene>> under_lights(
    const std::shared_ptr<const RenderScene>& scene, const std::vector<asos::Light>& lights);

/// Returns the scene of a file at another moment of its animations, with the lights of `like`.
/// `choose`, `meshes`: see prepare_on_ground and AnimationInvariants; may be null.
[[nodiscard]] asos::Result<std::shared_ptr<const RenderScene>> scene_at(
    const Scene::Impl& like, const ClipTime& time, const ChooseGround& choose = nullptr,
    const std::shared_ptr<MeshStore>& meshes = nullptr);

}  // namespace asos::api
