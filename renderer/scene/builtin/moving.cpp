#include "renderer/scene/builtin/moving.h"

#include "renderer/scene/not_shown.h"
#include "renderer/scene/posable_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace asos::builtin {

namespace {

class MovingScene final : public PosableScene, public std::enable_shared_from_this<MovingScene> {
 public:
  MovingScene(Scene scene, std::vector<Motion> motions)
      : scene_(std::move(scene)), motions_(std::move(motions)) {}

  Result<Scene> pose(const std::optional<ClipTime>& time) override {
    if (time && time->animation != 0)
      return unexpected(
          Error{scene_.source,
                fmt::format("has 1 animation, so there is no animation {}", time->animation)});
    if (time && !(time->seconds >= 0.0 && std::isfinite(time->seconds)))
      return unexpected(
          Error{scene_.source, fmt::format("cannot be shown at a time of {} s", time->seconds)});
    return posed(time);
  }

  [[nodiscard]] Scene posed(const std::optional<ClipTime>& time) {
    const double end = scene_.contents.animations.front().seconds;
    const double seconds = time ? std::min(time->seconds, end) : 0.0;
    Scene scene = scene_;
    for (const Motion& motion : motions_)
      scene.instances[motion.instance].world_from_mesh = motion.world_from_mesh(seconds);
    scene.time = time;
    scene.notes.not_shown = not_shown(scene.contents, time);
    scene.rig = shared_from_this();
    return scene;
  }

 private:
  const Scene scene_;  // without a rig
  const std::vector<Motion> motions_;
};

}  // namespace

Scene with_animation(Scene scene, std::string name, double seconds, std::vector<Motion> motions) {
  scene.contents.animations = {{std::move(name), seconds, motions.size(), motions.size()}};
  return std::make_shared<MovingScene>(std::move(scene), std::move(motions))->posed(std::nullopt);
}

}  // namespace asos::builtin
