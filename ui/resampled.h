#pragma once

#include "renderer/film/film.h"

#include <glm/glm.hpp>

namespace asos::ui {

/// The same view in a picture of another size, as the camera would show it, whose vertical field of
/// view stays: scaled by the heights about the middle. Each pixel is the mean of what it covers;
/// what lies beyond the sides is black. Radiance only.
[[nodiscard]] Film resampled(const Film& film, glm::ivec2 size);

/// The part of such a picture that `film` shows.
[[nodiscard]] PixelRect resampled_area(const Film& film, glm::ivec2 size);

}  // namespace asos::ui
