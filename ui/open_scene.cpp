#include "ui/open_scene.h"

#include "renderer/scene/load.h"

namespace asos {

namespace {

LoadFunction load_or_default(LoadFunction load) {
  if (load) return load;
  return [](const std::string& source) { return load_scene(source, {.keep_rig = true}); };
}

}  // namespace

OpenScene::OpenScene(LoadFunction load, std::function<void()> wake, const SceneNeeds& forced)
    : loader_(load_or_default(std::move(load)), std::move(wake), forced) {}

void OpenScene::open(const std::string& source) {
  error_.reset();
  reload_failed_ = false;
  asked_for_ = source;
  reloading_ = false;
  loader_.open(source);
}

void OpenScene::reload() {
  if (!scene_) return;
  open(scene_->geometry->source);
  reloading_ = true;
}

bool OpenScene::is(const RenderScene& scene) const {
  return scene_ && scene_->geometry == scene.geometry;
}

std::optional<OpenScene::Opened> OpenScene::take_opened() {
  std::optional<LoadOutcome> outcome = loader_.take_outcome();
  if (!outcome) return std::nullopt;
  const bool reloaded = std::exchange(reloading_, false);
  if (!outcome->scene) {
    error_ = outcome->scene.error();
    reload_failed_ = reloaded;
    if (reload_failed_) files_ = std::move(outcome->files);
    return std::nullopt;
  }
  files_ = std::move(outcome->files);
  scene_ = std::move(*outcome->scene);
  load_seconds_ = outcome->load_seconds;
  ++times_opened_;
  if (outcome->picture) opened_display_ = outcome->picture->display;
  return Opened{reloaded, std::move(outcome->picture)};
}

}  // namespace asos
