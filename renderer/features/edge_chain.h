#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace asos {

/// A chain of connected edges, by the vertices where it begins and ends.
struct EdgeChain {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  float deviation = 0.0f;  ///< largest distance from the line between the ends
};

/// Joins parts to one open chain, if each part is a chain and they form just one.
[[nodiscard]] std::optional<EdgeChain> join(std::span<const glm::vec3> positions,
                                            std::span<const std::optional<EdgeChain>> parts);

}  // namespace asos
