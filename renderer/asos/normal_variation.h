#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// The variation of shading normals between the pixels of a block. Where triangles are large, the
/// corners of one triangle give the whole variation across it. Where many triangles fit into a
/// pixel, differences between pixels give how the variation changes.
class NormalVariation {
 public:
  /// `normals` and `surfaces` belong to the centres of `side` x `side` pixels, row by row. Normals
  /// are unit. Equal numbers in `surfaces` are one smooth surface.
  void find(int side, std::span<const glm::vec3> normals, std::span<const std::uint32_t> surfaces);

  /// Returns the angle, in radians, between the neighbours' normals and those extrapolated from
  /// pixel (x, y) with the turn `right` and `down` per pixel. It measures how well one triangle
  /// represents a surface with smaller triangles. Returns 0 outside of the block, and next to other
  /// surfaces.
  [[nodiscard]] float strays(int x, int y, glm::vec3 right, glm::vec3 down) const;

 private:
  [[nodiscard]] bool holds(int x, int y) const {
    return x >= 0 && y >= 0 && x < side_ && y < side_;
  }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y * side_ + x);
  }

  int side_ = 0;
  std::vector<glm::vec3> normals_;
  std::vector<std::uint32_t> surfaces_;
};

}  // namespace asos
