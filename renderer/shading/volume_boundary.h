#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/surface.h"
#include "renderer/shading/volume_path.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos {

/// Returns the indices of refraction of a volume for red, green and blue. Green has the material's
/// own; the others are half of nF - nC = (n - 1) / V less and more (KHR_materials_dispersion,
/// "Implementation"). At least 1; 1 for an infinite index, since no light enters.
[[nodiscard]] glm::vec3 indices_of(const Material& material);

/// A ray at the boundary of a volume, and the volumes on both sides. Outside of all is air.
struct VolumeBoundary {
  const World* world = nullptr;
  const Material* material = nullptr;
  std::uint32_t part = 0;  ///< index into World::parts
  bool entering = true;    ///< the ray hits its outer side
  NestedVolumes before;    ///< those that the ray comes from
  NestedVolumes behind;
  glm::vec3 ratio{1.0f};  ///< ratio of the indices before and behind it, by colour

  /// Returns the boundary, if the material bounds a volume. If the ray entered a volume and this
  /// boundary is outside of its box, that volume was open and counts as left. A volume that the ray
  /// leaves without having entered it either contained the ray's start or is another part with the
  /// same material.
  [[nodiscard]] static std::optional<VolumeBoundary> met(const World& world, const Hit& hit,
                                                         const Ray& ray, const VolumePath& passage);

  /// Returns whether the medium is the same on both sides, because another volume has priority.
  /// Then the boundary is invisible.
  [[nodiscard]] bool hidden() const { return before.medium() == behind.medium(); }

  /// Returns the ratio for the ray's colour, or that of green if it has all.
  [[nodiscard]] float ratio_of(const VolumePath& passage) const {
    return ratio[passage.colour < 0 ? 1 : passage.colour];
  }
  /// Returns the cosine for Schlick's Fresnel term, on the side of the lower index. Returns nothing
  /// at total reflection.
  [[nodiscard]] std::optional<float> fresnel_cosine(float n_dot_v, const VolumePath& passage) const;
  /// Sets the reflectance between the two media, if neither is air.
  void set_reflectance(SurfaceMaterial& seen) const;
  /// Computes the values of a material with this reflectance for a viewer. At total reflection
  /// everything is reflected.
  [[nodiscard]] ViewedMaterial viewed(const SurfaceMaterial& seen, float n_dot_v,
                                      const VolumePath& passage) const;

  /// Returns the path in the medium in front, after reflection, and after refraction.
  [[nodiscard]] VolumePath incident(const VolumePath& passage) const { return in(passage, before); }
  [[nodiscard]] VolumePath reflected(const VolumePath& passage) const {
    return leaving(passage, before, !entering);
  }
  [[nodiscard]] VolumePath refracted(const VolumePath& passage) const {
    VolumePath next = leaving(passage, behind, entering);
    ++next.refractions;
    return next;
  }
  /// Returns the path behind a hidden boundary.
  [[nodiscard]] VolumePath passed(const VolumePath& passage) const { return in(passage, behind); }

 private:
  [[nodiscard]] VolumePath in(const VolumePath& passage, const NestedVolumes& volumes) const;
  [[nodiscard]] VolumePath leaving(const VolumePath& passage, const NestedVolumes& volumes,
                                   bool inner_side) const;
};

}  // namespace asos
