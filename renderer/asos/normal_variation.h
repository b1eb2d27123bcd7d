#pragma once

#include <glm/glm.hpp>

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

 private:
  int side_ = 0;
  std::vector<float> errors_;
};

}  // namespace asos
