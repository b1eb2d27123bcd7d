#pragma once

#include "renderer/load_progress.h"
#include "renderer/picture/picture_description.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"
#include "renderer/scene/clip_choice.h"
#include "renderer/scene/scene_preview.h"
#include "ui/file_watch.h"
#include "ui/hidden_objects.h"
#include "ui/latest_job.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asos::ui {

/// The scene to open, "builtin:NAME" or a path, and which part of it. Converts to its path.
struct SceneSource {
  std::string path;
  std::string variant{};           ///< material variant; empty: none
  std::string scene{};             ///< scene of the file: see LoadOptions
  ClipChoice clip{};               ///< the animation and time to show first
  std::vector<ObjectId> hidden{};  ///< objects to remove: see scene_without
  std::string asset_root{};        ///< see LoadOptions
  bool whole = false;              ///< with all textures, even if they delay the first picture
  std::optional<Ground> ground{};  ///< to build the scene with; none: that of its default look
  bool images_only = false;        ///< only the images are needed, for with_images
  /// The same scene, prepared without hiding anything. Null: the file is read.
  std::shared_ptr<const RenderScene> known{};

  operator const std::string&() const { return path; }
};

/// Opens a source. Called on the loader's thread, which works for a LoadProgress.
using LoadFunction = std::function<Result<Scene>(const SceneSource& source)>;

/// A prepared scene, or an error instead.
struct LoadOutcome {
  std::string source;  ///< as asked for
  Result<std::shared_ptr<const RenderScene>> scene;
  /// The scene with its hidden objects; null: none is hidden.
  std::shared_ptr<const RenderScene> whole{};
  std::shared_ptr<const Scene> images{};  ///< SceneSource::images_only: in place of `scene`
  bool read = true;  ///< false: SceneSource::known was used, and the next members are unset
  double load_seconds = 0.0;  ///< time to read the file, without building the hierarchies
  /// For a saved picture: its description, with the sky loaded. `scene` is its scene with its
  /// lights.
  std::optional<PictureDescription> picture{};
  std::vector<FileStamp> files{};    ///< the files of the scene, as they were before it was read
  std::string outer_root{};          ///< see outer_asset_root
  std::size_t textures_missing = 0;  ///< number of textures that plain texels stand for
  std::shared_ptr<const ScenePreview> preview{};  ///< null: unknown
};

/// Loads and prepares scenes, and those of saved pictures (.png, .exr), on its own thread. A newer
/// request replaces an older one: it stops its loading at the next stop point, and drops its
/// outcome. So does the destructor.
class SceneLoader {
 public:
  /// `wake` is called from the loader's thread when an outcome is ready or the progress changed.
  /// `forced`: see prepare.
  SceneLoader(LoadFunction load, std::function<void()> wake, const RenderFeatures& forced = {});
  ~SceneLoader() { stop(); }
  SceneLoader(const SceneLoader&) = delete;
  SceneLoader& operator=(const SceneLoader&) = delete;

  void open(SceneSource source);
  /// Returns the outcome of the newest request, once.
  [[nodiscard]] std::optional<LoadOutcome> take_outcome();

  struct Loading {
    std::string source;
    double seconds = 0.0;
    LoadStage stage = LoadStage::reading;
    std::shared_ptr<const ScenePreview> preview{};  ///< null: not known yet, or never
    std::size_t textures = 0;                       ///< decoded so far
  };
  /// The running load of the newest request.
  [[nodiscard]] std::optional<Loading> loading() const;

 private:
  struct Request {
    SceneSource source;
    std::shared_ptr<LoadProgress> progress;
  };
  void stop();

  std::function<void()> wake_;
  LatestJob<Request, LoadOutcome> job_;
  std::string source_;                      // of the newest request
  std::shared_ptr<LoadProgress> progress_;  // of the newest request; null before it
  std::chrono::steady_clock::time_point since_;
};

}  // namespace asos::ui
