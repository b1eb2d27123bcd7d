#pragma once

#include "renderer/settings/settings.h"

#include <string>

namespace asos::ui {

/// Names a picture by method and quality, in the words of the window: "ASOS, EPS 1/256"; with the
/// CPU seconds where samples are counted: "Sobol, 19 spp, 8.7 s".
[[nodiscard]] std::string snapshot_name(const RenderSettings& settings, double cpu_seconds);

}  // namespace asos::ui
