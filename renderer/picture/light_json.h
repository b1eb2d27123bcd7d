#pragma once

#include "renderer/result.h"
#include "renderer/scene/scene.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace asos {

/// Lights as they are in a World, with all that they have, by the names of their members.
[[nodiscard]] nlohmann::ordered_json lights_json(const std::vector<Light>& lights);
/// The error's subject is "lights".
[[nodiscard]] Result<std::vector<Light>> lights_from_json(const nlohmann::ordered_json& json);

}  // namespace asos
