#pragma once

#include "renderer/lights/prepared_light.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/normal_spread.h"
#include "renderer/shading/surface.h"
#include "renderer/shading/viewed_point.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos {

/// The curvature of the patch that a point represents. It evaluates the patch at several points:
/// 2x2 Gauss-Legendre points in each of its parts. Their mean is exact for cubic functions over a
/// part; the centre is exact only for linear ones.
struct PatchCurvature {
  NormalSpread turn;             ///< of the shading normal along the edges
  glm::vec2 stretch_turn{0.0f};  ///< turn of the lobe's stretch about the normal, in radians
  bool rounded = false;          ///< the surface itself is curved as its normals are
  float negligible = 0.0f;       ///< radiance by which the centre may differ from the mean

  /// Returns the curvature of the patch of `view`, with `hit` at its centre.
  [[nodiscard]] static PatchCurvature at(const World& world, const Hit& hit,
                                         const ViewedPoint& view, const ViewedMaterial& material,
                                         float negligible);

  /// Largest squared width of a part, in squared highlight widths. Up to this width the points give
  /// a better mean than a widened lobe.
  static constexpr float most_bent = 3.0f;

  /// Number of parts along a patch's edges, so that no part exceeds most_bent.
  struct Parts {
    int right = 1, down = 1;
  };
  static constexpr int most_parts = 4;  ///< along an edge
  /// Returns the parts of a patch across which the lobe's half vector turns by `spread`; the
  /// highlight's length scale is `shown`, in radians. Returns none if there would be too many.
  [[nodiscard]] static std::optional<Parts> parts_for(const NormalSpread& spread, float shown);

  /// How well the centre represents the patch for a light.
  struct CentreEstimate {
    /// Relative error of the centre's radiance as the mean, from the second derivative of the
    /// highlight's lobe.
    float error = 0.0f;
    std::optional<Parts> parts;  ///< none: the patch is too wide for most_parts
  };
  [[nodiscard]] CentreEstimate of_middle(const ViewedPoint& view, const Lobe& lobe,
                                         const PreparedLight& light,
                                         const Highlight& highlight) const;

  /// A point of the patch.
  struct Point {
    SurfacePoint surface;
    glm::vec3 to_viewer;  ///< unit
    ViewedMaterial material;
  };
  /// Calls `look` with each of the points for the mean.
  template <typename Look>
  void for_each_point(const ViewedPoint& view, const ViewedMaterial& material, const Parts& parts,
                      const Look& look) const {
    constexpr float node = 0.28867513f;  // 1 / sqrt(12) of an edge from a part's centre
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
  /// Change from the centre, to second order.
  struct Step {
    glm::vec3 place;
    glm::vec3 normal;
  };
  [[nodiscard]] Step step(const ViewedPoint& view, float u, float v) const;
  [[nodiscard]] Point point(const ViewedPoint& view, const ViewedMaterial& material,
                            glm::vec2 uv) const;
};

}  // namespace asos
