#pragma once

#include "renderer/shading/brdf.h"
#include "renderer/shading/light_transport.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>

namespace asos {

/// A sampled direction from a point to the sky.
struct SkySample {
  glm::vec3 direction{0.0f};  ///< unit
  /// Weight of the radiance from there in the radiance towards the viewer.
  glm::vec3 weight{0.0f};
  glm::vec3 carried{0.0f};  ///< unoccluded contribution: radiance towards the viewer
  glm::vec3 matte{0.0f};    ///< the same of the diffuse part alone, without falloff and horizon
};

/// Samples the directions of a surface's whole reflection of the sky. The mean over places in the
/// unit square is the integral of radiance, BRDF and cosine over the hemisphere. Directions are
/// sampled by the cosine, by the lobe (visible normals: Heitz 2018), and for pictures by radiance.
/// They are weighted by the balance heuristic (Veach and Guibas 1995). A direction in the shading
/// normal's hemisphere that leads below the surface is mirrored above it, so that no light is lost.
/// Stores all that does not depend on the place, for repeated use.
class SkySampler {
 public:
  explicit SkySampler(const SkyQuery& point);

  /// Returns whether the surface reflects any of the sky.
  [[nodiscard]] bool reflects() const { return reflects_; }
  /// Returns the sample of a place; none: it contributes nothing.
  [[nodiscard]] std::optional<SkySample> at(glm::dvec2 place) const;

 private:
  [[nodiscard]] glm::vec3 world(glm::vec3 v) const {
    return v.x * right_ + v.y * up_ + v.z * normal_;
  }
  [[nodiscard]] glm::vec3 local(glm::vec3 v) const {
    return {glm::dot(v, right_), glm::dot(v, up_), glm::dot(v, normal_)};
  }
  [[nodiscard]] std::optional<glm::vec3> direction_of(glm::dvec2 place) const;
  struct Reflected {
    glm::vec3 brdf{0.0f};
    float density = 0.0f;  ///< density of directions by the cosine and the lobe
  };
  [[nodiscard]] Reflected reflected_from(glm::vec3 direction) const;
  void add(glm::vec3 direction, glm::vec3 brdf, float density, SkySample& sample) const;

  const Sky* sky_;
  ViewedMaterial material_;
  glm::vec3 factor_;
  glm::vec3 right_, up_, normal_;  ///< axes of the surface's frame
  glm::vec3 viewer_;               ///< direction to the viewer, in this frame
  glm::vec3 horizon_{0, 0, 1};     ///< normal of the surface itself, in this frame
  glm::vec2 alpha_;
  bool reflects_ = false;
  bool picture_ = false;
  bool sheen_ = false;
  /// Fractions of the directions by the cosine, the lobe, the picture.
  std::array<float, 3> share_{};
};

/// Returns the sampler's direction for one place.
[[nodiscard]] std::optional<SkySample> sample_sky(const SkyQuery& point, glm::dvec2 place);

/// Returns the ray from the surface in the sample's direction.
[[nodiscard]] Ray sky_ray(const SurfacePoint& point, const SkySample& sample);

/// Returns the mean of `carried` over all samples, including occluded ones, where a closed form
/// exists. It exists for constant skies (with the accuracy of lobe_norms) and for matte surfaces
/// under gradients.
[[nodiscard]] std::optional<glm::vec3> unoccluded_sky(const SkyQuery& point);
/// Returns the mean of `matte`.
[[nodiscard]] glm::vec3 open_sky_of_matte(const SkyQuery& point);
/// Returns the closed form of an open sky minus its value in one sample; none: the sample
/// contributes nothing. The mean is 0: added to samples, it removes the noise of an open sky
/// (control variate).
[[nodiscard]] glm::vec3 open_sky_less(const SkyQuery& point,
                                      const std::optional<SkySample>& sample);

}  // namespace asos
