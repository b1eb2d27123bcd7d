#pragma once

#include "renderer/film/tone.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/settings/settings.h"

#include <stop_token>

namespace asos {

/// The brightness of a picture, measured on a small picture of the same view.
struct Metering {
  double whitened = 0.0;  ///< fraction of the pixels that are white at an exposure of 0
  /// Exposure at which few pixels are white: the brightest twentieth is close to white.
  float stops = 0.0f;
};

/// The largest fraction of white pixels in a picture that needs no automatic exposure.
inline constexpr double most_whitened = 0.1;

/// Meters the view with the same samples for every picture size, method and number of threads.
/// Unlit surfaces are ignored, since exposure does not affect them.
[[nodiscard]] Metering meter(const RenderScene& scene, const Camera& camera,
                             const RenderSettings& settings, ToneCurve tone,
                             const std::stop_token& stop = {});

/// Returns the default exposure of a picture: the metered one if the lights of the file make more
/// than most_whitened of it white; else 0. Built-in scenes, and scenes without lights of their own,
/// keep 0.
[[nodiscard]] Metering usual_exposure(const RenderScene& scene, const Camera& camera,
                                      const RenderSettings& settings, ToneCurve tone,
                                      const std::stop_token& stop = {});
/// Returns whether the default exposure may differ from 0.
[[nodiscard]] bool exposure_may_follow(const RenderScene& scene);

}  // namespace asos
