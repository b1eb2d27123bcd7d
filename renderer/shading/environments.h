#pragma once

#include "renderer/shading/azimuth_variation.h"
#include "renderer/shading/gradient.h"
#include "renderer/shading/sky_choice.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>

namespace asos {

/// An environment: its name, hint and colours as linear radiance, unless it has a picture
/// (environment_picture.h). Its lights are in environment_lights.h.
struct EnvironmentRow {
  const char* name;
  Environment value;
  const char* hint;
  Gradient::Colours colours{};
  AzimuthVariation::Amounts sides{};  ///< added to the colours
};

inline constexpr std::array environments{
    EnvironmentRow{"softboxes", Environment::softboxes,
                   "A bright studio with soft boxes and dark panels."},
    EnvironmentRow{"windows", Environment::windows,
                   "A room with windows; soft window light for a scene without lights."},
    EnvironmentRow{"studio",
                   Environment::studio,
                   "A room over a darker floor, darkest behind the scene.",
                   {{0.85f, 0.85f, 0.85f},
                    {0.315f, 0.315f, 0.315f},
                    {0.245f, 0.245f, 0.245f},
                    {0.155f, 0.155f, 0.155f}},
                   // The usual view looks at the darkest side, so that reflections have more
                   // contrast.
                   {0.05, 15.0, -0.04, 5.0}},
    EnvironmentRow{
        "daylight",
        Environment::daylight,
        "A blue sky over grey ground; a high sun for a scene without lights.",
        {{0.2f, 0.4f, 0.85f}, {0.7f, 0.8f, 0.95f}, {0.7f, 0.8f, 0.95f}, {0.28f, 0.26f, 0.23f}}},
    EnvironmentRow{
        "dusk",
        Environment::dusk,
        "A dark sky over a red horizon; a low sun for a scene without lights.",
        {{0.08f, 0.1f, 0.25f}, {0.75f, 0.4f, 0.22f}, {0.75f, 0.4f, 0.22f}, {0.06f, 0.05f, 0.05f}}},
    EnvironmentRow{
        "white",
        Environment::white,
        "White from everywhere, which is the only light of a scene without its own.",
        {{1.0f, 1.0f, 1.0f}, {1.0f, 1.0f, 1.0f}, {1.0f, 1.0f, 1.0f}, {1.0f, 1.0f, 1.0f}}},
    EnvironmentRow{
        "grey",
        Environment::grey,
        "Half as bright as white, likewise.",
        {{0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f}}},
};

[[nodiscard]] constexpr const EnvironmentRow& row_of(Environment environment) {
  return *std::find_if(environments.begin(), environments.end(),
                       [&](const EnvironmentRow& row) { return row.value == environment; });
}

}  // namespace asos
