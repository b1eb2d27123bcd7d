#pragma once

#include "renderer/pyray/observer.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace asos::ui {

/// A convex piece of a pyray's unit square, and the radiance of its sample.
struct SeenPart {
  std::array<glm::vec2, 4> corners{};  ///< in order around the piece; two of them may coincide
  glm::vec3 radiance{0.0f};
  std::uint32_t triangle = TracedSample::no_triangle;  ///< at its sample's hit

  [[nodiscard]] double area() const;
};

/// Converts the parts of finished cells, which have exact borders, to convex pieces for drawing.
[[nodiscard]] std::vector<SeenPart> seen_parts(std::span<const TracedCell> cells);

}  // namespace asos::ui
