#pragma once

#include "renderer/film/film.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace asos {

class Previewer;

/// Pixels that were split, deepest first, of these the nearest to the middle first, and rather such
/// as the bounds of objects split; from all over the picture: of each of its parts the first, and
/// that with most rays.
[[nodiscard]] std::vector<glm::ivec2> split_pixels(const Film& film);
/// The first of them; none: nothing was split.
[[nodiscard]] std::optional<glm::ivec2> most_split_pixel(const Film& film);

/// A pixel of the finished picture on which one sees what splitting is: of those that were split
/// deepest, that whose cells are split most often and differ most, as traces of them tell. Takes
/// no more than some tens of milliseconds. None: nothing was split.
[[nodiscard]] std::optional<glm::ivec2> pixel_that_splits(const Previewer& previewer);

}  // namespace asos
