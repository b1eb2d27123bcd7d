#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace asos {

/// Edges joined end to end, by the vertices where they begin and end.
struct EdgeChain {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  float deviation = 0.0f;  ///< the farthest that they stray from the line between
};

/// The one open chain that the parts form, if each is a chain and they form just one.
[[nodiscard]] std::optional<EdgeChain> join(std::span<const glm::vec3> positions,
                                            std::span<const std::optional<EdgeChain>> parts);

}  // namespace asos
