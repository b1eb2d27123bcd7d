#pragma once

#include "asos/render.h"
#include "renderer/session/render_session.h"

namespace asos::api {

/// A picture that can be rendered: scene, camera and settings are checked, and the scene has the
/// light, ground, lines and points of the picture.
struct ReadyPicture {
  Snapshot snapshot;
  ToneCurve tone = ToneCurve::neutral;  ///< of saved pictures
};

[[nodiscard]] Result<ReadyPicture> ready_picture(const Scene& scene, const Camera& camera,
                                                 const Settings& settings);

/// Fails for no curve of the interface.
[[nodiscard]] Result<ToneCurve> curve_of(Tone tone);

[[nodiscard]] Progress progress_of(const asos::Progress& progress);

}  // namespace asos::api
