#include "ui/open_scene.h"

#include "renderer/gltf/load.h"
#include "renderer/prepared/with_images.h"
#include "renderer/prepared/without_objects.h"
#include "renderer/world/ground.h"
#include "ui/hidden_objects.h"

#include <algorithm>
#include <iterator>

namespace asos::ui {

namespace {

LoadFunction load_or_default(LoadFunction load) {
  if (load) return load;
  return [](const SceneSource& source) {
    return load_scene(source.path, {.keep_posable = true,
                                    .variant = source.variant,
                                    .scene = source.scene,
                                    .asset_root = source.asset_root,
                                    .images_only = source.images_only});
  };
}

/// The default scene is requested by the empty name, so a file whose default changes shows the new
/// one.
std::string name_of(const SceneContents& contents, int scene) {
  return scene == contents.default_scene ? std::string() : std::to_string(scene);
}

}  // namespace

OpenScene::OpenScene(LoadFunction load, std::function<void()> wake, const RenderFeatures& forced)
    : loader_(load_or_default(std::move(load)), std::move(wake), forced) {}

void OpenScene::ask_for(SceneSource source) {
  error_.reset();
  reload_failed_ = false;
  asked_for_ = source.path;
  asked_ = source;
  asked_.known.reset();
  outer_root_.clear();
  reloading_ = same_file_ = false;
  textures_missing_ = 0;
  if (expected_ground_) source.ground = expected_ground_();
  images_.reset();
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

void OpenScene::load_textures() {
  if (textures_missing_ == 0 || images_ || loading()) return;
  const std::size_t missing = textures_missing_;
  SceneSource source = shown_source();
  source.images_only = true;
  ask_for(std::move(source));
  reloading_ = same_file_ = true;
  textures_missing_ = missing;
}

std::optional<OpenScene::Opened> OpenScene::put_images() {
  const std::shared_ptr<const Scene> images = std::exchange(images_, nullptr);
  if (!images) return std::nullopt;
  textures_missing_ = 0;
  if (!scene_ || !has_images_for(*images, *scene_)) {
    reload();
    return std::nullopt;
  }
  const std::shared_ptr<const Lighting> lighting = scene_->own_lighting;
  for (std::shared_ptr<const RenderScene>* scene : {&whole_, &scene_}) {
    if (!*scene) continue;
    auto with = with_images(*scene, *images);
    if (!with) {
      error_ = with.error();
      return std::nullopt;
    }
    *scene = *std::move(with);
  }
  if (scene_->own_lighting == lighting) return std::nullopt;
  ++times_opened_;
  return Opened{true, true, glm::dvec3(0.0), std::nullopt};
}

void OpenScene::show_variant(const std::string& variant) {
  if (scene_) load_again(variant);
}

SceneSource OpenScene::shown_source() const {
  const SceneContents& contents = scene_->geometry->contents;
  return {scene_->geometry->source,
          contents.variant,
          name_of(contents, contents.shown_scene),
          {},
          hidden_,
          asset_root_,
          true};
}

void OpenScene::load_again(const std::string& variant) {
  SceneSource source = shown_source();
  source.variant = variant;
  ask_for(std::move(source));
  reloading_ = same_file_ = true;
}

void OpenScene::show_all_but(std::vector<ObjectId> hidden) {
  if (!scene_) return;
  const std::size_t missing = textures_missing_;
  std::string outer_root = outer_root_;
  SceneSource source = shown_source();
  source.hidden = std::move(hidden);
  source.known = whole_ ? whole_ : without_edits(scene_);
  ask_for(std::move(source));
  reloading_ = same_file_ = true;
  textures_missing_ = missing;
  outer_root_ = std::move(outer_root);
}

void OpenScene::widen_asset_root() {
  if (outer_root_.empty()) return;
  SceneSource again = asked_;
  again.asset_root = outer_root_;
  const bool same = scene_ && scene_->geometry->source == again.path;
  ask_for(std::move(again));
  reloading_ = same_file_ = same;
}

std::vector<ObjectId> OpenScene::objects() const {
  if (!scene_) return {};
  const SceneContents& contents = scene_->geometry->contents;
  const std::size_t listed = contents.object_nodes.size();
  return objects_of(contents,
                    listed > 0 ? listed : objects_without_ground(scene_->world()) + hidden_.size());
}

void OpenScene::find_hidden_places() {
  hidden_places_.clear();
  if (hidden_.empty()) return;
  const std::vector<ObjectId> all = objects();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (std::binary_search(hidden_.begin(), hidden_.end(), all[i]))
      hidden_places_.push_back(static_cast<int>(i));
}

void OpenScene::relight(std::shared_ptr<const RenderScene> scene) {
  const bool same = scene_ && scene && scene_->geometry == scene->geometry;
  scene_ = std::move(scene);
  if (!same) find_hidden_places();
}

void OpenScene::hide(int part) {
  // The ground is no object of the file.
  if (!scene_ || part >= static_cast<int>(objects_without_ground(scene_->world()))) return;
  std::vector<int> places = hidden_places_;
  places.push_back(place_among_all(part, hidden_places_));
  show_without(std::move(places));
}

// Hidden objects that the present pose does not have stay hidden.
void OpenScene::show_without(std::vector<int> places) {
  if (!scene_) return;
  std::vector<ObjectId> all = objects(), hidden;
  for (const int place : places)
    if (place >= 0 && place < static_cast<int>(all.size()))
      hidden.push_back(all[static_cast<std::size_t>(place)]);
  std::sort(all.begin(), all.end());
  std::set_difference(hidden_.begin(), hidden_.end(), all.begin(), all.end(),
                      std::back_inserter(hidden));
  std::sort(hidden.begin(), hidden.end());
  show_all_but(std::move(hidden));
}

void OpenScene::show_only(int part) {
  if (!scene_) return;
  std::vector<int> places = hidden_places_;
  for (int i = 0; i < static_cast<int>(objects_without_ground(scene_->world())); ++i)
    if (i != part) places.push_back(place_among_all(i, hidden_places_));
  show_without(std::move(places));
}

void OpenScene::show_all() {
  show_all_but({});
}

void OpenScene::show_scene(int index) {
  if (!scene_) return;
  const SceneContents& contents = scene_->geometry->contents;
  ask_for(
      {scene_->geometry->source, contents.variant, name_of(contents, index), {}, {}, asset_root_});
  same_file_ = true;
}

bool OpenScene::is(const RenderScene& scene) const {
  return scene_ && scene_->geometry == scene.geometry;
}

std::optional<OpenScene::Opened> OpenScene::take_opened() {
  std::optional<LoadOutcome> outcome = loader_.take_outcome();
  if (!outcome) return std::nullopt;
  const bool reloaded = std::exchange(reloading_, false);
  const bool same_file = std::exchange(same_file_, false);
  if (outcome->images) {
    // The file may have changed since its surfaces were read.
    if (outcome->files == files_)
      images_ = std::move(outcome->images);
    else
      reload();
    return std::nullopt;
  }
  if (outcome->read) {
    outer_root_ = outcome->outer_root;
    textures_missing_ = 0;
  }
  if (!outcome->scene) {
    error_ = outcome->scene.error();
    reload_failed_ = reloaded;
    if (reload_failed_ && outcome->read) files_ = std::move(outcome->files);
    return std::nullopt;
  }
  hidden_ = asked_.hidden;
  asset_root_ = asked_.asset_root;
  const glm::dvec3 before = scene_ ? scene_->world().origin : glm::dvec3(0.0);
  scene_ = std::move(*outcome->scene);
  whole_ = std::move(outcome->whole);
  find_hidden_places();
  ++times_opened_;
  if (outcome->picture) opened_display_ = outcome->picture->display;
  const glm::dvec3 moved = same_file ? before - scene_->world().origin : glm::dvec3(0.0);
  if (outcome->read) {
    files_ = std::move(outcome->files);
    load_seconds_ = outcome->load_seconds;
    textures_missing_ = outcome->textures_missing;
    preview_ = std::move(outcome->preview);
  }
  return Opened{reloaded, same_file, moved, std::move(outcome->picture)};
}

}  // namespace asos::ui
