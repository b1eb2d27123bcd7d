#include "ui/previewer.h"

#include <utility>

// What a person edits of a scene, and how the scene gets it.

namespace asos {

namespace {

const RenderScene& built_scene(const RenderScene& scene) {
  return scene.built_from ? *scene.built_from : scene;
}

}  // namespace

std::vector<EditedLight>& Previewer::edit_lights() {
  ++lights_revision_;
  return lights_;
}

MaterialDfrs& Previewer::edit_dfrs() {
  ++dfrs_revision_;
  return dfrs_;
}

void Previewer::reset_settings() {
  const int width = settings_.width, height = settings_.height;
  settings_ = first_settings_;
  settings_.crop = {};
  settings_.width = width;
  settings_.height = height;
  reset_lights();
  reset_dfrs();
}

void Previewer::reset_dfrs() {
  if (!scene_) return;
  dfrs_ = dfrs_of(original_scene().world);
  ++dfrs_revision_;
}

const RenderScene& Previewer::original_scene() const {
  return built_scene(*scene_);
}

bool Previewer::relighting() const {
  return lights_asked_for_ != lights_revision_ || dfrs_asked_for_ != dfrs_revision_ ||
         relighter_.pending();
}

void Previewer::reset_lights() {
  if (!scene_) return;
  lights_.clear();
  for (const Light& light : built_scene(*scene_).world.lights)
    lights_.push_back(EditedLight::of(light));
  ++lights_revision_;
}

Previewer::Relit Previewer::relit(const Relight& asked) {
  Relit result{asked.scene, asked.scene, asked.lights_revision};
  if (asked.lights) result.scene = with_lights(asked.scene, *asked.lights);
  if (result.scene && dfrs_of((*result.scene)->world) != asked.dfrs)
    result.scene = with_dfrs(*result.scene, asked.dfrs);
  return result;
}

void Previewer::relight_if_edited() {
  if (std::optional<Relit> done = relighter_.take_outcome()) {
    // Another scene may have been opened meanwhile.
    const bool current = scene_ && &built_scene(*scene_) == &built_scene(*done->from);
    if (current && done->scene) {
      scene_ = std::move(*done->scene);
      lights_of_scene_ = done->lights_revision;
    }
    if (current && !done->scene) error_ = done->scene.error();
  }
  if (!scene_) return;
  if (lights_asked_for_ == lights_revision_ && dfrs_asked_for_ == dfrs_revision_) return;
  lights_asked_for_ = lights_revision_;
  dfrs_asked_for_ = dfrs_revision_;
  Relight asked{scene_, std::nullopt, lights_revision_, dfrs_};
  if (lights_of_scene_ != lights_revision_) asked.lights = lights_on(lights_);
  relighter_.ask(std::move(asked));
}

bool Previewer::same_as(const Edits& edits) const {
  RenderSettings sized = edits.settings;
  sized.width = settings_.width;
  sized.height = settings_.height;
  return settings_ == sized && camera_.revision() == edits.camera.revision() &&
         lights_revision_ == edits.lights_revision && dfrs_revision_ == edits.dfrs_revision;
}

Previewer::Edits Previewer::edits() const {
  return {settings_, camera_, chosen_camera_, lights_, lights_revision_, dfrs_, dfrs_revision_};
}

void Previewer::restore(const Edits& edits) {
  const int width = settings_.width, height = settings_.height;
  settings_ = edits.settings;
  settings_.width = width;
  settings_.height = height;
  if (camera_.revision() != edits.camera.revision()) {
    camera_.restore(edits.camera);
    chosen_camera_ = edits.chosen_camera;
  }
  if (lights_revision_ != edits.lights_revision) {
    lights_ = edits.lights;
    ++lights_revision_;
  }
  if (dfrs_revision_ != edits.dfrs_revision) {
    dfrs_ = edits.dfrs;
    ++dfrs_revision_;
  }
}

}  // namespace asos
