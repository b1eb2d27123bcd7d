#pragma once

#include "renderer/shading/brdf.h"
#include "renderer/shading/light_transport.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>

namespace asos {

/// Which of a sample's lobes tells the directions to the sky.
inline constexpr int lobe_of_sky = 0x1001;

/// A direction in which a point looks at the sky.
struct SkySample {
  glm::vec3 direction{0.0f};  ///< unit
  glm::vec3 weight{0.0f};     ///< of the radiance from there in that towards the viewer
  glm::vec3 carried{0.0f};    ///< radiance towards the viewer, if nothing lies in the direction
  glm::vec3 matte{0.0f};      ///< the same of the diffuse part alone, as if it did not fall off
};

/// Directions of a surface's whole reflection of the sky: the mean over places in the unit square
/// is the integral of radiance, BRDF and cosine over the hemisphere. Directions come by the cosine,
/// by the lobe (visible normals: Heitz 2018) and of pictures by their radiance, weighed by the
/// balance heuristic (Veach and Guibas 1995). A direction of the shading normal's hemisphere that
/// leads below the surface itself is reflected back above it, so that no light is lost. Keeps what
/// does not depend on the place, for repeated use.
class SkySampler {
 public:
  explicit SkySampler(const SkyLitPoint& point);

  /// Whether the surface reflects anything of the sky.
  [[nodiscard]] bool reflects() const { return reflects_; }
  /// That of a place. None: it carries nothing.
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
    float density = 0.0f;  ///< of the cosine's and the lobe's directions
  };
  [[nodiscard]] Reflected reflected_from(glm::vec3 direction) const;
  void add(glm::vec3 direction, glm::vec3 brdf, float density, SkySample& sample) const;

  const Sky* sky_;
  ViewedMaterial material_;
  glm::vec3 factor_;
  glm::vec3 right_, up_, normal_;  ///< of its own frame
  glm::vec3 viewer_;               ///< in it
  glm::vec3 horizon_{0, 0, 1};     ///< normal of the surface itself, in it
  glm::vec2 alpha_;
  bool reflects_ = false;
  bool picture_ = false;
  bool sheen_ = false;
  std::array<float, 3> share_{};  ///< of directions by the cosine, the lobe, the picture
};

/// The sampler's direction of one place.
[[nodiscard]] std::optional<SkySample> sample_sky(const SkyLitPoint& point, glm::dvec2 place);

/// From the surface in the sample's direction.
[[nodiscard]] Ray sky_ray(const SurfacePoint& point, const SkySample& sample);

/// The mean of `carried` of all samples, hidden ones too, where a closed form is known: of skies
/// that are the same all over (the lobe's part as exact as lobe_norms), and of what is
/// not shiny under gradients.
[[nodiscard]] std::optional<glm::vec3> open_sky(const SkyLitPoint& point);
/// The mean of `matte`, where a closed form is known.
[[nodiscard]] std::optional<glm::vec3> open_sky_of_matte(const SkyLitPoint& point);

}  // namespace asos
