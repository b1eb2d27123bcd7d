#pragma once

#include "renderer/film/layers.h"
#include "renderer/film/split_map.h"
#include "renderer/film/tone.h"

#include <optional>

namespace asos::ui {

/// How a finished picture is displayed. Only the tone curve restarts a render, because EPS limits
/// the error of displayed colours (judged_by).
struct DisplaySettings {
  static constexpr float exposure_limit_ev = 20.0f;  // suns have 100,000 lx

  float exposure_ev = 0.0f;    ///< stops
  bool auto_exposure = false;  ///< the exposure follows the scene: see MeteredExposure
  ToneCurve tone = ToneCurve::neutral;
  bool show_split_map = false;  ///< draws the split pixels in colours over the picture
  float split_dimming = 0.7f;   ///< darkening of the unsplit pixels in the split map, 0 to 1
  bool show_grid = false;       ///< draws grid and axes over the picture
  bool show_axes = true;        ///< draws axes that turn the view
  bool show_scale = true;       ///< draws a scale bar over pictures of scenes in metres
  bool show_legend = true;      ///< draws the split map's legend over the picture
  SplitMapColours split_colours = SplitMapColours::level;
  std::optional<Layer> layer;  ///< in false colours in place of the picture; none: the picture

  [[nodiscard]] DisplayTransform transform() const { return {exposure_ev, tone}; }

  bool operator==(const DisplaySettings&) const = default;
};

}  // namespace asos::ui
