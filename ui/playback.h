#pragma once

#include "renderer/prepared/exposure.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/prepared/with_lines.h"
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

namespace asos::ui {

/// Plays the animations of the open scene: a clock, and poses of the scene computed in the
/// background with the default lighting of the scene at rest. The next pose is requested once the
/// last one has been displayed for a moment; time that passes meanwhile is skipped. All members
/// must be called from one thread.
class Playback {
 public:
  /// The picture that lines and points are drawn for.
  struct LineRequest {
    LinePicture picture;
    std::uint64_t camera_revision = 0;
    int follows = -1;  ///< index of the scene's camera that the view follows; -1: the view stays
  };

  /// The picture that motion is blurred for.
  struct WantedExposure {
    Camera camera;
    RenderSettings settings;
  };

  /// `scene` and `edits` must outlive the object. `wake` is called from another thread when
  /// `update` has something to do.
  Playback(OpenScene& scene, SceneEdits& edits, std::function<void()> wake);

  /// Whether the open scene has animations; without any, all other members do nothing.
  [[nodiscard]] bool available() const { return scene_ && scene_->geometry->rig != nullptr; }
  [[nodiscard]] const std::vector<SceneContents::Animation>& animations() const;

  /// The requested time; none: the scene at rest.
  [[nodiscard]] const std::optional<ClipTime>& time() const { return time_; }
  /// Duration of the chosen animation in seconds; 0: none is chosen.
  [[nodiscard]] double duration_seconds() const;
  /// Starts at the beginning of this animation; -1: none, at rest.
  void choose(int animation);
  /// Moves to this time of the chosen animation; chooses the first one if there is none.
  void seek(double seconds);
  /// Pauses and moves by whole frames at `fps`.
  void step(int frames);
  void set_playing(bool playing);
  [[nodiscard]] bool playing() const { return playing_; }

  /// Interval in seconds at which a playing clock is updated.
  static constexpr double frame_seconds = 1.0 / 60.0;
  static constexpr double least_poses = 12.0;
  static constexpr double slowest = 0.05, fastest = 20.0;
  struct Options {
    bool loop = true;
    double speed = 1.0;  ///< from slowest to fastest
    double fps = 24.0;   ///< of `step`
    /// A file that is opened plays if it has one animation and can be posed at least
    /// `least_poses` times a second.
    bool plays_at_first = false;
  };
  [[nodiscard]] Options& options() { return options_; }

  /// Call when a scene was opened. `again`: it is the same file, so the time is kept.
  void adopt_scene(bool again);
  /// Lets time pass, takes the finished pose and requests the next one. `seen`: the picture of the
  /// last pose has been displayed. Call at least once a frame. Poses come with their lines and
  /// points drawn for `lines_and_points`; none: as they are at rest. A pose that does not play is
  /// exposed for `exposure` next; none: it shows one moment.
  void update(bool seen, double now_seconds, const std::optional<LineRequest>& lines_and_points,
              const std::optional<WantedExposure>& exposure = std::nullopt);
  /// Returns the picture and camera that the last pose's lines and points were drawn for, once.
  [[nodiscard]] std::optional<LineRequest> take_drawn_lines() {
    return std::exchange(drawn_lines_, std::nullopt);
  }
  /// Returns the scene of `from`'s file at another time, with edits; without them, as in the file.
  /// `as`: see with_ground. `meshes`: AnimationInvariants::meshes. Only if `available`.
  /// Thread-safe.
  [[nodiscard]] static Result<std::shared_ptr<const RenderScene>> scene_at(
      const RenderScene& from, const std::optional<ClipTime>& time,
      const std::optional<std::vector<Light>>& lights, const std::optional<MaterialDfrs>& dfrs,
      Ground ground, const World* as = nullptr, const std::shared_ptr<MeshStore>& meshes = nullptr);
  /// Returns `scene`, made by `scene_at`, with the exposure that the settings' shutter asks for.
  /// Any thread.
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
  /// Time in seconds that the last pose took: posing, and preparing for rendering.
  [[nodiscard]] double pose_seconds() const { return pose_seconds_; }
  [[nodiscard]] double prepare_seconds() const { return prepare_seconds_; }

 private:
  struct Request {
    std::shared_ptr<const RenderScene> from;
    std::optional<ClipTime> time;
    std::optional<std::vector<Light>> lights;  // edited lights; none: the pose's own
    std::optional<MaterialDfrs> dfrs;          // edited
    SceneEdits::Revisions look;
    std::uint64_t opened = 0;  // OpenScene::times_opened
    Ground ground = Ground::off;
    std::optional<LineRequest> lines_and_points;
    std::optional<WantedExposure> exposure;  // of `from`, which is at this time
  };
  struct Pose {
    Result<std::shared_ptr<const RenderScene>> scene;
    std::optional<ClipTime> time;
    SceneEdits::Revisions look;
    std::uint64_t opened = 0;
    double pose_seconds = 0.0, prepare_seconds = 0.0;
    std::optional<LineRequest> lines_and_points;
    bool exposed = false;
  };
  [[nodiscard]] static Pose posed(const Request& request);
  void let_time_pass(double seconds);
  void take_pose();
  void ask(const std::optional<LineRequest>& lines_and_points);
  [[nodiscard]] bool at_wanted_time() const { return scene_->geometry->time == time_; }
  [[nodiscard]] bool exposes() const;

  OpenScene& scene_;
  SceneEdits& edits_;
  Options options_;
  std::optional<ClipTime> time_;
  std::optional<ClipTime> failed_;  // time at which posing failed; not tried again
  bool has_failed_ = false;
  bool playing_ = false;
  std::optional<WantedExposure> exposure_;
  std::optional<double> updated_seconds_;
  double pose_seconds_ = 0.0, prepare_seconds_ = 0.0;
  std::optional<LineRequest> drawn_lines_;
  LatestJob<Request, Pose> job_;
};

}  // namespace asos::ui
