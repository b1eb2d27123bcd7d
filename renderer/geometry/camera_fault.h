#pragma once

#include "renderer/geometry/camera.h"

#include <string>

namespace asos {

/// The first property that a View relies on and a camera lacks, in the words of saved pictures;
/// empty: none.
[[nodiscard]] std::string camera_fault(const Camera& camera);

}  // namespace asos
