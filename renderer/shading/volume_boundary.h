#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/shading/surface.h"
#include "renderer/shading/volume_path.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos {

/// The indices of refraction of a volume for red, green and blue: the material's own for green, and
/// half of nF - nC = (n - 1) / V less and more (KHR_materials_dispersion, "Implementation"). At
/// least 1; of an infinite index, which lets nothing in, 1.
[[nodiscard]] glm::vec3 indices_of(const Material& material);

/// A ray at the boundary of a volume, and the volumes on both of its sides. What is in none is air.
struct VolumeBoundary {
  const World* world = nullptr;
  const Material* material = nullptr;
  std::uint32_t part = 0;  ///< index into World::parts
  bool entering = true;    ///< the ray meets its outer side
  NestedVolumes before;    ///< that the ray comes through
  NestedVolumes behind;
  glm::vec3 ratio{1.0f};  ///< of the indices before and behind it, by colour

  /// Where the material bounds a volume. A volume that was entered, and whose box the boundary is
  /// not in, was open and is left; one that is left and was not entered held the ray's start, or is
  /// another part of the same material's.
  [[nodiscard]] static std::optional<VolumeBoundary> met(const World& world, const Hit& hit,
                                                         const Ray& ray, const VolumePath& passage);

  /// Whether the medium is the same on both sides: another volume's, in which this one has no say.
  /// Nothing is seen of the boundary then.
  [[nodiscard]] bool hidden() const { return before.medium() == behind.medium(); }

  /// The ratio for what a ray brings, in short for green.
  [[nodiscard]] float ratio_of(const VolumePath& passage) const {
    return ratio[passage.colour < 0 ? 1 : passage.colour];
  }
  /// The cosine by which Schlick's Fresnel term goes: on the side of the lower index. Nothing where
  /// all is reflected.
  [[nodiscard]] std::optional<float> fresnel_cosine(float n_dot_v, const VolumePath& passage) const;
  /// What the surface reflects between the two media, where one of them is not air.
  void set_reflectance(SurfaceMaterial& seen) const;

  /// What the ray comes through, of what becomes of it that is reflected, and that is refracted.
  [[nodiscard]] VolumePath incident(const VolumePath& passage) const { return in(passage, before); }
  [[nodiscard]] VolumePath reflected(const VolumePath& passage) const {
    return leaving(passage, before, !entering);
  }
  [[nodiscard]] VolumePath refracted(const VolumePath& passage) const {
    VolumePath next = leaving(passage, behind, entering);
    ++next.refractions;
    return next;
  }
  /// Of what goes on through one that is hidden.
  [[nodiscard]] VolumePath passed(const VolumePath& passage) const { return in(passage, behind); }

 private:
  [[nodiscard]] VolumePath in(const VolumePath& passage, const NestedVolumes& volumes) const;
  [[nodiscard]] VolumePath leaving(const VolumePath& passage, const NestedVolumes& volumes,
                                   bool inner_side) const;
};

}  // namespace asos
