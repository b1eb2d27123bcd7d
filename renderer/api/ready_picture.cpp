#include "renderer/api/ready_picture.h"

#include "renderer/api/convert.h"
#include "renderer/api/scene_impl.h"
#include "renderer/comparison/method.h"
#include "renderer/geometry/validate_camera.h"
#include "renderer/prepared/default_look.h"
#include "renderer/prepared/environment_lights.h"
#include "renderer/prepared/exposure.h"
#include "renderer/prepared/with_ground.h"
#include "renderer/prepared/with_lines.h"
#include "renderer/session/film_render.h"
#include "renderer/settings/setting_table.h"
#include "renderer/settings/value_text.h"
#include "renderer/shading/sky_choice.h"

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

/// Sets the named layers. "all" is all of them.
Result<void> set_layers(const std::vector<std::string>& names, RenderSettings& to) {
  for (const std::string& name : names) {
    const auto layer = parse_layers(name);
    if (!layer) return failure(ErrorCode::invalid_argument, layer.error());
    for (const asos::Layer one : layer->layers()) to.layers.insert(one);
  }
  return {};
}

constexpr const char* dfr_name = "dfr";

Result<void> set_more(const std::map<std::string, std::string>& more, RenderSettings& to) {
  for (const auto& [name, text] : more) {
    if (name == dfr_name) {
      const auto dfr = parse_dfr(text);
      if (!dfr) return wrong_setting(name, dfr.error().message());
      to.mirror.dfr = *dfr;
      continue;
    }
    const SettingRow* row = find_setting(name);
    if (!row) return wrong_setting(name, "there is no such setting");
    const auto value = row->parse(text);
    if (!value) return wrong_setting(name, value.error().message());
    row->set(to, *value);
  }
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
  to.shutter.seconds = from.shutter_seconds;
  to.seed = from.seed;
  to.threads = from.threads;
  const Result<ToneCurve> curve = curve_of(from.tone);
  if (!curve) return curve.error();
  if (auto set = set_layers(from.layers, to); !set) return set.error();
  if (auto set = set_more(from.more, to); !set) return set.error();
  to = judged_by(to, *curve);
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
    const DefaultLook look = scene.relit() ? DefaultLook{} : default_look(*scene.scene, camera);
    if (look.sky)
      to.sky = std::make_shared<const Sky>(
          look.sky->turned(from.sky_turn_deg).brightened(from.sky_brightness));
    if (from.ground == Ground::automatic) to.ground = look.ground;
    return {};
  }
  auto choice = parse_sky(from.sky);
  if (!choice) return wrong_setting("sky", choice.error().message());
  choice->turn_deg = from.sky_turn_deg;
  choice->brightness = from.sky_brightness;
  auto sky = make_sky(*choice);
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
    case Background::blurred:
      to.background.kind = BackgroundKind::blurred;
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

/// Gives a scene the light, ground and lines of a picture. `as`: another moment of it, which stands
/// on its ground.
asos::Result<std::shared_ptr<const RenderScene>> completed(std::shared_ptr<const RenderScene> scene,
                                                           bool relit, const asos::Camera& camera,
                                                           const RenderSettings& settings,
                                                           const World* as = nullptr) {
  asos::Result<std::shared_ptr<const RenderScene>> lit = std::move(scene);
  if (!relit) lit = lit_under(*lit, settings.sky.get());
  if (lit) lit = with_ground(*std::move(lit), settings.ground, as);
  if (lit) lit = with_lines(*std::move(lit), line_picture(camera, settings));
  return lit;
}

/// The scene while the shutter is open.
asos::Result<std::shared_ptr<const RenderScene>> in_motion(
    const std::shared_ptr<const RenderScene>& scene, const Scene::Impl& of,
    const asos::Camera& camera, const RenderSettings& settings) {
  if (!settings.shutter.blurs() || !row_of(settings.method).takes_motion) return scene;
  const auto at = [&](const ClipTime& time, const std::shared_ptr<MeshStore>& meshes) {
    const auto ground = [&](const World&, bool) {
      return GroundChoice{settings.ground, &scene->world()};
    };
    auto moment = scene_at(of, time, ground, meshes);
    if (!moment) return moment;
    const asos::Camera then =
        camera_at(camera, settings.shutter.camera, scene->world(), (*moment)->world());
    return completed(*std::move(moment), of.relit(), then, settings, &scene->world());
  };
  return exposed(scene, camera, settings, at, needs_boundaries(settings.method));
}

/// The scene at the picture's moment.
Result<std::shared_ptr<const RenderScene>> at_its_moment(const Scene& scene,
                                                         const RenderSettings& settings) {
  const std::shared_ptr<const RenderScene>& ready = scene.impl().scene;
  if (!settings.shutter.blurs() || ready->geometry->time) return ready;
  Result<Scene> beginning = scene.at(0.0);
  if (!beginning)
    return wrong_setting("shutter_seconds", "the scene has no animations, so nothing moves");
  return beginning->impl().scene;
}

SettingInfo info_of(const SettingRow& row) {
  SettingInfo info{row.key, row.about, row.text_of(row.usual()), {}, row.lo, row.hi};
  if (row.kind == SettingKind::flag) info.choices = {"on", "off"};
  if (row.kind == SettingKind::choice) info.choices.assign(row.names.begin(), row.names.end());
  return info;
}

}  // namespace

std::vector<SettingInfo> setting_list() {
  std::vector<SettingInfo> list;
  for (const SettingRow& row : setting_table()) list.push_back(info_of(row));
  list.push_back({dfr_name,
                  "One DFR for all mirrors, as MIN,MAX,N: DFR = MIN + (MAX - MIN) sin(alpha)^N at "
                  "the angle of incidence alpha (CGF'98 section 5.1)",
                  "",
                  {},
                  0.0,
                  0.0});
  return list;
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const MethodRow& row : method_table()) names.emplace_back(row.name);
  return names;
}

Result<ReadyPicture> ready_picture(const Scene& scene, const Camera& camera,
                                   const Settings& settings) {
  Result<RenderSettings> wanted = settings_of(settings);
  if (!wanted) return wanted.error();
  Result<std::shared_ptr<const RenderScene>> at = at_its_moment(scene, *wanted);
  if (!at) return at.error();
  const std::shared_ptr<const RenderScene>& ready = *at;
  if (camera.follows >= static_cast<int>(ready->world().cameras.size()))
    return wrong_setting("camera.follows", "the scene has no such camera");
  wanted->shutter.camera = std::max(camera.follows, -1);
  const asos::Camera seen = camera_of(camera, ready->world().origin);
  if (std::string fault = validate_camera(seen); !fault.empty())
    return failure(ErrorCode::invalid_argument, "camera '" + camera.name + "'", std::move(fault));
  if (auto set = set_surroundings(settings, scene.impl(), seen, *wanted); !set) return set.error();
  if (auto set = set_background(settings, *wanted); !set) return set.error();
  auto lit = completed(ready, scene.impl().relit(), seen, *wanted);
  if (lit) lit = in_motion(*lit, scene.impl(), seen, *wanted);
  if (!lit) return failure(ErrorCode::out_of_memory, lit.error());
  if (const auto able = check_method(**lit, *wanted); !able)
    return failure(ErrorCode::unsupported, able.error());
  return ReadyPicture{{*std::move(lit), seen, *std::move(wanted)}, *curve_of(settings.tone)};
}

Result<ToneCurve> curve_of(Tone tone) {
  constexpr std::array curves{ToneCurve::none, ToneCurve::neutral, ToneCurve::agx};
  if (tone < Tone::none || tone > Tone::agx) return wrong_setting("tone", "there is no such curve");
  return curves[static_cast<std::size_t>(tone)];
}

Progress progress_of(const asos::Progress& progress) {
  Progress of{progress.running,  progress.paused,  progress.finished, progress.failed,
              progress.fraction, progress.seconds, std::nullopt};
  if (progress.seconds_left >= 0.0) of.seconds_left = progress.seconds_left;
  return of;
}

}  // namespace asos::api
