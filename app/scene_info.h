#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/scene/scene.h"
#include "renderer/world/needs.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>

namespace asos {

/// The contents of a scene, those not supported, and those left out because nothing needs them.
/// `ready` is the prepared `scene`. Bounds and positions are the author's coordinates. Lights are
/// counted by type; "ball" counts those of the points and spots that have a radius, "sun" those of
/// the directional ones that have an angular diameter.
[[nodiscard]] nlohmann::ordered_json scene_info_json(const Scene& scene, const RenderScene& ready);

/// The features that were left out: an array of objects with `feature`, `reason` and, where there
/// is something of that sort, `stages`, `memory`, `controls` and `rows`.
[[nodiscard]] nlohmann::ordered_json left_out_json(const SceneNeeds& needs);

inline constexpr std::size_t most_lines_a_list = 20;

/// A scene's information for a person: lines of text, without what is empty; of each list the first
/// `most` entries, and how many more there are.
[[nodiscard]] std::string scene_info_text(const nlohmann::ordered_json& info,
                                          std::size_t most = most_lines_a_list);

}  // namespace asos
