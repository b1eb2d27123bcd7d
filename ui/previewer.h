#pragma once

#include "renderer/film/tone.h"
#include "renderer/settings/settings.h"
#include "renderer/world/needs.h"
#include "ui/free_memory.h"
#include "ui/ground_layer.h"
#include "ui/open_scene.h"
#include "ui/playback.h"
#include "ui/preview_render.h"
#include "ui/refinement.h"
#include "ui/scene_edits.h"
#include "ui/stroke_drawer.h"
#include "ui/turntable.h"
#include "ui/viewpoint.h"

#include <functional>
#include <optional>

namespace asos {

/// The model that the window works on: the open scene, what a person edits of it, the viewpoint,
/// and the render of it all with its refinement. Knows neither OpenGL nor ImGui. One thread;
/// loading, relighting and rendering happen on others.
class Previewer {
 public:
  struct Hooks {
    LoadFunction load;           ///< empty: load_scene
    std::function<void()> wake;  ///< from other threads: something waits for `update`
    SceneNeeds forced = {};      ///< see prepare
  };
  Previewer(Hooks hooks, const RenderSettings& settings);

  [[nodiscard]] OpenScene& scene() { return scene_; }
  [[nodiscard]] const OpenScene& scene() const { return scene_; }
  [[nodiscard]] SceneEdits& edits() { return edits_; }
  [[nodiscard]] const SceneEdits& edits() const { return edits_; }
  [[nodiscard]] Playback& playback() { return playback_; }
  [[nodiscard]] const Playback& playback() const { return playback_; }
  [[nodiscard]] Viewpoint& viewpoint() { return viewpoint_; }
  [[nodiscard]] const Viewpoint& viewpoint() const { return viewpoint_; }
  [[nodiscard]] Turntable& turntable() { return turntable_; }
  [[nodiscard]] const Turntable& turntable() const { return turntable_; }
  [[nodiscard]] Refinement& refinement() { return refinement_; }
  [[nodiscard]] const Refinement& refinement() const { return refinement_; }
  [[nodiscard]] PreviewRender& render() { return render_; }
  [[nodiscard]] const PreviewRender& render() const { return render_; }

  /// The curve that the picture is shown by: methods that judge what shows render it anew.
  void show_by(ToneCurve tone) { shown_tone_ = tone; }
  [[nodiscard]] ToneCurve shown_tone() const { return shown_tone_; }
  /// The layer that is shown, which is rendered beside the picture where the method has it.
  void show_layer(std::optional<Layer> layer) { shown_layer_ = layer; }

  /// Whether memory that scenes of before have left is still to go back to the system.
  [[nodiscard]] bool gives_memory_back() const {
    return holds_free_memory_ || free_memory_.pending();
  }

  /// Takes what other threads finished and lets the render follow what has changed. Call once or
  /// more a frame.
  void update(double now_seconds);
  /// When `update` next has something to do of its own accord, in seconds from now; none: when
  /// woken.
  [[nodiscard]] std::optional<double> seconds_to_update(double now_seconds) const;

 private:
  void take_over(const OpenScene::Opened& opened);
  /// The subject to render: nothing before there are a scene and a size.
  [[nodiscard]] PreviewRender::Subject subject() const;
  /// Whether the present view has been shown for so long, or at a sample for each pixel.
  [[nodiscard]] bool has_shown(double seconds, double now_seconds) const;
  [[nodiscard]] std::optional<Playback::WantedStrokes> wanted_strokes() const;

  // Each refers to some of those before it.
  OpenScene scene_;
  SceneEdits edits_;
  Playback playback_;
  Viewpoint viewpoint_;
  Turntable turntable_;
  GroundLayer ground_;
  StrokeDrawer strokes_;
  Refinement refinement_;
  PreviewRender render_;
  FreeMemory free_memory_;
  std::optional<Layer> shown_layer_;
  ToneCurve shown_tone_ = ToneCurve::none;
  bool holds_free_memory_ = false;  // loading has left some
};

}  // namespace asos
