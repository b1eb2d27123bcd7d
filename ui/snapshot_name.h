#pragma once

#include "renderer/settings/settings.h"

#include <string>

namespace asos::ui {

/// Names a picture by method and quality: "ASOS, EPS 1/256". Methods with counted samples add the
/// CPU time: "Sobol, 19 spp, 8.7 s".
[[nodiscard]] std::string snapshot_name(const RenderSettings& settings, double cpu_seconds);

}  // namespace asos::ui
