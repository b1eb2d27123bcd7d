#pragma once

#include "renderer/picture/picture_description.h"
#include "renderer/settings/settings.h"
#include "ui/chosen_look.h"
#include "ui/open_scene.h"
#include "ui/relighter.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace asos::ui {

/// A person's edits of the open scene: the settings that it is rendered with, its lights and its
/// materials' defocusing ratios (DFR). Lights and ratios reach the scene in the background. All
/// members are for one thread.
class SceneEdits {
 public:
  /// `scene` must outlive it. `settings` are those that `reset` goes back to. `wake` is called from
  /// another thread when `relight` has something to do.
  SceneEdits(OpenScene& scene, const RenderSettings& settings, std::function<void()> wake);

  /// Widgets edit these. Their width and height are the picture's, which the viewpoint sets.
  [[nodiscard]] RenderSettings& settings() { return now_.settings; }
  [[nodiscard]] const RenderSettings& settings() const { return now_.settings; }
  /// Settings, lights and materials as they were at first.
  void reset();

  /// The scene's lights, relative to World::origin. Once they were edited, the scene gets them in
  /// the background, without its hierarchies being built anew.
  [[nodiscard]] const std::vector<EditedLight>& lights() const { return now_.look.lights; }
  [[nodiscard]] std::vector<EditedLight>& edit_lights();
  /// The lights that the scene was opened with, or those that its sky brings.
  void reset_lights();
  /// Scenes that are opened have these parts of the first settings, not their default look.
  void keep_first(const ChosenLook& parts) { keeps_ = parts; }
  /// Another sky, null: the neutral one, which scenes keep that are opened from then on. The lights
  /// of a scene without its own follow where it or the one before brings any (lights_under); the
  /// background follows where nobody chose one.
  void set_sky(std::shared_ptr<const Sky> sky);
  /// Turns a sky that is a picture or an environment to this angle from its first position, with
  /// the lights of a scene that an environment lights.
  void turn_sky(double turn_deg);
  /// Multiplies the radiance of such a sky by `times`, and those lights.
  void brighten_sky(double times);
  /// Turns what surrounds the scene about the vertical, counter-clockwise as seen from above: a sky
  /// of a picture or an environment; and the lights of a scene without its own, with which it is
  /// lit.
  void turn_surroundings(double by_rad);
  /// How the scene's materials blur what they mirror. Edits reach the scene as those of lights do.
  [[nodiscard]] const MaterialDfrs& dfrs() const { return now_.look.dfrs; }
  [[nodiscard]] MaterialDfrs& edit_dfrs();
  /// As the materials were when the scene was opened.
  void reset_dfrs();
  /// Whether the scene does not have the newest lights and materials yet.
  [[nodiscard]] bool relighting() const { return relighter_.pending(now_.look); }
  /// Gives the scene the newest lights and materials, in the background. Call once or more a frame.
  void relight() { relighter_.update(scene_, now_.look); }
  /// The edits of lights and materials that a scene has.
  struct Revisions {
    std::uint64_t lights = 0, dfrs = 0;
  };
  [[nodiscard]] Revisions revisions() const {
    return {now_.look.lights_revision, now_.look.dfrs_revision};
  }
  /// The open scene at another time has taken its place, with these edits.
  void scene_has(const Revisions& edits) { relighter_.start_over(edits.lights, edits.dfrs); }
  /// Starts from the scene that has just been opened: from its lights and materials, and from the
  /// settings of the saved picture that it came with, if any. Only with a scene.
  void adopt_scene(const std::optional<PictureDescription>& picture);

  /// The state that undo restores.
  struct State {
    RenderSettings settings;
    SceneLook look;
    bool lights_edited = false;  ///< else they are those of the scene or of its sky
    bool dfrs_edited = false;
  };
  [[nodiscard]] const State& state() const { return now_; }
  /// Whether this is the state; the picture's size, which is the window's, does not count.
  [[nodiscard]] bool same_as(const State& state) const;
  void restore(const State& state);

 private:
  void set_all_but_size(RenderSettings settings);
  void put_sky(std::shared_ptr<const Sky> sky);
  void take_default_look();
  void follow_background(const Sky* sky);
  [[nodiscard]] bool environment_lights_scene() const;

  OpenScene& scene_;
  RenderSettings first_settings_;
  ChosenLook keeps_;
  bool sky_chosen_ = false;  // by set_sky
  State now_;
  Relighter relighter_;
};

}  // namespace asos::ui
