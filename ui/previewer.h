#pragma once

#include "renderer/film/tone.h"
#include "renderer/settings/settings.h"
#include "renderer/world/render_features.h"
#include "ui/free_memory.h"
#include "ui/ground_layer.h"
#include "ui/line_drawer.h"
#include "ui/open_scene.h"
#include "ui/playback.h"
#include "ui/preview_render.h"
#include "ui/refinement.h"
#include "ui/scene_edits.h"
#include "ui/turntable.h"
#include "ui/viewpoint.h"

#include <functional>
#include <optional>
#include <utility>

namespace asos::ui {

/// The window's model: the open scene, its edits, the viewpoint, and the render with its
/// refinement. Independent of OpenGL and ImGui. Not thread-safe; loading, relighting and rendering
/// happen on other threads.
class Previewer {
 public:
  struct Hooks {
    LoadFunction load;           ///< empty: load_scene
    std::function<void()> wake;  ///< called from other threads when `update` has a result to take
    RenderFeatures forced = {};  ///< see prepare
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

  /// Sets the displayed tone curve; methods that limit the displayed error render again.
  void show_by(ToneCurve tone) { shown_tone_ = tone; }
  [[nodiscard]] ToneCurve shown_tone() const { return shown_tone_; }
  /// The displayed layer, which is rendered with the picture if the method supports it.
  void show_layer(std::optional<Layer> layer) { shown_layer_ = layer; }

  /// Whether freed memory of previous scenes is still to be returned to the system.
  [[nodiscard]] bool gives_memory_back() const {
    return holds_free_memory_ || free_memory_.pending();
  }

  /// Whether another file was opened, and nothing of it is displayed yet.
  [[nodiscard]] bool awaits_first_picture() const { return awaits_first_picture_; }

  /// Returns the edits that stayed when the scene was loaded again, once.
  [[nodiscard]] std::optional<CarriedEdits> take_carried() {
    return std::exchange(carried_, std::nullopt);
  }

  /// Takes the results of other threads and restarts the render if its inputs changed. Call at
  /// least once a frame.
  void update(double now_seconds);
  /// Seconds until `update` is due without any event; none: only after events.
  [[nodiscard]] std::optional<double> seconds_to_update(double now_seconds) const;

 private:
  void await_first_picture();
  void take_over(const OpenScene::Opened& opened, const RenderScene* before);
  /// The subject to render; empty before there are a scene and a picture size.
  [[nodiscard]] PreviewRender::Subject subject() const;
  /// Whether the present view has been rendered for this long, or has one sample per pixel.
  [[nodiscard]] bool has_shown(double seconds, double now_seconds) const;
  [[nodiscard]] std::optional<Playback::LineRequest> wanted_lines() const;
  [[nodiscard]] std::optional<Playback::WantedExposure> wanted_exposure() const;
  [[nodiscard]] int followed_camera() const;

  // Order matters: each member refers to earlier ones.
  OpenScene scene_;
  SceneEdits edits_;
  Playback playback_;
  Viewpoint viewpoint_;
  Turntable turntable_;
  GroundLayer ground_;
  LineDrawer lines_and_points_;
  Refinement refinement_;
  PreviewRender render_;
  FreeMemory free_memory_;
  std::optional<CarriedEdits> carried_;
  std::optional<Layer> shown_layer_;
  ToneCurve shown_tone_ = ToneCurve::none;
  bool awaits_first_picture_ = false;
  bool holds_free_memory_ = false;  // loading has left some
};

}  // namespace asos::ui
