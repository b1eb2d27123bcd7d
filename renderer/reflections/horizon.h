#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <utility>

namespace asos {

/// A surface's own plane in a square of directions. A direction leads away from the surface where
/// `height` + (u - 1/2) `right` + (v - 1/2) `down` is above 0, with u and v from 0 to 1.
struct Horizon {
  double height = 1.0;
  double right = 0.0;
  double down = 0.0;

  [[nodiscard]] double at(glm::dvec2 p) const {
    return height + (p.x - 0.5) * right + (p.y - 0.5) * down;
  }
  /// Returns the fraction of the square's area that is above the plane.
  [[nodiscard]] double share_above() const;
  /// Returns the line where the plane crosses the square, from border to border.
  [[nodiscard]] std::optional<std::pair<glm::vec2, glm::vec2>> line() const;
};

}  // namespace asos
