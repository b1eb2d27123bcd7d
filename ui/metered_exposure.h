#pragma once

#include "renderer/comparison/auto_exposure.h"
#include "ui/display_settings.h"
#include "ui/latest_job.h"
#include "ui/previewer.h"

#include <memory>
#include <string>

namespace asos::ui {

/// Sets the exposure while DisplaySettings::auto_exposure is on. Switches it on for a scene whose
/// lights would overexpose too much of the picture (usual_exposure). Meters on its own thread.
class MeteredExposure {
 public:
  MeteredExposure();

  /// Call when another scene was opened. `as_saved`: the exposure comes from a saved picture and
  /// stays.
  void scene_opened(DisplaySettings& display, bool as_saved);
  /// Call once a frame. Returns a message when auto exposure was switched on.
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

  bool looks_ = false;      // the opened scene is still to be metered
  bool was_auto_ = false;   // in the last frame
  float set_stops_ = 0.0f;  // exposure that this object set
  std::weak_ptr<const RenderScene> metered_;
  LatestJob<Request, Metering> job_;
};

}  // namespace asos::ui
