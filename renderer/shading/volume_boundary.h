#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/shading/volume_path.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos {

/// The indices of refraction of a volume for red, green and blue: the material's own for green, and
/// half of nF - nC = (n - 1) / V less and more (KHR_materials_dispersion, "Implementation"). At
/// least 1; of an infinite index, which lets nothing in, 1.
[[nodiscard]] glm::vec3 indices_of(const Material& material);

/// A ray at the boundary of a volume. Outside is air: the volume's own index is all that counts.
struct VolumeBoundary {
  const Material* material = nullptr;
  std::uint32_t part = 0;  ///< index into World::parts
  bool entering = true;    ///< the ray meets its outer side
  glm::vec3 ratio{1.0f};   ///< of the indices before and behind it, by colour

  /// Where the material bounds a volume.
  [[nodiscard]] static std::optional<VolumeBoundary> met(const World& world, const Hit& hit,
                                                         glm::vec3 direction);

  /// The ratio for what a ray brings, in short for green.
  [[nodiscard]] float ratio_of(const VolumePath& passage) const {
    return ratio[passage.colour < 0 ? 1 : passage.colour];
  }
  /// The cosine by which Schlick's Fresnel term goes: on the side of the lower index. Nothing where
  /// all is reflected.
  [[nodiscard]] std::optional<float> fresnel_cosine(float n_dot_v, const VolumePath& passage) const;

  /// Of what the ray becomes that is reflected, and of what is refracted.
  [[nodiscard]] VolumePath reflected(const VolumePath& passage) const {
    return passage.at(part, material->volume, !entering);
  }
  [[nodiscard]] VolumePath refracted(const VolumePath& passage) const {
    VolumePath next = passage.at(part, material->volume, entering);
    ++next.refractions;
    return next;
  }
};

}  // namespace asos
