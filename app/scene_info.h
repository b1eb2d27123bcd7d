#pragma once

#include "renderer/scene/scene.h"
#include "renderer/scene/world.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace asos {

/// What is in a scene, what of it is not supported, and what is left out because nothing needs it.
/// `world` is the flattened `scene`. Bounds and positions are the author's coordinates. Lights are
/// counted by type; "ball" counts those of the points and spots that have a radius, "sun" those of
/// the directional ones that have an angular diameter.
[[nodiscard]] nlohmann::ordered_json scene_info_json(const Scene& scene, const World& world);

/// The same for a person: lines of text, without what is empty.
[[nodiscard]] std::string scene_info_text(const nlohmann::ordered_json& info);

}  // namespace asos
