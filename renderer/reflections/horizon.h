#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <utility>

namespace asos {

/// A surface's own plane in a square of directions: which of them lead away from the surface.
/// `height` + (u - 1/2) `right` + (v - 1/2) `down` is above 0 where one does, u and v from 0 to 1.
struct Horizon {
  double height = 1.0;
  double right = 0.0;
  double down = 0.0;

  [[nodiscard]] double at(glm::dvec2 p) const {
    return height + (p.x - 0.5) * right + (p.y - 0.5) * down;
  }
  /// The share of the square's area that is above.
  [[nodiscard]] double share_above() const;
  /// Where it crosses the square, from border to border.
  [[nodiscard]] std::optional<std::pair<glm::vec2, glm::vec2>> line() const;
};

}  // namespace asos
