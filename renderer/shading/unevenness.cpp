#include "renderer/shading/unevenness.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

// How far the unit shading normal turns along the patch's edges, squared and summed.
float turn2(const World& world, const Hit& hit, const Patch& patch) {
  const glm::uvec3 v = world.triangles[hit.triangle];
  const glm::vec3 n0 = world.normals[v.x], n1 = world.normals[v.y], n2 = world.normals[v.z];
  if (n0 == n1 && n1 == n2) return 0.0f;
  const Steps<glm::vec3> steps(footprint_on(world, hit.triangle, patch), n0, n1, n2);
  const glm::vec3 n = (1.0f - hit.b1 - hit.b2) * n0 + hit.b1 * n1 + hit.b2 * n2;
  const float length2 = glm::dot(n, n);
  if (!(length2 > 0.0f)) return 0.0f;
  const auto along = [&](glm::vec3 step) {
    const glm::vec3 across = step - n * (glm::dot(n, step) / length2);
    return glm::dot(across, across) / length2;
  };
  return along(steps.right) + along(steps.down);
}

// The patch's squared size over the squared distance of the nearest light that has a place.
float nearness2(const World& world, glm::vec3 position, const Patch& patch) {
  const float size2 = glm::dot(patch.right, patch.right) + glm::dot(patch.down, patch.down);
  float nearest = 0.0f;
  for (const Light& light : world.lights) {
    if (light.type == Light::Type::directional) continue;
    const glm::vec3 d = glm::vec3(light.position) - position;
    nearest = std::max(nearest, size2 / glm::dot(d, d));
  }
  return nearest;
}

}  // namespace

float midpoint_error(const World& world, const Hit& hit, glm::vec3 position, const Patch& patch) {
  const Material& material = world.material_of(hit.triangle);
  const glm::vec3 size = glm::abs(patch.right) + glm::abs(patch.down);
  if (material.unlit || !std::isfinite(size.x + size.y + size.z)) return 0.0f;
  const glm::vec3 c = glm::vec3(material.base_color);
  const float reflected = std::clamp(std::max({c.x, c.y, c.z}), 0.0f, 1.0f);
  const float error =
      reflected * (turn2(world, hit, patch) + 6.0f * nearness2(world, position, patch)) / 24.0f;
  return error < 1.0f ? error : 1.0f;
}

}  // namespace asos
