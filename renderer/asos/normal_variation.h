#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// How much the shading normals of a block of pixels vary, from pixel to pixel. One triangle's
/// corners tell how far the normal turns across it, which is all there is where triangles are
/// large; where many fit into a pixel, the neighbours tell how that turn changes.
class NormalVariation {
 public:
  /// `normals`, `surfaces`: of the middles of `side` x `side` pixels, in rows; normals are unit,
  /// surfaces by equal numbers for one smooth piece; `background` for what is none.
  void find(int side, std::span<const glm::vec3> normals, std::span<const std::uint32_t> surfaces,
            std::uint32_t background);

  /// The midpoint rule's error, over pixel (x, y) of the block, of the normal's cosine to anything:
  /// a twenty-fourth of its second differences along both axes. 0 outside of the block, and where
  /// neighbours show other surfaces.
  [[nodiscard]] float error(int x, int y) const;

  /// How far, in radians, the neighbours' normals are from where a turn of pixel (x, y)'s by
  /// `right` and `down` from one pixel to the next would lead: what one triangle says of a surface
  /// whose triangles are smaller than that. 0 outside of the block, and beside other surfaces.
  [[nodiscard]] float strays(int x, int y, glm::vec3 right, glm::vec3 down) const;

 private:
  [[nodiscard]] bool holds(int x, int y) const {
    return x >= 0 && y >= 0 && x < side_ && y < side_;
  }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y * side_ + x);
  }

  int side_ = 0;
  std::vector<float> errors_;
  std::vector<glm::vec3> normals_;
  std::vector<std::uint32_t> surfaces_;
};

}  // namespace asos
