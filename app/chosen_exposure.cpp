#include "app/chosen_exposure.h"

#include "renderer/comparison/auto_exposure.h"
#include "renderer/prepared/environment_lights.h"

#include <fmt/format.h>

namespace asos {
namespace {

std::string exposure_note(const Metering& metered, bool asked_for) {
  if (metered.stops == 0.0f) return "";
  if (asked_for) return fmt::format("exposure {:+.1f} stops", metered.stops);
  return fmt::format(
      "exposure {:+.1f} stops: the file's lights whiten {:.0f} % of the picture; --exposure 0 "
      "keeps "
      "it",
      metered.stops, 100.0 * metered.whitened);
}

}  // namespace

Result<std::string> choose_exposure(PictureArguments& wanted, OpenedScene& scene,
                                    const PictureDescription& picture) {
  if (wanted.exposure_chosen && !wanted.exposure_metered) return "";
  auto ready = scene.at_rest(picture);
  if (!ready) return tl::unexpected(ready.error());
  if (!wanted.exposure_metered && !exposure_may_follow(**ready)) return "";
  CameraChoice choice = wanted.camera;
  if (wanted.from) choice.given = picture.camera_from((*ready)->world().origin);
  const double aspect = static_cast<double>(wanted.settings.width) / wanted.settings.height;
  const Result<Camera> camera = scene.camera((*ready)->world(), choice, aspect);
  if (!camera) return tl::unexpected(camera.error());
  PictureArguments shown = wanted;
  take_default_look(shown, **ready, *camera);
  if (!picture.lights) ready = lit_under(*ready, shown.settings.sky.get());
  if (!ready) return tl::unexpected(ready.error());
  const Metering metered = wanted.exposure_metered
                               ? meter(**ready, *camera, shown.settings, wanted.tone)
                               : usual_exposure(**ready, *camera, shown.settings, wanted.tone);
  wanted.exposure_ev = metered.stops;
  return exposure_note(metered, wanted.exposure_metered);
}

}  // namespace asos
