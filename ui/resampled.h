#pragma once

#include "renderer/film/film.h"

#include <glm/glm.hpp>

namespace asos::ui {

/// Resamples a picture to another size for the same vertical field of view: it is scaled by the
/// ratio of heights about the centre. Each pixel is a box average; pixels beyond the left and right
/// borders are black. Only radiance, coverage and unlit parts.
[[nodiscard]] Film resampled(const Film& film, glm::ivec2 size);

/// The area of the resampled picture that `film` covers.
[[nodiscard]] PixelRect resampled_area(const Film& film, glm::ivec2 size);

}  // namespace asos::ui
