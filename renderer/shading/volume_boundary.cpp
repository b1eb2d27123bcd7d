#include "renderer/shading/volume_boundary.h"

#include "renderer/rays/back_face.h"

#include <cmath>

namespace asos {

glm::vec3 indices_of(const Material& material) {
  const float n = material.ior;
  if (!(n >= 1.0f)) return glm::vec3(1.0f);
  // The dispersion is 20 / V.
  const float half = (n - 1.0f) * 0.025f * material.volume.dispersion;
  return glm::max(glm::vec3(n - half, n, n + half), 1.0f);
}

std::optional<VolumeBoundary> VolumeBoundary::met(const World& world, const Hit& hit,
                                                  glm::vec3 direction) {
  const Material& material = world.material_of(hit.triangle);
  if (!bounds_volume(material)) return std::nullopt;
  VolumeBoundary met;
  met.material = &material;
  met.part = world.triangle_part[hit.triangle];
  met.entering = !meets_back(world, hit, direction);
  const glm::vec3 n = indices_of(material);
  met.ratio = met.entering ? 1.0f / n : n;
  return met;
}

std::optional<float> VolumeBoundary::fresnel_cosine(float n_dot_v,
                                                    const VolumePath& passage) const {
  if (entering || passage.straight) return n_dot_v;
  const float n = ratio_of(passage);
  const float squared = 1.0f - n * n * (1.0f - n_dot_v * n_dot_v);
  return squared > 0.0f ? std::optional(std::sqrt(squared)) : std::nullopt;
}

}  // namespace asos
