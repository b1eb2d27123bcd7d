#pragma once

#include "renderer/result.h"
#include "renderer/shading/dfr.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <vector>

namespace asos {

/// Returns three curves and their perturbation by their members' names; null for none.
[[nodiscard]] nlohmann::ordered_json dfr_json(const std::optional<Dfr>& dfr);
/// Reads ratios. The error's subject is "dfr".
[[nodiscard]] Result<std::optional<Dfr>> dfr_from_json(const nlohmann::ordered_json& json);

/// Returns one entry for each material.
[[nodiscard]] nlohmann::ordered_json dfrs_json(const std::vector<std::optional<Dfr>>& dfrs);
/// Reads the entries. The error's subject is "dfrs"; ratios are from 0 to 1.
[[nodiscard]] Result<std::vector<std::optional<Dfr>>> dfrs_from_json(
    const nlohmann::ordered_json& json);

}  // namespace asos
