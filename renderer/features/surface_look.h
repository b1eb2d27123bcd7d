#pragma once

#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Returns the value of a material's texture at a point of a triangle, each channel 0 to 1 as
/// stored. It is not decoded, so differences are those on a display.
using TextureAt = glm::vec4 (*)(const World& world, const TextureUse& use, std::uint32_t triangle,
                                float b1, float b2);

/// A corner that two triangles share: its number, 0 to 2, in each.
struct SharedCorner {
  int first = 0;
  int second = 0;
};

/// Returns whether two materials look the same on one surface. Names are ignored, and textures are
/// compared by image, sampler and transform.
[[nodiscard]] bool same_look(const World& world, const Material& a, const Material& b);

/// Compares two neighbouring triangles where they meet. Without a `TextureAt`, every jump of
/// texture coordinates that a texture uses counts as a difference. The world must outlive it.
/// Thread-safe.
class SurfaceLook {
 public:
  SurfaceLook(const World& world, TextureAt texture_at);

  /// Returns whether materials or texture values differ across the edge with these two ends.
  [[nodiscard]] bool seam(std::uint32_t x, std::uint32_t y,
                          std::span<const SharedCorner> ends) const;

  /// Returns whether shading normals (up to their sign) or vertex colours differ across that edge.
  [[nodiscard]] bool crease(std::uint32_t x, std::uint32_t y,
                            std::span<const SharedCorner> ends) const;

  /// Returns whether two triangles with the same three corners look alike everywhere.
  [[nodiscard]] bool same(std::uint32_t x, std::uint32_t y,
                          std::span<const SharedCorner> corners) const;

 private:
  [[nodiscard]] bool texcoords_differ(std::uint32_t x, std::uint32_t y,
                                      std::span<const SharedCorner> corners) const;
  [[nodiscard]] bool textures_differ(std::uint32_t x, std::uint32_t y,
                                     std::span<const SharedCorner> ends) const;
  [[nodiscard]] bool texture_differs(const TextureUse& use, std::uint32_t x, std::uint32_t y,
                                     std::span<const SharedCorner> ends) const;
  [[nodiscard]] float texels_along(const TextureUse& use, std::uint32_t a, std::uint32_t b) const;

  const World& world_;
  TextureAt texture_at_;
  std::vector<std::uint8_t> uses_texcoord_;  // bits: the sets that a material's textures use
};

}  // namespace asos
