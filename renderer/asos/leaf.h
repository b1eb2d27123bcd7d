#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/pyray/caster.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

namespace asos {

/// A part of a root and the surface at its sample, from which the part's estimator is chosen. Valid
/// as long as its region's border.
struct Leaf {
  SampleId sample = no_sample;
  double weight = 1.0;  ///< fraction of the root's area
  LeafRegion region;    ///< in the frame
  glm::vec2 at{0.0f};   ///< place of its sample, in the frame
  Ray ray;
  Hit hit;
  const Material* material = nullptr;  ///< null: the background
  SurfacePoint point;                  ///< without a footprint
  /// Patch of the surface that a square with the leaf's area covers.
  Patch square;
  Patch around;           ///< patch of the square around the sample that contains the whole leaf
  float distance = 0.0f;  ///< from the viewer, in world units

  [[nodiscard]] static Leaf of(const EyeContext& eye, const EyeSamples& samples, SampleId sample,
                               double weight, const LeafRegion& region);

  [[nodiscard]] bool shows_surface() const { return material != nullptr; }
  [[nodiscard]] bool is_lit() const { return material && !material->unlit; }
  [[nodiscard]] glm::vec3 to_viewer() const { return -ray.direction; }
  /// Returns the largest radiance of the surface for an irradiance of pi, from base colour and
  /// sheen.
  [[nodiscard]] float albedo() const;
};

}  // namespace asos
