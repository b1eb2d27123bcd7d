#pragma once

#include "renderer/picture/picture_description.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"
#include "ui/scene_loader.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asos::ui {

/// The scene that is open, and how another one is opened in the background. Like a pointer to the
/// scene it is null before there is one. One thread; loading happens on another.
class OpenScene {
 public:
  /// An empty `load` is load_scene. `wake` is called from the loader's thread when `take_opened`
  /// has something to do. `forced`: see prepare.
  OpenScene(LoadFunction load, std::function<void()> wake, const SceneNeeds& forced);

  /// Loads in the background. The open scene stays until the new one is there, and where that
  /// fails. A saved picture (.png, .exr) brings its scene, camera, lights and settings.
  void open(const std::string& source);
  void open(SceneSource source);
  /// Loads the open scene's file again; the view stays.
  void reload();
  /// The same with this variant of its materials, or empty: none.
  void show_variant(const std::string& variant);
  /// Another of the file's scenes, seen as it asks for; an index into SceneContents::scenes.
  void show_scene(int index);

  /// Loads it again without an object, or with this one alone, or with all; the view stays. `part`
  /// is one of World::parts. No part may be hidden that is the only one.
  void hide(int part);
  /// Loads it again without these objects alone: places among all, ascending.
  void show_without(std::vector<int> places);
  void show_only(int part);
  void show_all();
  /// The places of the hidden objects among all; see leave_out.
  [[nodiscard]] const std::vector<int>& hidden() const { return hidden_; }

  explicit operator bool() const { return scene_ != nullptr; }
  const RenderScene* operator->() const { return scene_.get(); }
  const RenderScene& operator*() const { return *scene_; }
  [[nodiscard]] const RenderScene* get() const { return scene_.get(); }
  [[nodiscard]] const std::shared_ptr<const RenderScene>& shared() const { return scene_; }
  /// Whether `scene` is the open one, in whatever lights and materials.
  [[nodiscard]] bool is(const RenderScene& scene) const;
  /// Grows whenever another scene is opened: what was done before cannot be taken back then.
  [[nodiscard]] std::uint64_t times_opened() const { return times_opened_; }

  /// The source of the open scene as it is shown: variant, scene of the file and hidden objects.
  /// Only with a scene.
  [[nodiscard]] SceneSource shown_source() const;
  /// The source that was opened last, whether it could be or not.
  [[nodiscard]] const std::string& asked_for() const { return asked_for_; }
  [[nodiscard]] std::optional<SceneLoader::Loading> loading() const { return loader_.loading(); }
  /// The files that the open scene was read from, as they were when that was tried last.
  [[nodiscard]] const std::vector<FileStamp>& files() const { return files_; }
  [[nodiscard]] double load_seconds() const { return load_seconds_; }
  /// How the saved picture that was opened last was shown, once.
  [[nodiscard]] std::optional<PictureDisplay> take_opened_display() {
    return std::exchange(opened_display_, std::nullopt);
  }

  /// A folder from which files are read that the source names and that were refused, once
  /// `widen_asset_root` allows that; empty: none was.
  [[nodiscard]] const std::string& outer_root() const { return outer_root_; }
  /// Loads the source that was opened last again, with `outer_root` as its asset root.
  void widen_asset_root();

  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  void report(Error error) { error_ = std::move(error); }
  void dismiss_error() { error_.reset(); }
  /// Whether the error is that the open scene's file could not be read again: the scene stays.
  [[nodiscard]] bool reload_failed() const { return reload_failed_; }

  /// Facts about a scene that has just been opened.
  struct Opened {
    bool reloaded = false;  ///< it is the same scene again
    glm::dvec3 moved{0.0};  ///< then: by what all has moved relative to World::origin
    std::optional<PictureDescription> picture;  ///< where the source was a saved picture
  };
  /// Lets a scene that has been loaded take the open one's place, once; none: there was none, or
  /// an error in its place, which `error` tells then.
  [[nodiscard]] std::optional<Opened> take_opened();
  /// Lets the open scene in other lights or materials take its place.
  void relight(std::shared_ptr<const RenderScene> scene) { scene_ = std::move(scene); }

 private:
  void ask_for(SceneSource source);
  void load_again(const std::string& variant, std::vector<int> hidden);

  std::shared_ptr<const RenderScene> scene_;
  std::uint64_t times_opened_ = 0;
  std::string asked_for_;
  SceneSource asked_;
  std::string asset_root_;
  std::string outer_root_;
  bool reloading_ = false;  // the scene being loaded is the open one again
  bool reload_failed_ = false;
  std::vector<int> hidden_;  // ascending
  double load_seconds_ = 0.0;
  std::vector<FileStamp> files_;
  std::optional<Error> error_;
  std::optional<PictureDisplay> opened_display_;
  SceneLoader loader_;
};

}  // namespace asos::ui
