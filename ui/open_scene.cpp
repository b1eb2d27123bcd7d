#include "ui/open_scene.h"

#include "renderer/scene/load.h"

namespace asos {

namespace {

LoadFunction load_or_default(LoadFunction load) {
  if (load) return load;
  return [](const SceneSource& source) {
    return load_scene(source.path,
                      {.keep_rig = true, .variant = source.variant, .scene = source.scene});
  };
}

/// Where the file's default is meant, that is what is asked for, whichever it becomes.
std::string name_of(const SceneContents& contents, int scene) {
  return scene == contents.default_scene ? std::string() : std::to_string(scene);
}

}  // namespace

OpenScene::OpenScene(LoadFunction load, std::function<void()> wake, const SceneNeeds& forced)
    : loader_(load_or_default(std::move(load)), std::move(wake), forced) {}

void OpenScene::ask_for(SceneSource source) {
  error_.reset();
  reload_failed_ = false;
  asked_for_ = source.path;
  reloading_ = false;
  loader_.open(std::move(source));
}

void OpenScene::open(const std::string& source) {
  ask_for({source});
}

void OpenScene::open(SceneSource source) {
  ask_for(std::move(source));
}

void OpenScene::reload() {
  if (scene_) show_variant(scene_->geometry->contents.variant);
}

void OpenScene::show_variant(const std::string& variant) {
  if (!scene_) return;
  const SceneContents& contents = scene_->geometry->contents;
  ask_for({scene_->geometry->source, variant, name_of(contents, contents.shown_scene)});
  reloading_ = true;
}

void OpenScene::show_scene(int index) {
  if (!scene_) return;
  const SceneContents& contents = scene_->geometry->contents;
  ask_for({scene_->geometry->source, contents.variant, name_of(contents, index)});
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
