#pragma once

#include "renderer/geometry/camera.h"

#include <string>

namespace asos {

/// Returns the first property of a camera that View cannot use, with its name in saved pictures;
/// empty: none.
[[nodiscard]] std::string validate_camera(const Camera& camera);

}  // namespace asos
