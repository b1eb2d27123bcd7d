#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/scene/scene.h"
#include "renderer/world/render_features.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>

namespace asos {

/// The contents of a scene, with unsupported features and those left out because nothing needs
/// them. `ready` is the prepared `scene`. Bounds and positions are in the author's coordinates.
/// Lights are counted by type; "ball" counts the points and spots with a radius, "sun" the
/// directional ones with an angular diameter.
[[nodiscard]] nlohmann::ordered_json scene_info_json(const Scene& scene, const RenderScene& ready);

/// The features that were left out: an array of objects with `feature`, `reason` and, if present,
/// `stages`, `memory`, `controls` and `rows`.
[[nodiscard]] nlohmann::ordered_json left_out_json(const RenderFeatures& render_features);

inline constexpr std::size_t most_lines_a_list = 20;

/// A scene's information as lines of text, without empty items. A list shows its first
/// `most` entries and the number of the others.
[[nodiscard]] std::string scene_info_text(const nlohmann::ordered_json& info,
                                          std::size_t most = most_lines_a_list);

}  // namespace asos
