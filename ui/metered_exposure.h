#pragma once

#include "renderer/comparison/auto_exposure.h"
#include "ui/display_settings.h"
#include "ui/latest_job.h"
#include "ui/previewer.h"

#include <memory>
#include <string>

namespace asos::ui {

/// Keeps the exposure of the window as DisplaySettings::auto_exposure asks. Switches that on for a
/// scene whose lights would whiten too much of the picture (usual_exposure). Meters on a thread of
/// its own.
class MeteredExposure {
 public:
  MeteredExposure();

  /// Another scene was opened. `as_saved`: with the exposure of a saved picture, which stays.
  void scene_opened(DisplaySettings& display, bool as_saved);
  /// Call once a frame. Returns a message where the exposure was switched to follow the scene.
  [[nodiscard]] std::string update(const Previewer& previewer, DisplaySettings& display);
  [[nodiscard]] bool busy() const { return looks_ || job_.pending(); }

 private:
  struct Request {
    std::shared_ptr<const RenderScene> scene;
    Camera camera;
    RenderSettings settings;
    ToneCurve tone = ToneCurve::none;
  };
  [[nodiscard]] std::string take(DisplaySettings& display);

  bool looks_ = false;      // a scene was opened that is to be metered
  bool was_auto_ = false;   // in the last frame
  float set_stops_ = 0.0f;  // by this
  std::weak_ptr<const RenderScene> metered_;
  LatestJob<Request, Metering> job_;
};

}  // namespace asos::ui
