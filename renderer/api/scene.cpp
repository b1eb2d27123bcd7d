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

// Finds the moment that the options choose; `seconds` is set.
Result<ClipTime> moment_of(const SceneContents& contents, const std::string& source,
                           const std::string& animation, double seconds) {
  if (!(seconds >= 0.0 && std::isfinite(seconds)))
    return failure(ErrorCode::invalid_argument, "seconds", "is not 0 or more");
  if (contents.animations.empty())
    return failure(ErrorCode::invalid_argument, source, "has no animations");
  std::optional<std::string> wanted;
  if (!animation.empty()) wanted = animation;
  const auto time = clip_time(contents, source, {wanted, seconds});
  if (!time) return failure(ErrorCode::invalid_argument, time.error());
  return time->value();
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
    wanted.keep_posable = true;
    const asos::Result<asos::Scene> read = load_scene(path, wanted);
    if (!read) return failure(ErrorCode::cannot_open, read.error());
    auto prepared = prepare(*read);
    if (!prepared) return failure(ErrorCode::cannot_open, prepared.error());
    const Scene at_rest(std::make_shared<const Impl>(Impl{*std::move(prepared), {}, true}));
    if (!options.seconds) return at_rest;
    return at_rest.at(*options.seconds, options.animation);
  });
}

asos::Result<std::shared_ptr<const RenderScene>> under_lights(
    const std::shared_ptr<const RenderScene>& scene, const std::vector<asos::Light>& lights) {
  std::vector<asos::Light> all = lights;
  for (asos::Light& light : all) light.position -= scene->world().origin;
  for (const asos::Light& light : scene->own_lighting->lights)
    if (light.own_part >= 0) all.push_back(light);
  return with_lights(scene, std::move(all));
}

// The default lighting and the numerical scale are those of the scene at rest, so that they do not
// change with the time.
asos::Result<std::shared_ptr<const RenderScene>> scene_at(
    const Scene::Impl& like, const ClipTime& time, const ChooseGround& choose,
    const std::shared_ptr<MeshStore>& meshes) {
  const Geometry& geometry = *like.scene->geometry;
  const asos::Result<asos::Scene> posed = geometry.rig->pose(time);
  if (!posed) return unexpected(posed.error());
  AnimationInvariants stage = geometry.stage;
  stage.meshes = meshes;
  auto moved = prepare_on_ground(*posed, {}, &stage, choose);
  if (moved && like.relit()) moved = under_lights(*moved, *like.given_lights);
  return moved;
}

Result<Scene> Scene::at(double seconds, const std::string& animation) const {
  return guarded("scene", [&]() -> Result<Scene> {
    const Geometry& geometry = *impl_->scene->geometry;
    const Result<ClipTime> time = moment_of(geometry.contents, geometry.source, animation, seconds);
    if (!time) return time.error();
    auto moved = scene_at(*impl_, *time);
    if (!moved) return failure(ErrorCode::cannot_open, moved.error());
    return Scene(std::make_shared<const Impl>(
        Impl{*std::move(moved), impl_->given_lights, impl_->from_file}));
  });
}

Result<Scene> Scene::with_lights(std::span<const Light> lights) const {
  return guarded("lights", [&]() -> Result<Scene> {
    std::vector<asos::Light> all;
    for (const Light& light : lights) {
      Result<asos::Light> converted = light_of(light);
      if (!converted) return converted.error();
      all.push_back(*std::move(converted));
    }
    auto relit = under_lights(impl_->scene, all);
    if (!relit) return failure(ErrorCode::invalid_argument, relit.error());
    return Scene(
        std::make_shared<const Impl>(Impl{*std::move(relit), std::move(all), impl_->from_file}));
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
  for (const asos::Camera& camera : world.cameras) {
    cameras.push_back(camera_of(camera, world.origin));
    cameras.back().follows = static_cast<int>(cameras.size()) - 1;
  }
  return cameras;
}

Camera Scene::default_camera(double aspect_ratio) const {
  const World& world = impl_->scene->world();
  const double aspect = aspect_ratio > 0.0 && std::isfinite(aspect_ratio) ? aspect_ratio : 1.0;
  if (!world.cameras.empty()) return fitted(cameras().front(), aspect);
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
