#pragma once

#include "renderer/result.h"
#include "renderer/settings/settings.h"
#include "renderer/shading/sky_choice.h"

#include <nlohmann/json_fwd.hpp>

namespace asos {

/// All settings that a picture depends on, which is all but the number of threads, by the names of
/// their members; choices by their names on the command line. The sky is "neutral", two colours, or
/// a file and by how much it is turned.
[[nodiscard]] nlohmann::ordered_json settings_json(const RenderSettings& settings);
/// The same with another sky than theirs.
[[nodiscard]] nlohmann::ordered_json settings_json(const RenderSettings& settings,
                                                   const SkyChoice& sky);

struct DescribedSettings {
  RenderSettings settings;  ///< `validated`; the sky is not made yet
  SkyChoice sky;
};
/// Reads back what settings_json wrote. The error's subject is "settings".
[[nodiscard]] Result<DescribedSettings> settings_from_json(const nlohmann::ordered_json& json);

}  // namespace asos
