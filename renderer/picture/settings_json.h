#pragma once

#include "renderer/result.h"
#include "renderer/settings/settings.h"
#include "renderer/shading/sky_choice.h"

#include <nlohmann/json_fwd.hpp>

namespace asos {

/// Returns all settings on which a picture depends, which are all except the number of threads, by
/// their members' names; choices by their names on the command line. The sky is "neutral", two
/// colours, or an environment or a file with turn and brightness.
[[nodiscard]] nlohmann::ordered_json settings_json(const RenderSettings& settings);
/// Returns settings_json with another sky.
[[nodiscard]] nlohmann::ordered_json settings_json(const RenderSettings& settings,
                                                   const SkyChoice& sky);

struct DescribedSettings {
  RenderSettings settings;  ///< `validated`; the sky is not made yet
  SkyChoice sky;
};
/// Reads the result of settings_json. The error's subject is "settings".
[[nodiscard]] Result<DescribedSettings> settings_from_json(const nlohmann::ordered_json& json);

}  // namespace asos
