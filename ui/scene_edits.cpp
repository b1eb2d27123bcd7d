#include "ui/scene_edits.h"

#include "renderer/prepared/default_look.h"
#include "renderer/prepared/environment_lights.h"
#include "renderer/world/ground.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asos::ui {

namespace {

/// The window always renders whole pictures.
RenderSettings without_crop(RenderSettings settings) {
  settings.crop = {};
  return settings;
}

std::vector<EditedLight> lights_to_edit(const std::vector<Light>& of_scene) {
  std::vector<EditedLight> lights;
  for (const Light& light : of_scene) {
    lights.push_back(EditedLight::of(light));
    lights.back().source = static_cast<int>(lights.size()) - 1;
  }
  return lights;
}

// Lights of a saved picture count as added, except those of the scene's own surfaces.
std::vector<EditedLight> lights_of_picture(const std::vector<Light>& of_picture,
                                           const std::vector<EditedLight>& own) {
  std::vector<EditedLight> lights = lights_to_edit(of_picture);
  for (EditedLight& edited : lights) {
    const int part = edited.light.own_part;
    const auto same = std::find_if(own.begin(), own.end(), [&](const EditedLight& light) {
      return part >= 0 && light.light.own_part == part;
    });
    edited.source = same == own.end() ? -1 : same->source;
  }
  return lights;
}

std::vector<std::string> material_names(const World& world) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < materials_without_ground(world); ++i)
    names.push_back(world.materials[i].name);
  return names;
}

}  // namespace

SceneEdits::SceneEdits(OpenScene& scene, const RenderSettings& settings, std::function<void()> wake)
    : scene_(scene),
      first_settings_(without_crop(settings)),
      now_{first_settings_, {}},
      relighter_(std::move(wake)) {}

void SceneEdits::reset() {
  set_all_but_size(first_settings_);
  sky_chosen_ = false;
  reset_lights();
  reset_dfrs();
}

std::vector<EditedLight>& SceneEdits::edit_lights() {
  ++now_.look.lights_revision;
  now_.lights_edited = true;
  return now_.look.lights;
}

void SceneEdits::reset_lights() {
  if (!scene_) return;
  first_lights_ = lights_to_edit(lights_under(*scene_, now_.settings.sky.get()));
  edit_lights() = first_lights_;
  now_.lights_edited = false;
}

void SceneEdits::set_sky(std::shared_ptr<const Sky> sky) {
  sky_chosen_ = true;
  put_sky(std::move(sky));
}

void SceneEdits::follow_background(const Sky* sky) {
  Background& background = now_.settings.background;
  if (!keeps_.background && background == default_background(now_.settings.sky.get()))
    background = default_background(sky);
}

void SceneEdits::put_sky(std::shared_ptr<const Sky> sky) {
  const auto brings_lights = [this](const std::shared_ptr<const Sky>& s) {
    return scene_ && changes_lights(*scene_, s.get());
  };
  const bool relit = brings_lights(sky) || brings_lights(now_.settings.sky);
  follow_background(sky.get());
  now_.settings.sky = std::move(sky);
  if (relit) reset_lights();
}

bool SceneEdits::environment_lights_scene() const {
  const Sky* sky = now_.settings.sky.get();
  return scene_ && scene_->geometry->stage.has_default_lighting && sky && sky->choice().environment;
}

void SceneEdits::turn_sky(double turn_deg) {
  if (!now_.settings.sky) return;
  if (environment_lights_scene())
    return turn_surroundings(glm::radians(turn_deg - now_.settings.sky->choice().turn_deg));
  now_.settings.sky = std::make_shared<const Sky>(now_.settings.sky->turned(turn_deg));
}

void SceneEdits::brighten_sky(double times) {
  if (!now_.settings.sky) return;
  const double before = now_.settings.sky->choice().brightness;
  auto brightened = std::make_shared<const Sky>(now_.settings.sky->brightened(times));
  const bool lights = environment_lights_scene();
  follow_background(brightened.get());
  now_.settings.sky = std::move(brightened);
  if (!lights || before == times) return;
  if (!(before > 0.0)) return reset_lights();  // they were black
  for (EditedLight& edited : edit_lights())
    edited.light.intensity *= static_cast<float>(times / before);
}

void SceneEdits::turn_surroundings(double by_rad) {
  if (const Sky* sky = now_.settings.sky.get();
      sky && (sky->is_picture() || sky->choice().environment)) {
    const double turn = sky->choice().turn_deg + glm::degrees(by_rad);
    now_.settings.sky = std::make_shared<const Sky>(sky->turned(std::remainder(turn, 360.0)));
  }
  if (!scene_ || !scene_->geometry->stage.has_default_lighting || now_.look.lights.empty()) return;
  const Box bounds = bounds_without_ground(scene_->world());
  for (EditedLight& edited : edit_lights())
    carry_around(edited.light, SceneSize::of(bounds).middle, by_rad);
}

MaterialDfrs& SceneEdits::edit_dfrs() {
  ++now_.look.dfrs_revision;
  now_.dfrs_edited = true;
  return now_.look.dfrs;
}

void SceneEdits::reset_dfrs() {
  if (!scene_) return;
  edit_dfrs() = dfrs_without_ground(scene_->world());
  now_.dfrs_edited = false;
}

void SceneEdits::adopt_scene(const std::optional<PictureDescription>& picture) {
  first_lights_ = lights_to_edit(scene_->own_lighting->lights);
  edit_lights() = first_lights_;
  now_.lights_edited = false;
  reset_dfrs();
  relighter_.start_from(now_.look);
  if (!picture) {
    take_default_look();
    if (changes_lights(*scene_, now_.settings.sky.get())) reset_lights();
    opened_ = revisions();
    return;
  }
  opened_ = revisions();
  // The scene already has the picture's lights and ratios, so they do not count as edits.
  now_.look.lights = lights_of_picture(scene_->lights(), first_lights_);
  now_.look.dfrs = scene_->dfrs();
  now_.look.dfrs.resize(materials_without_ground(scene_->world()));
  RenderSettings settings = without_crop(picture->settings);
  settings.threads = now_.settings.threads;
  set_all_but_size(std::move(settings));
}

CarriedEdits SceneEdits::adopt_again(const RenderScene& before, glm::dvec3 moved) {
  const State was = now_;
  const std::vector<EditedLight> first = first_lights_;
  adopt_scene(std::nullopt);
  CarriedEdits carried;
  std::vector<EditedLight> lights =
      carried_lights(was.look.lights, first, first_lights_, moved, carried);
  if (carried.lights > 0) {
    edit_lights() = std::move(lights);
    now_.lights_edited = was.lights_edited;
  }
  MaterialDfrs dfrs = carried_dfrs({material_names(before.world()), was.look.dfrs},
                                   dfrs_without_ground(before.world()),
                                   {material_names(scene_->world()), now_.look.dfrs}, carried);
  if (carried.dfrs > 0) {
    edit_dfrs() = std::move(dfrs);
    now_.dfrs_edited = was.dfrs_edited;
  }
  return carried;
}

std::optional<Ground> SceneEdits::own_ground() const {
  const Ground now = now_.settings.ground;
  const bool own = keeps_.sky || keeps_.ground || now != first_settings_.ground;
  return own ? std::optional(now) : std::nullopt;
}

void SceneEdits::take_default_look() {
  RenderSettings& now = now_.settings;
  const bool own_background =
      keeps_.background || now.background != default_background(now.sky.get());
  const DefaultLook look = default_look(*scene_);
  if (!keeps_.sky && !sky_chosen_) now.sky = first_settings_.sky = look.sky;
  if (!own_ground()) now.ground = first_settings_.ground = look.ground;
  if (own_background) return;
  now.background = default_background(now.sky.get());
  first_settings_.background = default_background(first_settings_.sky.get());
}

bool SceneEdits::same_as(const State& state) const {
  RenderSettings sized = state.settings;
  sized.width = now_.settings.width;
  sized.height = now_.settings.height;
  return now_.settings == sized && now_.look.lights_revision == state.look.lights_revision &&
         now_.look.dfrs_revision == state.look.dfrs_revision;
}

void SceneEdits::restore(const State& state) {
  set_all_but_size(state.settings);
  sky_chosen_ = now_.settings.sky != first_settings_.sky;
  if (now_.look.lights_revision != state.look.lights_revision) edit_lights() = state.look.lights;
  if (now_.look.dfrs_revision != state.look.dfrs_revision) edit_dfrs() = state.look.dfrs;
  now_.lights_edited = state.lights_edited;
  now_.dfrs_edited = state.dfrs_edited;
}

void SceneEdits::set_all_but_size(RenderSettings settings) {
  settings.width = now_.settings.width;
  settings.height = now_.settings.height;
  now_.settings = std::move(settings);
}

}  // namespace asos::ui
