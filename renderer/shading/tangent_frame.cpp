#include "renderer/shading/tangent_frame.h"

#include "renderer/shading/hit_triangle.h"
#include "renderer/shading/texture.h"

#include <cmath>

namespace asos {
namespace {

struct Edges {
  glm::vec3 e1, e2;
};

Edges edges_of(const World& world, const Hit& hit, const HitTriangle& t) {
  if (t.face) {
    const HitPlane plane = hit_plane(world, hit);
    return {glm::vec3(plane.edge1), glm::vec3(plane.edge2)};
  }
  const glm::vec3 p0 = world.positions[t.v.x];
  return {world.positions[t.v.y] - p0, world.positions[t.v.z] - p0};
}

/// Returns the tangent (w: handedness) of a triangle without authored tangents: the direction in
/// which the texture coordinate u grows. Zero where the coordinates do not span the triangle.
glm::vec4 tangent_from_texcoords(const World& world, const Hit& hit, const HitTriangle& t,
                                 const TextureUse& use, glm::vec3 normal) {
  if (use.texcoord < 0 || use.texcoord > 1) return {};
  const CornerTexcoords uv = corner_texcoords(world, use.texcoord, hit.triangle);
  const auto [e1, e2] = edges_of(world, hit, t);
  const glm::mat2 transform(use.uv_transform);
  const glm::vec2 d1 = transform * (uv.at_1 - uv.at_0);
  const glm::vec2 d2 = transform * (uv.at_2 - uv.at_0);
  const float det = d1.x * d2.y - d1.y * d2.x;
  if (det == 0.0f || !std::isfinite(det)) return {};
  const float sign = det < 0.0f ? -1.0f : 1.0f;
  const glm::vec3 along_u = sign * (e1 * d2.y - e2 * d1.y);
  const glm::vec3 along_v = sign * (e2 * d1.x - e1 * d2.x);
  // glTF's v runs down the image, and a normal map's green points up it, against v. The handedness
  // depends on the normal, not on the triangle's winding.
  const bool mirrored = glm::dot(glm::cross(normal, along_u), along_v) > 0.0f;
  return {along_u, mirrored ? -1.0f : 1.0f};
}

}  // namespace

TangentFrame tangent_frame(const World& world, const Hit& hit, const TextureUse& use,
                           glm::vec3 normal) {
  const HitTriangle t(world, hit);
  glm::vec4 tangent{0.0f};
  if (!world.tangents.empty() && !t.face) {
    const auto& all = world.tangents;
    tangent = t.mix(all[t.v.x], all[t.v.y], all[t.v.z]);
    tangent.w = world.tangents[t.v.x].w;
  }
  glm::vec3 along_u = glm::vec3(tangent) - glm::dot(glm::vec3(tangent), normal) * normal;
  if (!(glm::dot(along_u, along_u) > 0.0f)) {
    tangent = tangent_from_texcoords(world, hit, t, use, normal);
    along_u = glm::vec3(tangent) - glm::dot(glm::vec3(tangent), normal) * normal;
  }
  along_u = normalized_or(along_u, glm::vec3(0.0f));
  if (along_u == glm::vec3(0.0f)) return {};
  return {along_u, glm::cross(normal, along_u) * (tangent.w < 0.0f ? -1.0f : 1.0f)};
}

}  // namespace asos
