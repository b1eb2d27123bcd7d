#pragma once

#include "renderer/lights/prepared_light.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/normal_spread.h"
#include "renderer/shading/surface.h"
#include "renderer/shading/viewed_point.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos {

/// How the patch that a point stands for is bent, to look at more of it than its middle: at Gauss
/// and Legendre's two points along each edge of each of its parts, whose mean is exact for what is
/// cubic across a part, as the middle is for what is linear.
struct PatchBend {
  NormalSpread turn;             ///< of the shading normal along the edges
  glm::vec2 stretch_turn{0.0f};  ///< of the lobe's stretch about the normal, in radians
  bool rounded = false;          ///< the surface itself bends as its normals do
  float negligible = 0.0f;       ///< radiance by which the middle may differ from the mean

  /// That of the patch of `view`, where `hit` is its middle.
  [[nodiscard]] static PatchBend at(const World& world, const Hit& hit, const ViewedPoint& view,
                                    const ViewedMaterial& material, float negligible);

  /// The patch's squared width, in those of a highlight, up to which so few points tell its mean
  /// better than a lobe that is widened.
  static constexpr float most_bent = 3.0f;

  /// Into how many parts along its edges a patch is divided so that none is wider than that.
  struct Parts {
    int right = 1, down = 1;
  };
  static constexpr int most_parts = 4;  ///< along an edge
  /// Those of a patch across which the lobe's half vector turns by `spread`, where what the lobe
  /// shows changes over `shown`, in radians; none: it takes more.
  [[nodiscard]] static std::optional<Parts> parts_for(const NormalSpread& spread, float shown);

  /// What the middle tells of a light.
  struct OfMiddle {
    /// About by which share of it the middle's radiance may differ from the mean: by the second
    /// derivative of the lobe that shows the highlight.
    float error = 0.0f;
    std::optional<Parts> parts;  ///< none: the patch is too wide for most_parts
  };
  [[nodiscard]] OfMiddle of_middle(const ViewedPoint& view, const ViewedMaterial& material,
                                   const PreparedLight& light, const Highlight& highlight) const;

  /// A point of the patch.
  struct Point {
    SurfacePoint surface;
    glm::vec3 to_viewer;  ///< unit
    ViewedMaterial material;
  };
  /// Calls `look` with each of those whose mean counts.
  template <typename Look>
  void for_each_point(const ViewedPoint& view, const ViewedMaterial& material, const Parts& parts,
                      const Look& look) const {
    constexpr float node = 0.28867513f;  // 1 / sqrt(12) of an edge from a part's middle
    const auto along = [](int i, int count) {
      return (static_cast<float>(i / 2) + 0.5f + (i % 2 == 0 ? -node : node)) /
                 static_cast<float>(count) -
             0.5f;
    };
    for (int j = 0; j < 2 * parts.down; ++j)
      for (int i = 0; i < 2 * parts.right; ++i)
        look(point(view, material, {along(i, parts.right), along(j, parts.down)}));
  }

 private:
  /// From the middle, to second order.
  struct Step {
    glm::vec3 place;
    glm::vec3 normal;
  };
  [[nodiscard]] Step step(const ViewedPoint& view, float u, float v) const;
  [[nodiscard]] Point point(const ViewedPoint& view, const ViewedMaterial& material,
                            glm::vec2 uv) const;
};

}  // namespace asos
