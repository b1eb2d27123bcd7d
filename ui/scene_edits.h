#pragma once

#include "renderer/picture/picture_description.h"
#include "renderer/settings/settings.h"
#include "ui/carried_edits.h"
#include "ui/chosen_look.h"
#include "ui/open_scene.h"
#include "ui/relighter.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace asos::ui {

/// A person's edits of the open scene: its render settings, its lights and its materials'
/// defocusing ratios (DFR). Lights and ratios are applied to the scene in the background. All
/// members must be called from one thread.
class SceneEdits {
 public:
  /// `scene` must outlive the object. `reset` restores `settings`. `wake` is called from another
  /// thread when `relight` has a result to take.
  SceneEdits(OpenScene& scene, const RenderSettings& settings, std::function<void()> wake);

  /// The settings that widgets edit. The viewpoint sets their width and height.
  [[nodiscard]] RenderSettings& settings() { return now_.settings; }
  [[nodiscard]] const RenderSettings& settings() const { return now_.settings; }
  /// Restores the initial settings, lights and materials.
  void reset();

  /// The scene's lights, relative to World::origin. Edited lights are applied in the background,
  /// without rebuilding the hierarchies.
  [[nodiscard]] const std::vector<EditedLight>& lights() const { return now_.look.lights; }
  [[nodiscard]] std::vector<EditedLight>& edit_lights();
  /// The lights that the scene was opened with, under its sky.
  [[nodiscard]] const std::vector<EditedLight>& opened_lights() const { return first_lights_; }
  /// Restores the lights that the scene was opened with, or those of its sky.
  void reset_lights();
  /// Scenes opened later get these parts from the initial settings instead of their default look.
  void keep_first(const ChosenLook& parts) { keeps_ = parts; }
  /// Returns the ground of scenes opened later; none: that of their default look.
  [[nodiscard]] std::optional<Ground> own_ground() const;
  /// Sets the sky, also for scenes opened later; null: the neutral sky. A scene without its own
  /// lights gets new ones if the old or the new sky brings any (lights_under). A background that
  /// was not chosen follows.
  void set_sky(std::shared_ptr<const Sky> sky);
  /// Rotates an image or environment sky to this angle from its first position, with the lights of
  /// a scene that an environment lights.
  void turn_sky(double turn_deg);
  /// Sets the brightness factor of an image or environment sky and of its lights.
  void brighten_sky(double times);
  /// Rotates the scene's surroundings about the vertical axis, counter-clockwise seen from above:
  /// an image or environment sky, and the default lights of a scene that has none.
  void turn_surroundings(double by_rad);
  /// The materials' defocusing ratios. Edits are applied in the background like those of lights.
  [[nodiscard]] const MaterialDfrs& dfrs() const { return now_.look.dfrs; }
  [[nodiscard]] MaterialDfrs& edit_dfrs();
  /// Restores the materials that the scene was opened with.
  void reset_dfrs();
  /// Whether the scene does not have the newest lights and materials yet.
  [[nodiscard]] bool relighting() const { return relighter_.pending(now_.look); }
  /// Applies the newest lights and materials in the background. Call at least once a frame.
  void relight() { relighter_.update(scene_, now_.look); }
  /// Revisions of the lights and materials that a scene has.
  struct Revisions {
    std::uint64_t lights = 0, dfrs = 0;
  };
  [[nodiscard]] Revisions revisions() const {
    return {now_.look.lights_revision, now_.look.dfrs_revision};
  }
  /// Call when the open scene was replaced by another pose of it that has these edits.
  void scene_has(const Revisions& edits) { relighter_.start_over(edits.lights, edits.dfrs); }
  /// Starts from a scene that was just opened: from its lights and materials, and from the settings
  /// of its saved picture, if any. Requires a scene.
  void adopt_scene(const std::optional<PictureDescription>& picture);
  /// Starts from a scene that was loaded again in place of `before`. Edits of lights and DFRs stay
  /// where the light or material still exists. `moved`: see OpenScene::Opened.
  CarriedEdits adopt_again(const RenderScene& before, glm::dvec3 moved);
  /// The revisions that the scene was opened with, before any edit.
  [[nodiscard]] const Revisions& opened_revisions() const { return opened_; }

  /// The state that undo restores.
  struct State {
    RenderSettings settings;
    SceneLook look;
    bool lights_edited = false;  ///< false: they are those of the scene or of its sky
    bool dfrs_edited = false;
  };
  [[nodiscard]] const State& state() const { return now_; }
  /// Whether the edits equal this state. The picture's size does not count: the window sets it.
  [[nodiscard]] bool same_as(const State& state) const;
  void restore(const State& state);

 private:
  void set_all_but_size(RenderSettings settings);
  void put_sky(std::shared_ptr<const Sky> sky);
  void take_default_look();
  void follow_background(const Sky* sky);
  [[nodiscard]] bool environment_lights_scene() const;

  OpenScene& scene_;
  std::vector<EditedLight> first_lights_;  // as the scene was opened, under its sky
  Revisions opened_;
  RenderSettings first_settings_;
  ChosenLook keeps_;
  bool sky_chosen_ = false;  // by set_sky
  State now_;
  Relighter relighter_;
};

}  // namespace asos::ui
