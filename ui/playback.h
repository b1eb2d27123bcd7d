#pragma once

#include "renderer/prepared/exposure.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/prepared/with_strokes.h"
#include "renderer/result.h"
#include "renderer/scene/contents.h"
#include "ui/latest_job.h"
#include "ui/open_scene.h"
#include "ui/scene_edits.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace asos {

/// Plays the animations of the open scene: a clock, and the scene posed at its time in the
/// background, on the stage of the one at rest. The next pose is asked for when the last one has
/// come and its picture has been seen for a moment; what time passes meanwhile is left out. All
/// members are for one thread.
class Playback {
 public:
  /// What lines and points are drawn for.
  struct WantedStrokes {
    StrokePicture picture;
    std::uint64_t camera_revision = 0;
    int follows = -1;  ///< the scene's camera that the picture's goes with; -1: it stays
  };

  /// The picture that motion is blurred for.
  struct WantedExposure {
    Camera camera;
    RenderSettings settings;
  };

  /// Both must outlive it. `wake` is called from another thread when `update` has something to do.
  Playback(OpenScene& scene, SceneEdits& edits, std::function<void()> wake);

  /// Whether the open scene has animations; all that follows does nothing where it has none.
  [[nodiscard]] bool available() const { return scene_ && scene_->geometry->rig != nullptr; }
  [[nodiscard]] const std::vector<SceneContents::Animation>& animations() const;

  /// The moment that is wanted; none: as the file's nodes place things.
  [[nodiscard]] const std::optional<ClipTime>& time() const { return time_; }
  /// Of the chosen animation; 0 where none is.
  [[nodiscard]] double duration_seconds() const;
  /// The animation's beginning; -1: none, at rest.
  void choose(int animation);
  /// Within the animation; chooses the first one where none is.
  void seek(double seconds);
  /// By so many frames at `fps`, paused, to a whole frame.
  void step(int frames);
  void set_playing(bool playing);
  [[nodiscard]] bool playing() const { return playing_; }

  /// How often the clock of what plays is worth a look.
  static constexpr double frame_seconds = 1.0 / 60.0;
  static constexpr double slowest = 0.05, fastest = 20.0;
  struct Options {
    bool loop = true;
    double speed = 1.0;  ///< from slowest to fastest
    double fps = 24.0;   ///< of `step`
  };
  [[nodiscard]] Options& options() { return options_; }

  /// The scene that has just been opened. `again`: it is the same file, whose time is kept.
  void adopt_scene(bool again);
  /// Lets time pass, takes the pose that is finished and asks for the next one. `seen`: the
  /// picture of the last one has been seen. Call once or more a frame.
  /// Poses come with their lines and points drawn for `strokes`; none: as they are at rest. A pose
  /// that does not play is exposed for `exposure` next; none: it shows one moment.
  void update(bool seen, double now_seconds, const std::optional<WantedStrokes>& strokes,
              const std::optional<WantedExposure>& exposure = std::nullopt);
  /// For what the lines and points of the pose that has just been taken were drawn, once.
  [[nodiscard]] std::optional<WantedStrokes> take_drawn_strokes() {
    return std::exchange(drawn_strokes_, std::nullopt);
  }
  /// The scene of `from`'s file at another time, with edits; without: as the file has it. Only
  /// where `available`. Any thread.
  [[nodiscard]] static Result<std::shared_ptr<const RenderScene>> scene_at(
      const RenderScene& from, const std::optional<ClipTime>& time,
      const std::optional<std::vector<Light>>& lights, const std::optional<MaterialDfrs>& dfrs,
      Ground ground);
  /// The scene that `scene_at` made with its exposure, as the settings' shutter asks. Any thread.
  [[nodiscard]] static Result<std::shared_ptr<const RenderScene>> exposed_scene(
      const std::shared_ptr<const RenderScene>& scene, const WantedExposure& wanted,
      const std::optional<std::vector<Light>>& lights, const std::optional<MaterialDfrs>& dfrs);
  /// The edits of lights and materials that `scene_at` is to keep; none where there are none.
  [[nodiscard]] std::optional<std::vector<Light>> edited_lights() const;
  [[nodiscard]] std::optional<MaterialDfrs> edited_dfrs() const;
  /// Whether the scene is not at the wanted time yet, or not exposed as it is wanted.
  [[nodiscard]] bool posing() const;
  /// The exposure of the scene; null: it shows one moment.
  [[nodiscard]] const Exposure* exposure() const {
    return available() ? scene_->exposure.get() : nullptr;
  }
  /// What a pose took last, in seconds: posing, and making ready to render.
  [[nodiscard]] double pose_seconds() const { return pose_seconds_; }
  [[nodiscard]] double prepare_seconds() const { return prepare_seconds_; }

 private:
  struct Request {
    std::shared_ptr<const RenderScene> from;
    std::optional<ClipTime> time;
    std::optional<std::vector<Light>> lights;  // edited; none: the pose's own
    std::optional<MaterialDfrs> dfrs;          // edited
    SceneEdits::Revisions look;
    std::uint64_t opened = 0;  // OpenScene::times_opened
    Ground ground = Ground::off;
    std::optional<WantedStrokes> strokes;
    std::optional<WantedExposure> exposure;  // of `from`, which is at this time
  };
  struct Pose {
    Result<std::shared_ptr<const RenderScene>> scene;
    std::optional<ClipTime> time;
    SceneEdits::Revisions look;
    std::uint64_t opened = 0;
    double pose_seconds = 0.0, prepare_seconds = 0.0;
    std::optional<WantedStrokes> strokes;
    bool exposed = false;
  };
  [[nodiscard]] static Pose posed(const Request& request);
  void let_time_pass(double seconds);
  void take_pose();
  void ask(const std::optional<WantedStrokes>& strokes);
  [[nodiscard]] bool at_wanted_time() const { return scene_->geometry->time == time_; }
  [[nodiscard]] bool exposes() const;

  OpenScene& scene_;
  SceneEdits& edits_;
  Options options_;
  std::optional<ClipTime> time_;
  std::optional<ClipTime> failed_;  // could not be posed: is not asked for again
  bool has_failed_ = false;
  bool playing_ = false;
  std::optional<WantedExposure> exposure_;
  std::optional<double> updated_seconds_;
  double pose_seconds_ = 0.0, prepare_seconds_ = 0.0;
  std::optional<WantedStrokes> drawn_strokes_;
  LatestJob<Request, Pose> job_;
};

}  // namespace asos
