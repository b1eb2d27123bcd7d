#pragma once

#include "renderer/pyray/observer.h"

#include <glm/glm.hpp>

#include <array>
#include <span>
#include <vector>

namespace asos::ui {

/// A convex piece of a pyray's square, 0 to 1 across it, and the radiance that its sample has.
struct SeenPart {
  std::array<glm::vec2, 4> corners{};  ///< in order around it; two of them may be one
  glm::vec3 radiance{0.0f};

  [[nodiscard]] double area() const;
};

/// The parts of finished cells, each with its exact sides, as pieces that can be filled.
[[nodiscard]] std::vector<SeenPart> seen_parts(std::span<const TracedCell> cells);

}  // namespace asos::ui
