#include "app/exposed_scene.h"

#include "renderer/comparison/method.h"
#include "renderer/prepared/environment_lights.h"
#include "renderer/prepared/exposure.h"
#include "renderer/prepared/with_ground.h"
#include "renderer/prepared/with_lines.h"

#include <utility>

namespace asos {

Result<std::shared_ptr<const RenderScene>> exposed_scene(
    const std::shared_ptr<const RenderScene>& scene, const Camera& camera,
    const RenderSettings& settings, const PictureDescription& picture, const OpenedScene& opened) {
  if (!row_of(settings.method).takes_motion) return scene;
  const auto at = [&](const ClipTime& time, const std::shared_ptr<MeshStore>& meshes) {
    const auto ground = [&](const World&, bool) {
      return GroundChoice{settings.ground, &scene->world()};
    };
    auto moment = opened.posed(time, picture, ground, meshes);
    if (moment && !picture.lights) moment = lit_under(*moment, settings.sky.get());
    if (moment) moment = with_ground(*std::move(moment), settings.ground, &scene->world());
    if (!moment) return moment;
    const Camera then =
        camera_at(camera, settings.shutter.camera, scene->world(), (*moment)->world());
    return with_lines(*moment, line_picture(then, settings));
  };
  return exposed(scene, camera, settings, at, needs_boundaries(settings.method));
}

}  // namespace asos
