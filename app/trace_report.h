#pragma once

#include "renderer/asos/pixel_trace.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/settings/settings.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace asos {

/// Whose pixel was traced.
struct TracedPicture {
  std::string scene;  ///< as named on the command line
  std::string camera;
  RenderSettings settings;  ///< the settings it was rendered with
};

/// How a pixel was subdivided: the papers' table level by level, then every cell, then the pyrays
/// that its leaves sent on to lights and by way of mirrors, with the cells of each. Objects are
/// named by their part and material. Places are shares of the pixel, or of the pyray's own square,
/// from its top left corner.
[[nodiscard]] nlohmann::ordered_json trace_json(const PixelTrace& trace, const RenderScene& scene,
                                                const TracedPicture& picture);

/// The same for a person: tables at most 100 columns wide.
[[nodiscard]] std::string trace_text(const nlohmann::ordered_json& trace);

}  // namespace asos
