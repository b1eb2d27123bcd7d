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

/// The open scene, and the loading of another one in the background. Acts like a pointer to the
/// scene; null before the first one. All members must be called from one thread.
class OpenScene {
 public:
  /// Results of opening a scene.
  struct Opened {
    bool reloaded = false;   ///< the same scene was loaded again
    bool same_file = false;  ///< or another scene of the same file: edits stay
    glm::dvec3 moved{0.0};   ///< change of coordinates in the same file, by that of World::origin
    std::optional<PictureDescription> picture;  ///< if the source was a saved picture
  };
  /// An empty `load` means load_scene. `wake` is called from the loader's thread when `take_opened`
  /// has a result. `forced`: see prepare.
  OpenScene(LoadFunction load, std::function<void()> wake, const RenderFeatures& forced);

  /// Starts loading in the background. The open scene stays until the new one is ready, or if
  /// loading fails. A saved picture (.png, .exr) brings its scene, camera, lights and settings.
  void open(const std::string& source);
  void open(SceneSource source);
  /// Sets the function that returns the ground of scenes to open: see SceneSource::ground. It is
  /// called by the functions that start loading.
  void expect_ground(std::function<std::optional<Ground>()> expected) {
    expected_ground_ = std::move(expected);
  }
  /// Reloads the open scene's file and keeps the view.
  void reload();
  /// Reloads with this material variant; empty: none.
  void show_variant(const std::string& variant);
  /// Loads another scene of the file with its own camera; `index` is into SceneContents::scenes.
  void show_scene(int index);

  /// Shows the scene without one object, with only that object, or with all; the view stays. `part`
  /// is an index into World::parts. The last visible part cannot be hidden.
  void hide(int part);
  /// Shows the scene without these objects only: ascending indices among all objects.
  void show_without(std::vector<int> places);
  /// The same for objects by their ids, in any pose.
  void show_all_but(std::vector<ObjectId> hidden);
  void show_only(int part);
  void show_all();
  /// Ascending indices of the hidden objects among all objects of the present pose.
  [[nodiscard]] const std::vector<int>& hidden() const { return hidden_places_; }
  /// The hidden objects, ascending, in any pose.
  [[nodiscard]] const std::vector<ObjectId>& hidden_objects() const { return hidden_; }
  /// Whether objects are hidden, in this pose or in others.
  [[nodiscard]] bool hides() const { return !hidden_.empty(); }
  /// The objects of the present pose, hidden ones included.
  [[nodiscard]] std::vector<ObjectId> objects() const;

  explicit operator bool() const { return scene_ != nullptr; }
  const RenderScene* operator->() const { return scene_.get(); }
  const RenderScene& operator*() const { return *scene_; }
  [[nodiscard]] const RenderScene* get() const { return scene_.get(); }
  [[nodiscard]] const std::shared_ptr<const RenderScene>& shared() const { return scene_; }
  /// Whether `scene` is the open one, possibly with other lights and materials.
  [[nodiscard]] bool is(const RenderScene& scene) const;
  /// Counts opened scenes. Steps from before the last one cannot be undone.
  [[nodiscard]] std::uint64_t times_opened() const { return times_opened_; }

  /// The source of the open scene as shown: with variant, scene of the file and hidden objects.
  /// Requires a scene.
  [[nodiscard]] SceneSource shown_source() const;
  /// The source of the last request, whether it could be opened or not.
  [[nodiscard]] const std::string& asked_for() const { return asked_for_; }
  [[nodiscard]] std::optional<SceneLoader::Loading> loading() const { return loader_.loading(); }
  /// Whether the scene being loaded is the open one, or another one of its file.
  [[nodiscard]] bool loads_again() const { return same_file_; }
  /// The number of textures that the open scene lacks; 0: none. The factors of their materials
  /// show until it is loaded again.
  [[nodiscard]] std::size_t textures_missing() const { return textures_missing_; }
  /// Starts loading the textures that the open scene lacks.
  void load_textures();
  /// Puts loaded textures into the open scene, whose lights and materials must not be replaced at
  /// the time. Its surfaces, hierarchies and edits stay. Returns the facts of a scene that has
  /// other lights now.
  [[nodiscard]] std::optional<Opened> put_images();
  /// The declared size of the open scene; null: unknown.
  [[nodiscard]] const std::shared_ptr<const ScenePreview>& preview() const { return preview_; }
  /// The files that the open scene was read from, as they were at the last attempt.
  [[nodiscard]] const std::vector<FileStamp>& files() const { return files_; }
  [[nodiscard]] double load_seconds() const { return load_seconds_; }
  /// Returns the display settings of the saved picture that was opened last, once.
  [[nodiscard]] std::optional<PictureDisplay> take_opened_display() {
    return std::exchange(opened_display_, std::nullopt);
  }

  /// A folder with files that the source refers to but that were refused, if `widen_asset_root` can
  /// allow them; empty: none.
  [[nodiscard]] const std::string& outer_root() const { return outer_root_; }
  /// Loads the last source again with `outer_root` as its asset root.
  void widen_asset_root();

  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  void report(Error error) { error_ = std::move(error); }
  void dismiss_error() { error_.reset(); }
  /// Whether the error is that the open scene's file could not be reloaded; the scene stays.
  [[nodiscard]] bool reload_failed() const { return reload_failed_; }

  /// Makes a loaded scene the open one and returns its facts, once. Returns none if no load has
  /// finished, or if loading failed: then `error` has the reason.
  [[nodiscard]] std::optional<Opened> take_opened();
  /// Replaces the open scene by the same with other lights or materials, or in another pose.
  void relight(std::shared_ptr<const RenderScene> scene);

 private:
  void ask_for(SceneSource source);
  void load_again(const std::string& variant);
  void find_hidden_places();

  std::shared_ptr<const RenderScene> scene_;
  std::shared_ptr<const RenderScene> whole_;  // with the hidden objects; null: none is hidden
  std::function<std::optional<Ground>()> expected_ground_;
  std::uint64_t times_opened_ = 0;
  std::string asked_for_;
  SceneSource asked_;
  std::string asset_root_;
  std::string outer_root_;
  bool reloading_ = false;  // the scene being loaded is a reload of the open one
  bool same_file_ = false;  // or another scene of its file
  bool reload_failed_ = false;
  std::size_t textures_missing_ = 0;
  std::shared_ptr<const Scene> images_;  // loaded, to be put into the scene; null: none
  std::shared_ptr<const ScenePreview> preview_;
  std::vector<ObjectId> hidden_;    // ascending; in any pose
  std::vector<int> hidden_places_;  // of those in the present pose
  double load_seconds_ = 0.0;
  std::vector<FileStamp> files_;
  std::optional<Error> error_;
  std::optional<PictureDisplay> opened_display_;
  SceneLoader loader_;
};

}  // namespace asos::ui
