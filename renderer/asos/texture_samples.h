#pragma once

#include "renderer/pyray/square.h"
#include "renderer/scene/scene.h"
#include "renderer/world/needs.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

// Leaves of textured surfaces divided into jittered samples (CGF'98 section 3.2).

namespace asos {

/// Whether shading looks anything up in a texture of the material.
[[nodiscard]] bool is_textured(const Material& material, const SceneNeeds& needs);

/// Into how many parts along its side a leaf is divided that is `side` pixels wide: so many that
/// none is larger than the TR x TR parts of a pixel.
[[nodiscard]] int texture_divisions(int texture_resolution, double side);

/// A part of a divided leaf.
struct TexturePart {
  Square square;
  glm::vec2 at{0.0f};  ///< a place in it
};

/// Where a leaf lies in the picture: its frame's (0, 0) and size in pixels.
struct LeafPlace {
  glm::ivec2 origin{0};
  int width = 1;
};

/// The n x n parts of a leaf's square, each with a random place, which is a function of the pixel,
/// the part's place in it and the seed, not of the frame; or without `jitter` with its middle,
/// around which textures are averaged over a part (TextureFilter::footprint).
[[nodiscard]] std::vector<TexturePart> texture_parts(const Square& leaf, int n,
                                                     const LeafPlace& place, int seed, bool jitter);

}  // namespace asos
