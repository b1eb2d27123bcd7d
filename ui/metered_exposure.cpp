#include "ui/metered_exposure.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace asos::ui {

MeteredExposure::MeteredExposure()
    : job_([](const Request& r) { return meter(*r.scene, r.camera, r.settings, r.tone); }, {},
           Overtaken::dropped) {}

void MeteredExposure::scene_opened(DisplaySettings& display, bool as_saved) {
  metered_.reset();
  if (display.auto_exposure && !as_saved) display.exposure_ev = 0.0f;
  display.auto_exposure = was_auto_ = false;
  // An exposure that the user chose stays.
  looks_ = !as_saved && display.exposure_ev == 0.0f;
}

std::string MeteredExposure::take(DisplaySettings& display) {
  const auto metered = job_.take_outcome();
  if (!metered) return {};
  const bool switched = !display.auto_exposure;
  // The user may have moved the slider meanwhile.
  if (switched && (metered->whitened <= most_whitened || display.exposure_ev != 0.0f)) return {};
  constexpr float limit = DisplaySettings::exposure_limit_ev;
  display.auto_exposure = was_auto_ = true;
  display.exposure_ev = set_stops_ = std::clamp(metered->stops, -limit, limit);
  return switched ? fmt::format("Auto exposure {:+.1f} EV: bright lights", set_stops_) : "";
}

std::string MeteredExposure::update(const Previewer& previewer, DisplaySettings& display) {
  if (display.auto_exposure && was_auto_ && display.exposure_ev != set_stops_)
    display.auto_exposure = false;
  if (display.auto_exposure && !was_auto_) {
    set_stops_ = display.exposure_ev;
    metered_.reset();
  }
  was_auto_ = display.auto_exposure;
  std::string said = take(display);
  const std::shared_ptr<const RenderScene> scene = previewer.scene().shared();
  if (!scene || !previewer.viewpoint().sized()) return said;
  const bool opened = std::exchange(looks_, false) && exposure_may_follow(*scene);
  if (!opened && !(display.auto_exposure && metered_.lock() != scene)) return said;
  metered_ = scene;
  job_.ask(
      {scene, previewer.viewpoint().camera().camera(), previewer.edits().settings(), display.tone});
  return said;
}

}  // namespace asos::ui
