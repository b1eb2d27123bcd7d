#pragma once

#include "renderer/film/layers.h"
#include "renderer/film/split_map.h"
#include "renderer/film/tone.h"

#include <optional>

namespace asos {

/// How a finished picture is shown. Nothing here restarts a render but the tone curve, by which EPS
/// judges what shows (judged_by).
struct DisplaySettings {
  static constexpr float exposure_limit_ev = 20.0f;  // suns have 100,000 lx

  float exposure_ev = 0.0f;    ///< stops
  bool auto_exposure = false;  ///< it follows the scene: see MeteredExposure
  ToneCurve tone = ToneCurve::neutral;
  bool show_split_map = false;  ///< over the picture: the split pixels in colours
  float split_dimming = 0.7f;   ///< how dark the split map makes the other pixels, 0 to 1
  bool show_grid = false;       ///< and the axes, over the picture
  bool show_legend = true;      ///< of the split map, over the picture
  SplitMapColours split_colours = SplitMapColours::level;
  std::optional<Layer> layer;  ///< shown in place of the picture, in false colours; none: that

  [[nodiscard]] DisplayTransform transform() const { return {exposure_ev, tone}; }

  bool operator==(const DisplaySettings&) const = default;
};

}  // namespace asos
