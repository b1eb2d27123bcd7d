#pragma once

#include "renderer/asos/pixel_trace.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/settings/settings.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace asos {

/// The picture whose pixel was traced.
struct TracedPicture {
  std::string scene;  ///< as named on the command line
  std::string camera;
  std::optional<ClipTime> time;  ///< none: the rest pose
  RenderSettings settings;       ///< the settings it was rendered with
};

/// The subdivision of a pixel: the papers' table level by level, then every cell, then the shadow
/// and mirror pyrays of its leaves with their cells. Objects are named by part and material. Places
/// are fractions of the pixel, or of the pyray's own square, from its top left corner.
[[nodiscard]] nlohmann::ordered_json trace_json(const PixelTrace& trace, const RenderScene& scene,
                                                const TracedPicture& picture);

/// The same as text: tables at most 100 columns wide.
[[nodiscard]] std::string trace_text(const nlohmann::ordered_json& trace);

}  // namespace asos
