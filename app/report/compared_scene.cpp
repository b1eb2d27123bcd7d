#include "app/report/compared_scene.h"

#include "app/camera_choice.h"
#include "renderer/prepared/with_lines.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <utility>

namespace asos {

Result<ComparedScene> compared_scene(OpenedScene& opened, const std::optional<ClipTime>& time,
                                     const PictureArguments& wanted, const StudyPlan& plan,
                                     const StudyLook& look) {
  PictureDescription picture;
  picture.render_features = plan.render_features;
  picture.settings.sky = look.opened_sky;
  auto ready = opened.at(time, picture);
  if (!ready) return tl::unexpected(ready.error());
  if ((*ready)->world().shows_nothing())
    return tl::unexpected(Error{wanted.scene, "the scene is empty: there is nothing to compare"});
  const auto camera = opened.camera((*ready)->world(), wanted.camera,
                                    static_cast<double>(plan.width) / plan.height);
  if (!camera) return tl::unexpected(camera.error());
  return with_lines(*std::move(ready), {*camera, plan.height, RenderSettings{}.line_width})
      .and_then(with_boundaries)
      .map([&](std::shared_ptr<const RenderScene> scene) {
        return ComparedScene{std::move(scene), *camera};
      });
}

std::string utc_now() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

}  // namespace asos
