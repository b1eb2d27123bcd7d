#include "renderer/shading/anisotropy.h"

#include "renderer/shading/hit_triangle.h"
#include "renderer/shading/tangent_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asos {
SurfaceAnisotropy anisotropy_of(const Anisotropy& material, glm::vec3 texel) {
  SurfaceAnisotropy at;
  at.strength = material.strength * texel.b;
  // With 8 bits, no texel value is exactly 0.
  constexpr float nothing = 1.5f / 255.0f;
  glm::vec2 d = 2.0f * glm::vec2(texel) - 1.0f;
  if (std::abs(d.x) < nothing) d.x = 0.0f;
  if (std::abs(d.y) < nothing) d.y = 0.0f;
  const float length = glm::length(d);
  d = length > 0.0f ? d / length : glm::vec2(1.0f, 0.0f);
  const float c = std::cos(material.rotation_rad), s = std::sin(material.rotation_rad);
  at.direction = {c * d.x - s * d.y, s * d.x + c * d.y};
  return at;
}

LobeStretch lobe_stretch(const World& world, const Hit& hit, const SurfaceAnisotropy& anisotropy,
                         float roughness, glm::vec3 normal, glm::vec3 to_viewer) {
  const Material& material = world.material_of(hit.triangle);
  // Tangents belong to the front, even where the back is visible.
  const std::array<glm::vec3, 3> corners = corner_normals(world, hit);
  const glm::vec3 front = HitTriangle(world, hit).mix(corners[0], corners[1], corners[2]);
  const float side = glm::dot(front, normal) < 0.0f ? -1.0f : 1.0f;
  const TextureUse& use = material.normal_texture.used()        ? material.normal_texture
                          : material.coat.normal_texture.used() ? material.coat.normal_texture
                                                                : material.anisotropy.texture;
  const TangentFrame frame = tangent_frame(world, hit, use, side * normal);
  if (!frame.known()) return {};
  const glm::vec3 along =
      anisotropy.direction.x * frame.along_u + anisotropy.direction.y * frame.along_v;
  const float across = alpha_of(roughness);
  const float wide = glm::mix(across, 1.0f, anisotropy.strength * anisotropy.strength);
  const float stretched = wide * wide - across * across;
  if (!(stretched > 0.0f)) return {};
  LobeStretch stretch;
  stretch.along = std::sqrt(stretched) * along;
  const glm::vec3 seen = to_viewer - glm::dot(to_viewer, normal) * normal;
  const float length2 = glm::dot(seen, seen);
  const float towards = glm::dot(seen, along);
  if (length2 > 0.0f) stretch.seen_along2 = std::min(1.0f, towards * towards / length2);
  return stretch;
}

glm::vec2 tangent_turn(const World& world, const Hit& hit, const Patch& patch, glm::vec3 normal) {
  const HitTriangle t(world, hit);
  if (world.tangents.empty() || t.face) return glm::vec2(0.0f);
  const glm::vec3 t0(world.tangents[t.v.x]), t1(world.tangents[t.v.y]), t2(world.tangents[t.v.z]);
  const glm::vec3 mixed = t.mix(t0, t1, t2);
  const glm::vec3 tangent = mixed - glm::dot(mixed, normal) * normal;
  const float length2 = glm::dot(tangent, tangent);
  if (!(length2 > 0.0f)) return glm::vec2(0.0f);
  const Steps<glm::vec3> steps(footprint_on(world, hit, patch), t0, t1, t2);
  const glm::vec3 across = glm::cross(normal, tangent) / length2;
  return {glm::dot(across, steps.right), glm::dot(across, steps.down)};
}

float widest_roughness(const SurfaceMaterial& material) {
  const float strength = material.anisotropy.strength;
  if (!(strength > 0.0f)) return material.roughness;
  const float across = material.roughness * material.roughness;
  return std::sqrt(glm::mix(across, 1.0f, strength * strength));
}

}  // namespace asos
