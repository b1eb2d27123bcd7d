#include "asos/scene.h"

#include "renderer/api/convert.h"
#include "renderer/api/scene_impl.h"
#include "renderer/gltf/load.h"
#include "renderer/scene/clip_choice.h"
#include "renderer/scene/posable_scene.h"
#include "renderer/world/ground.h"

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace asos::api {

namespace {

// Prepares a scene at the moment that the options choose. The default lighting and the numerical
// scale are those of the scene at rest, so that they do not change with the time.
Result<std::shared_ptr<const RenderScene>> prepared_at(const std::string& path,
                                                       const asos::Scene& at_rest,
                                                       const LoadOptions& options) {
  auto prepared = prepare(at_rest);
  if (!prepared) return failure(ErrorCode::cannot_open, prepared.error());
  if (!options.seconds) return *std::move(prepared);
  if (!(*options.seconds >= 0.0 && std::isfinite(*options.seconds)))
    return failure(ErrorCode::invalid_argument, "seconds", "is not 0 or more");
  if (!at_rest.rig) return failure(ErrorCode::invalid_argument, path, "has no animations");
  std::optional<std::string> animation;
  if (!options.animation.empty()) animation = options.animation;
  const auto time = clip_time(at_rest.contents, path, {animation, options.seconds});
  if (!time) return failure(ErrorCode::invalid_argument, time.error());
  const asos::Result<asos::Scene> posed = at_rest.rig->pose(*time);
  if (!posed) return failure(ErrorCode::cannot_open, posed.error());
  auto moved = prepare(*posed, {}, &(*prepared)->geometry->stage);
  if (!moved) return failure(ErrorCode::cannot_open, moved.error());
  return *std::move(moved);
}

}  // namespace

Scene::Scene(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
Scene::Scene(const Scene&) = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(const Scene&) = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;

Result<Scene> Scene::load(const std::string& path, const LoadOptions& options) {
  return guarded("scene", [&]() -> Result<Scene> {
    asos::LoadOptions wanted;
    wanted.scene = options.scene;
    wanted.variant = options.variant;
    wanted.asset_root = options.asset_root;
    wanted.keep_posable = options.seconds.has_value();
    const asos::Result<asos::Scene> read = load_scene(path, wanted);
    if (!read) return failure(ErrorCode::cannot_open, read.error());
    auto prepared = prepared_at(path, *read, options);
    if (!prepared) return prepared.error();
    return Scene(std::make_shared<const Impl>(Impl{*std::move(prepared), false, true}));
  });
}

Result<Scene> Scene::with_lights(std::span<const Light> lights) const {
  return guarded("lights", [&]() -> Result<Scene> {
    const RenderScene& scene = *impl_->scene;
    std::vector<asos::Light> all;
    for (const Light& light : lights) {
      Result<asos::Light> converted = light_of(light);
      if (!converted) return converted.error();
      converted->position -= scene.world().origin;
      all.push_back(*std::move(converted));
    }
    // Luminous surfaces go on shining.
    for (const asos::Light& light : scene.own_lighting->lights)
      if (light.own_part >= 0) all.push_back(light);
    auto relit = asos::with_lights(impl_->scene, std::move(all));
    if (!relit) return failure(ErrorCode::invalid_argument, relit.error());
    return Scene(std::make_shared<const Impl>(Impl{*std::move(relit), true, impl_->from_file}));
  });
}

std::string Scene::name() const {
  return impl_->scene->geometry->name;
}

std::vector<std::string> Scene::warnings() const {
  return notes_of(*impl_->scene).warnings;
}

std::vector<Camera> Scene::cameras() const {
  std::vector<Camera> cameras;
  const World& world = impl_->scene->world();
  for (const asos::Camera& camera : world.cameras)
    cameras.push_back(camera_of(camera, world.origin));
  return cameras;
}

Camera Scene::default_camera(double aspect_ratio) const {
  const World& world = impl_->scene->world();
  if (!world.cameras.empty()) return camera_of(world.cameras.front(), world.origin);
  const double aspect = aspect_ratio > 0.0 && std::isfinite(aspect_ratio) ? aspect_ratio : 1.0;
  return camera_of(asos::default_camera(world, aspect), world.origin);
}

std::vector<AnimationInfo> Scene::animations() const {
  std::vector<AnimationInfo> all;
  for (const SceneContents::Animation& animation : impl_->scene->geometry->contents.animations)
    all.push_back({animation.name, animation.seconds});
  return all;
}

std::uint64_t Scene::triangles() const {
  return triangles_without_ground(impl_->scene->world());
}

}  // namespace asos::api
