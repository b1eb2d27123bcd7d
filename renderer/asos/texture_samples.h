#pragma once

#include "renderer/pyray/square.h"
#include "renderer/scene/scene.h"
#include "renderer/world/render_features.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

// Leaves of textured surfaces divided into jittered samples (CGF'98 section 3.2).

namespace asos {

/// Returns whether shading reads any texture of the material.
[[nodiscard]] bool is_textured(const Material& material, const RenderFeatures& render_features);

/// Returns the number of parts along the side of a leaf that is `side` pixels wide. No part is
/// larger than those of a pixel divided into TR x TR parts.
[[nodiscard]] int texture_divisions(int texture_resolution, double side);

/// A part of a divided leaf.
struct TexturePart {
  Square square;
  glm::vec2 at{0.0f};  ///< place of its sample
};

/// The position of a leaf's frame in the picture: the frame's corner (0, 0) and its width, in
/// pixels.
struct LeafPlace {
  glm::ivec2 origin{0};
  int width = 1;
};

/// Returns the n x n parts of a leaf's square. With `jitter`, each has a random place that depends
/// on the pixel, the part's place in it and the seed, not on the frame. Without, the place is the
/// part's centre, and textures are averaged over the part (TextureFilter::footprint).
[[nodiscard]] std::vector<TexturePart> texture_parts(const Square& leaf, int n,
                                                     const LeafPlace& place, int seed, bool jitter);

}  // namespace asos
