#include "renderer/api/ready_picture.h"

#include "renderer/api/convert.h"
#include "renderer/api/scene_impl.h"
#include "renderer/comparison/method.h"
#include "renderer/geometry/validate_camera.h"
#include "renderer/prepared/default_look.h"
#include "renderer/prepared/environment_lights.h"
#include "renderer/prepared/with_ground.h"
#include "renderer/prepared/with_lines.h"
#include "renderer/session/film_render.h"
#include "renderer/shading/environments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace asos::api {
namespace {

Error wrong_setting(std::string name, std::string reason) {
  return failure(ErrorCode::invalid_argument, std::move(name), std::move(reason));
}

ToneCurve curve_of(Tone tone) {
  constexpr std::array curves{ToneCurve::none, ToneCurve::neutral, ToneCurve::agx};
  return curves[static_cast<std::size_t>(tone)];
}

Result<Method> method_of(const std::string& name) {
  for (const MethodRow& row : method_table())
    if (name == row.name) return row.value;
  return wrong_setting("method", "there is no method '" + name + "'");
}

/// Sets the crop, or says why there is no such part of the picture.
std::string set_crop(const Settings& from, RenderSettings& to) {
  if (!from.crop) return {};
  const Rect& r = *from.crop;
  if (r.x < 0 || r.y < 0 || r.width < 1 || r.height < 1 || r.x > from.width - r.width ||
      r.y > from.height - r.height)
    return fmt::format("{},{},{},{} is no part of the picture of {}x{} pixels", r.x, r.y, r.width,
                       r.height, from.width, from.height);
  to.crop = {r.x, r.y, r.width, r.height};
  return {};
}

Result<RenderSettings> settings_of(const Settings& from) {
  RenderSettings to;
  const Result<Method> method = method_of(from.method);
  if (!method) return method.error();
  to.method = *method;
  to.width = from.width;
  to.height = from.height;
  to.asos.max_level = from.max_level;
  to.asos.eps = from.eps;
  to.sampling.spp = from.samples;
  to.texture.resolution = from.texture_resolution;
  to.shadow.cast = from.shadows;
  to.shadow.sky = from.sky_shadows;
  to.shadow.bounces = from.bounces;
  to.mirror.bounces = from.reflections;
  to.seed = from.seed;
  to.threads = from.threads;
  if (from.tone < Tone::none || from.tone > Tone::agx)
    return wrong_setting("tone", "there is no such curve");
  to = judged_by(to, curve_of(from.tone));
  if (auto valid = validated(to); !valid)
    return failure(ErrorCode::invalid_argument, valid.error());
  if (std::string fault = set_crop(from, to); !fault.empty())
    return wrong_setting("crop", std::move(fault));
  if (const auto fits = check_picture_fits(to); !fits)
    return failure(ErrorCode::out_of_memory, fits.error());
  return to;
}

/// Finds the sky and the ground that the settings ask for. Without a choice they follow the scene's
/// default look, or DefaultLook{} if the caller has replaced the lights.
Result<void> set_surroundings(const Settings& from, const Scene::Impl& scene,
                              const asos::Camera& camera, RenderSettings& to) {
  if (!(std::isfinite(from.sky_turn_deg))) return wrong_setting("sky_turn_deg", "is not finite");
  if (!(from.sky_brightness >= 0.0 && from.sky_brightness <= SkyChoice::most_brightness))
    return wrong_setting(
        "sky_brightness",
        fmt::format("{} is not from 0 to {}", from.sky_brightness, SkyChoice::most_brightness));
  if (from.ground < Ground::automatic || from.ground > Ground::mirror)
    return wrong_setting("ground", "there is no such ground");
  constexpr std::array grounds{asos::Ground::off, asos::Ground::off, asos::Ground::on,
                               asos::Ground::mirror};
  to.ground = grounds[static_cast<std::size_t>(from.ground)];
  if (from.sky.empty()) {
    const DefaultLook look = scene.relit ? DefaultLook{} : default_look(*scene.scene, camera);
    if (look.sky)
      to.sky = std::make_shared<const Sky>(
          look.sky->turned(from.sky_turn_deg).brightened(from.sky_brightness));
    if (from.ground == Ground::automatic) to.ground = look.ground;
    return {};
  }
  if (from.sky == "neutral") return {};
  SkyChoice choice;
  choice.turn_deg = from.sky_turn_deg;
  choice.brightness = from.sky_brightness;
  const auto known = std::find_if(environments.begin(), environments.end(),
                                  [&](const EnvironmentRow& row) { return from.sky == row.name; });
  if (known != environments.end())
    choice.environment = known->value;
  else
    choice.file = from.sky;
  auto sky = make_sky(choice);
  if (!sky) return failure(ErrorCode::cannot_open, sky.error());
  to.sky = *std::move(sky);
  return {};
}

Result<void> set_background(const Settings& from, RenderSettings& to) {
  switch (from.background) {
    case Background::automatic:
      to.background = default_background(to.sky.get());
      break;
    case Background::environment:
      to.background.kind = BackgroundKind::environment;
      break;
    case Background::transparent:
      to.background.kind = BackgroundKind::transparent;
      break;
    case Background::colours:
      to.background.kind = BackgroundKind::colours;
      to.background.top = vector_of(from.background_top);
      to.background.bottom = vector_of(from.background_bottom);
      break;
    default:
      return wrong_setting("background", "there is no such background");
  }
  if (auto valid = validated(to); !valid)
    return failure(ErrorCode::invalid_argument, valid.error());
  return {};
}

}  // namespace

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const MethodRow& row : method_table()) names.emplace_back(row.name);
  return names;
}

Result<ReadyPicture> ready_picture(const Scene& scene, const Camera& camera,
                                   const Settings& settings) {
  Result<RenderSettings> wanted = settings_of(settings);
  if (!wanted) return wanted.error();
  std::shared_ptr<const RenderScene> ready = scene.impl().scene;
  const asos::Camera seen = camera_of(camera, ready->world().origin);
  if (std::string fault = validate_camera(seen); !fault.empty())
    return failure(ErrorCode::invalid_argument, "camera '" + camera.name + "'", std::move(fault));
  if (auto set = set_surroundings(settings, scene.impl(), seen, *wanted); !set) return set.error();
  if (auto set = set_background(settings, *wanted); !set) return set.error();
  asos::Result<std::shared_ptr<const RenderScene>> lit = ready;
  if (!scene.impl().relit) lit = lit_under(ready, wanted->sky.get());
  if (lit) lit = with_ground(*std::move(lit), wanted->ground);
  if (lit) lit = with_lines(*std::move(lit), line_picture(seen, *wanted));
  if (!lit) return failure(ErrorCode::out_of_memory, lit.error());
  if (const auto able = check_method(**lit, *wanted); !able)
    return failure(ErrorCode::unsupported, able.error());
  return ReadyPicture{{*std::move(lit), seen, *std::move(wanted)}, curve_of(settings.tone)};
}

Progress progress_of(const asos::Progress& progress) {
  Progress of{progress.running,  progress.paused,  progress.finished, progress.failed,
              progress.fraction, progress.seconds, std::nullopt};
  if (progress.seconds_left >= 0.0) of.seconds_left = progress.seconds_left;
  return of;
}

}  // namespace asos::api
