#pragma once

#include "renderer/result.h"
#include "renderer/scene/scene.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace asos {

/// Returns the lights of a World with all members, by their names.
[[nodiscard]] nlohmann::ordered_json lights_json(const std::vector<Light>& lights);
/// Reads lights. The error's subject is "lights".
[[nodiscard]] Result<std::vector<Light>> lights_from_json(const nlohmann::ordered_json& json);

}  // namespace asos
