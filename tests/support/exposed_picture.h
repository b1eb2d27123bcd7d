#pragma once

#include "renderer/comparison/method.h"
#include "renderer/prepared/exposure.h"
#include "renderer/prepared/focus.h"
#include "renderer/scene/posable_scene.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

namespace asos::test {

/// Poses a scene by a function of the time; the scene has one animation.
class PosedBy final : public PosableScene, public std::enable_shared_from_this<PosedBy> {
 public:
  using Pose = std::function<void(double seconds, Scene& scene)>;
  PosedBy(Scene scene, double end, Pose pose)
      : scene_(std::move(scene)), end_(end), pose_(std::move(pose)) {
    scene_.contents.animations = {{"motion", end, 1, 1}};
  }

  Result<Scene> pose(const std::optional<ClipTime>& time) override {
    Scene posed = scene_;
    pose_(time ? std::clamp(time->seconds, 0.0, end_) : 0.0, posed);
    posed.time = time;
    posed.rig = shared_from_this();
    return posed;
  }

 private:
  Scene scene_;
  double end_;
  Pose pose_;
};

/// A scene with its exposure, and the camera relative to its origin.
struct ExposedScene {
  std::shared_ptr<const RenderScene> scene;
  Camera camera;

  [[nodiscard]] const Exposure& exposure() const { return *scene->exposure; }
};

/// The scene at a time with its exposure; `camera`: in the author's coordinates.
inline ExposedScene exposed_at(PosedBy& rig, double seconds, Camera camera,
                               const RenderSettings& settings) {
  const auto rest = prepare(*rig.pose(std::nullopt));
  EXPECT_TRUE(rest) << rest.error().message();
  const auto at = [&](const ClipTime& time, const std::shared_ptr<MeshStore>& meshes) {
    AnimationInvariants stage = (*rest)->geometry->stage;
    stage.meshes = meshes;
    return prepare(*rig.pose(time), {}, &stage);
  };
  const auto scene = at(ClipTime{0, seconds}, nullptr);
  EXPECT_TRUE(scene) << scene.error().message();
  camera.world_from_camera[3] -= glm::dvec4((*scene)->world().origin, 0.0);
  const auto found = exposed(*scene, camera, settings, at);
  EXPECT_TRUE(found) << found.error().message();
  return {*found, camera};
}

/// The picture over the exposure.
inline Picture render_exposed(const ExposedScene& shown, const RenderSettings& settings) {
  const RenderScene& scene = *shown.scene;
  const Camera viewed = viewed_camera(scene, shown.camera, settings);
  const View view(viewed, settings.width, settings.height);
  const auto motion = moving_picture(scene, viewed, settings);
  const int side = block_side(settings);
  Picture picture{Film(settings.width, settings.height), {}};
  for (int y = 0; y < settings.height; y += side) {
    for (int x = 0; x < settings.width; x += side) {
      const PixelRect rect{x, y, std::min(side, settings.width - x),
                           std::min(side, settings.height - y)};
      const BlockResult block =
          render_block({scene, view, settings, rect, {}, motion ? &*motion : nullptr});
      picture.film.put(block.tile);
      picture.statistics += block.statistics;
    }
  }
  return picture;
}

/// The picture of the middle moment.
inline Picture render_still(const ExposedScene& shown, const RenderSettings& settings) {
  return render_picture(*shown.scene, shown.camera, settings);
}

}  // namespace asos::test
