#pragma once

#include "renderer/film/film.h"
#include "renderer/prepared/edited_materials.h"
#include "renderer/session/render_session.h"
#include "ui/edited_light.h"
#include "ui/latest_job.h"
#include "ui/orbit_camera.h"
#include "ui/scene_loader.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asos {

/// Until when a render refines. Nothing here restarts one: a limit that is raised lets it go on.
struct RefinementLimits {
  static constexpr double most_seconds = 86'400.0;

  double seconds = 0.0;  ///< of rendering, without pauses; 0: no limit
  double rmse = 0.0;     ///< of Previewer::estimated_rmse; 0: no limit

  bool operator==(const RefinementLimits&) const = default;
};

/// Why a render rests before it is finished.
enum class Rest { none, paused, time, quality, stopped };

/// What the window works on: the open scene, the camera, the settings, the render that runs and its
/// picture. Knows neither OpenGL nor ImGui. One thread; loading and rendering happen on others.
class Previewer {
 public:
  struct Hooks {
    LoadFunction load;           ///< empty: load_scene
    std::function<void()> wake;  ///< from other threads: something waits for `update`
    SceneNeeds forced = {};      ///< see prepare
  };
  Previewer(Hooks hooks, RenderSettings settings);

  /// Loads in the background. The open scene stays until the new one is there, and where that
  /// fails. A saved picture (.png, .exr) brings its scene, camera, lights and settings.
  void open(const std::string& source);
  /// Loads the open scene's file again; the view stays.
  void reload();
  /// Asks for a picture of this size. The first one counts at once, later ones when the size has
  /// been still for a moment. Sizes without area (a minimised window) are ignored.
  void set_picture_size(int width, int height, double now_seconds);
  /// Takes what other threads finished and restarts the render where what it depends on has
  /// changed. A render that has not covered the picture once is given a moment to do so: changes
  /// that come faster, as from a mouse, would else leave the picture's rim as it was. Call once or
  /// more a frame.
  void update(double now_seconds);
  /// Whether parts of the running render's picture still show the one before: then what arrives
  /// should be shown without delay.
  [[nodiscard]] bool first_picture_pending() const;
  /// When `update` next has something to do of its own accord, in seconds from now; none: when
  /// woken.
  [[nodiscard]] std::optional<double> seconds_to_update(double now_seconds) const;

  /// Widgets edit these; `update` notices.
  [[nodiscard]] RenderSettings& settings() { return settings_; }
  [[nodiscard]] const RenderSettings& settings() const { return settings_; }
  /// Settings, lights and materials as they were at first.
  void reset_settings();
  [[nodiscard]] OrbitCamera& camera() { return camera_; }
  [[nodiscard]] const OrbitCamera& camera() const { return camera_; }
  /// The scene's lights, relative to World::origin. Once they were edited, the scene gets them in
  /// the background, without its hierarchies being built anew.
  [[nodiscard]] const std::vector<EditedLight>& lights() const { return lights_; }
  [[nodiscard]] std::vector<EditedLight>& edit_lights();
  /// Whether the scene does not have the newest lights and materials yet.
  [[nodiscard]] bool relighting() const;
  /// The scene's own lights, as they were when it was opened.
  void reset_lights();
  /// How the scene's materials blur what they mirror. Edits reach the scene as those of lights do.
  [[nodiscard]] const MaterialDfrs& dfrs() const { return dfrs_; }
  [[nodiscard]] MaterialDfrs& edit_dfrs();
  /// As the materials were when the scene was opened.
  void reset_dfrs();
  /// The scene as it was prepared, before lights or materials were edited. Only with a scene.
  [[nodiscard]] const RenderScene& original_scene() const;

  /// What a person can take back: settings, lights, materials and the camera.
  struct Edits {
    RenderSettings settings;
    OrbitCamera camera;
    int chosen_camera = -1;
    std::vector<EditedLight> lights;
    std::uint64_t lights_revision = 0;
    MaterialDfrs dfrs;
    std::uint64_t dfrs_revision = 0;
  };
  [[nodiscard]] Edits edits() const;
  /// Whether these are the edits; the picture's size, which is the window's, does not count.
  [[nodiscard]] bool same_as(const Edits& edits) const;
  void restore(const Edits& edits);
  /// Grows whenever another scene is opened: what was done before cannot be taken back then.
  [[nodiscard]] std::uint64_t scenes_opened() const { return scenes_opened_; }

  /// Takes over the scene's camera `index`; -1: the view that frames everything.
  void choose_camera(int index);
  [[nodiscard]] int chosen_camera() const { return chosen_camera_; }
  void frame_all();
  /// The camera's view in a picture of the present size. Only with a scene.
  [[nodiscard]] View view() const;
  /// Whether the picture's size is known.
  [[nodiscard]] bool sized() const { return sized_; }
  /// What is seen at (x, y), in pixels; not valid where that is the background.
  [[nodiscard]] Hit seen_at(double x, double y) const;
  /// Orbits about what the picture shows at (x, y), in pixels, from now on.
  void set_pivot_at(double x, double y);

  [[nodiscard]] const RenderScene* scene() const { return scene_.get(); }
  [[nodiscard]] std::shared_ptr<const RenderScene> shared_scene() const { return scene_; }
  /// The source that was opened last, whether it could be or not.
  [[nodiscard]] const std::string& asked_for() const { return asked_for_; }
  /// The files that the open scene was read from, as they were when that was tried last.
  [[nodiscard]] const std::vector<FileStamp>& files() const { return files_; }
  [[nodiscard]] double load_seconds() const { return load_seconds_; }
  [[nodiscard]] std::optional<SceneLoader::Loading> loading() const { return loader_.loading(); }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  void dismiss_error() { error_.reset(); }
  /// Whether the error is that the open scene's file could not be read again: the scene stays.
  [[nodiscard]] bool reload_failed() const { return reload_failed_; }

  [[nodiscard]] const Film& film() const { return film_; }
  /// What of the film changed since the last call.
  [[nodiscard]] std::vector<PixelRect> take_changed() { return std::exchange(changed_, {}); }
  [[nodiscard]] Progress progress() const { return session_.progress(); }
  /// Lets the render rest, but for its coarse pictures, until it is asked to go on; through
  /// changes, too.
  void set_paused(bool paused) { paused_ = paused; }
  [[nodiscard]] bool paused() const { return paused_; }
  /// Ends the render as it is; `start_again` or a change begins anew.
  void stop();
  void start_again();
  [[nodiscard]] RefinementLimits& limits() { return limits_; }
  [[nodiscard]] const RefinementLimits& limits() const { return limits_; }
  [[nodiscard]] Rest rest() const { return rest_; }
  /// How far the picture is from the finished one: the root mean square difference of linear
  /// values, clipped to 0 to 1, taking the pixels that are left for as wrong as those that are
  /// finished were before. None before any is finished.
  [[nodiscard]] std::optional<double> estimated_rmse() const;
  [[nodiscard]] RenderStatistics statistics() const { return session_.statistics(); }
  /// How often a render was started.
  [[nodiscard]] std::uint64_t restarts() const { return restarts_; }
  /// What the picture that is shown follows from, whether it is finished or not. Only with one.
  [[nodiscard]] PictureDescription description(const PictureDisplay& display) const;
  /// What the picture that is shown is rendered from. Only with one.
  [[nodiscard]] Snapshot rendered_snapshot() const {
    return {rendered_.scene, rendered_.camera, rendered_.settings, false};
  }
  /// How the saved picture that was opened last was shown, once.
  [[nodiscard]] std::optional<PictureDisplay> take_opened_display() {
    return std::exchange(opened_display_, std::nullopt);
  }
  /// The settings of the render that runs, its size included.
  [[nodiscard]] const RenderSettings& rendered_settings() const { return rendered_.settings; }

 private:
  struct Rendered {
    std::shared_ptr<const RenderScene> scene;
    std::uint64_t camera_revision = 0;
    RenderSettings settings;
    Camera camera;
  };
  struct PendingSize {
    int width, height;
    double since_seconds;
  };

  struct Relight {
    std::shared_ptr<const RenderScene> scene;
    std::optional<std::vector<Light>> lights;  // none: the scene has them
    std::uint64_t lights_revision = 0;         // of what comes out
    MaterialDfrs dfrs;
  };
  struct Relit {
    std::shared_ptr<const RenderScene> from;
    Result<std::shared_ptr<const RenderScene>> scene;
    std::uint64_t lights_revision = 0;
  };
  [[nodiscard]] static Relit relit(const Relight& asked);

  void accept(LoadOutcome outcome);
  void take_over(const PictureDescription& picture);
  void take_over(const Camera& camera);
  void relight_if_edited();
  void settle_size(double now_seconds);
  [[nodiscard]] bool out_of_date() const;
  [[nodiscard]] bool should_wait(double now_seconds) const;
  void restart_if_changed(double now_seconds);
  void take_tiles();
  void rest_or_go_on();
  [[nodiscard]] double aspect_ratio() const;

  const RenderSettings first_settings_;
  RenderSettings settings_;
  OrbitCamera camera_;
  int chosen_camera_ = -1;
  std::vector<EditedLight> lights_;
  std::uint64_t lights_revision_ = 0;
  std::uint64_t lights_asked_for_ = 0;  // revision
  std::uint64_t lights_of_scene_ = 0;   // revision
  MaterialDfrs dfrs_;
  std::uint64_t dfrs_revision_ = 0;
  std::uint64_t dfrs_asked_for_ = 0;  // revision
  std::uint64_t scenes_opened_ = 0;
  bool keep_view_ = false;  // what is being loaded is the same scene again
  bool reload_failed_ = false;
  std::shared_ptr<const RenderScene> scene_;
  std::string asked_for_;
  double load_seconds_ = 0.0;
  std::vector<FileStamp> files_;
  std::optional<Error> error_;
  std::optional<PictureDisplay> opened_display_;
  bool sized_ = false;
  std::optional<PendingSize> pending_size_;

  Rendered rendered_;
  double restarted_seconds_ = 0.0;
  std::int64_t pixels_taken_ = 0;  // of the tiles of the render that runs
  double corrected_ = 0.0;         // squared differences that its final pixels made
  std::int64_t pixels_finished_ = 0;
  bool paused_ = false;
  RefinementLimits limits_;
  Rest rest_ = Rest::none;
  Film film_;
  std::vector<PixelRect> changed_;
  std::uint64_t restarts_ = 0;
  RenderSession session_;  // after what its callback uses, before the loader
  SceneLoader loader_;
  LatestJob<Relight, Relit> relighter_;
};

}  // namespace asos
