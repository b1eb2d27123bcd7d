#pragma once

#include "renderer/film/tone.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/settings/settings.h"

#include <stop_token>

namespace asos {

/// How bright a picture is, by a small picture of the same view.
struct Metering {
  double whitened = 0.0;  ///< share of the pixels that are shown white at an exposure of 0
  float stops = 0.0f;     ///< exposure at which few are: the brightest twentieth is near white
};

/// The share of a picture that a file's lights may whiten before the exposure follows them.
inline constexpr double most_whitened = 0.1;

/// Meters the view with the same samples whatever the picture's size, the method and the number of
/// threads. Unlit surfaces do not count: no exposure changes them.
[[nodiscard]] Metering meter(const RenderScene& scene, const Camera& camera,
                             const RenderSettings& settings, ToneCurve tone,
                             const std::stop_token& stop = {});

/// The exposure of a picture for which nobody chose one: the metered one where lights of the file
/// whiten more than most_whitened of it; else 0. Built-in scenes and scenes without lights of their
/// own keep 0.
[[nodiscard]] Metering usual_exposure(const RenderScene& scene, const Camera& camera,
                                      const RenderSettings& settings, ToneCurve tone,
                                      const std::stop_token& stop = {});
/// Whether it may be another than 0.
[[nodiscard]] bool exposure_may_follow(const RenderScene& scene);

}  // namespace asos
