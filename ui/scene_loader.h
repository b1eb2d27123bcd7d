#pragma once

#include "renderer/picture/picture_description.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"
#include "renderer/scene/clip_choice.h"
#include "ui/file_watch.h"
#include "ui/latest_job.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asos::ui {

/// What to open: "builtin:NAME" or a path, which it stands for, and what of it is shown.
struct SceneSource {
  std::string path;
  std::string variant{};      ///< of its materials; empty: none
  std::string scene{};        ///< of the file's; see LoadOptions
  ClipChoice clip{};          ///< the moment that it is shown at first
  std::vector<int> hidden{};  ///< objects that are left out; see leave_out
  std::string asset_root{};   ///< see LoadOptions

  operator const std::string&() const { return path; }
};

/// Opens a source; called on the loader's thread.
using LoadFunction = std::function<Result<Scene>(const SceneSource& source)>;

/// A scene made ready to render, or the error in its place.
struct LoadOutcome {
  std::string source;  ///< as asked for
  Result<std::shared_ptr<const RenderScene>> scene;
  double load_seconds = 0.0;  ///< reading the file, without building the hierarchies
  /// Where the source was a saved picture: what it says, with the sky made. `scene` is its scene in
  /// its lights.
  std::optional<PictureDescription> picture;
  std::vector<FileStamp> files;  ///< that the scene is read from, as they were before
  std::string outer_root{};      ///< see outer_asset_root
};

/// Loads and prepares scenes, and those of saved pictures (.png, .exr), on a thread of its own. A
/// newer request replaces an older one: the older outcome is dropped, even where its loading has
/// begun. The destructor waits for a load that runs.
class SceneLoader {
 public:
  /// `wake` is called from the loader's thread when an outcome waits. `forced`: see prepare.
  SceneLoader(LoadFunction load, std::function<void()> wake, const SceneNeeds& forced = {});

  void open(SceneSource source);
  /// The outcome of the newest request, once.
  [[nodiscard]] std::optional<LoadOutcome> take_outcome();

  struct Loading {
    std::string source;
    double seconds = 0.0;
  };
  /// The load under way for the newest request.
  [[nodiscard]] std::optional<Loading> loading() const;

 private:
  LatestJob<SceneSource, LoadOutcome> job_;
  std::string source_;  // of the newest request
  std::chrono::steady_clock::time_point since_;
};

}  // namespace asos::ui
