#pragma once

#include "renderer/result.h"
#include "renderer/shading/dfr.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <vector>

namespace asos {

/// Three curves and their perturbation by the names of their members; null for none.
[[nodiscard]] nlohmann::ordered_json dfr_json(const std::optional<Dfr>& dfr);
/// The error's subject is "dfr".
[[nodiscard]] Result<std::optional<Dfr>> dfr_from_json(const nlohmann::ordered_json& json);

/// One for each material.
[[nodiscard]] nlohmann::ordered_json dfrs_json(const std::vector<std::optional<Dfr>>& dfrs);
/// The error's subject is "dfrs"; ratios are from 0 to 1.
[[nodiscard]] Result<std::vector<std::optional<Dfr>>> dfrs_from_json(
    const nlohmann::ordered_json& json);

}  // namespace asos
