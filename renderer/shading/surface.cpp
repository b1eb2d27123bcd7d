#include "renderer/shading/surface.h"

#include "renderer/shading/brdf.h"
#include "renderer/shading/hit_triangle.h"
#include "renderer/shading/smooth_surface.h"
#include "renderer/shading/tangent_frame.h"
#include "renderer/shading/texture.h"
#include "renderer/shading/texture_filter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {
namespace {

/// Bound of the relative error of n float operations in a row (Higham's gamma).
constexpr float gamma_bound(int n) {
  constexpr float half_ulp = 0.5f * std::numeric_limits<float>::epsilon();
  return static_cast<float>(n) * half_ulp / (1.0f - static_cast<float>(n) * half_ulp);
}

using Triangle = HitTriangle;

struct MappedNormal {
  glm::vec3 normal;
  float variance = 0.0f;
};

MeanNormal mean_of_map(const World& world, const Hit& hit, const TextureUse& use,
                       const Footprint& footprint, const MipChains* mips) {
  return mips ? filtered_normal(world, *mips, use, {hit.triangle, hit.b1, hit.b2, footprint})
              : MeanNormal{
                    sample_texture(world, use, hit.triangle, hit.b1, hit.b2, Encoding::linear)};
}

MappedNormal mapped_normal(const World& world, const Hit& hit, const TextureUse& use,
                           glm::vec3 normal, const MeanNormal& mean) {
  const TangentFrame frame = tangent_frame(world, hit, use, normal);
  if (!frame.known()) return {normal};
  glm::vec3 local = 2.0f * mean.texel - 1.0f;
  local.x *= use.scale;
  local.y *= use.scale;
  return {
      normalized_or(local.x * frame.along_u + local.y * frame.along_v + local.z * normal, normal),
      std::min(1.0f, mean.variance * use.scale * use.scale)};
}

/// Returns the turn of the interpolated normal along the footprint's edges. `length` is the length
/// of the interpolated vector before it became the unit `normal`.
NormalSpread interpolated_spread(const std::array<glm::vec3, 3>& normals,
                                 const Footprint& footprint, glm::vec3 normal, float length) {
  const auto& [n0, n1, n2] = normals;
  const Steps<glm::vec3> steps(footprint, n0, n1, n2);
  const auto turn = [&](glm::vec3 d) { return (d - glm::dot(d, normal) * normal) / length; };
  return {turn(steps.right), turn(steps.down)};
}

/// Returns whether a footprint on the triangle has a visible effect: where there are textures, or
/// highlights on curved surfaces. Elsewhere the footprint is not computed, since it takes half as
/// long as shading.
bool shows_footprint(const World& world, const RenderFeatures& render_features,
                     std::uint32_t triangle, const Triangle& t) {
  const Material& m = world.material_of(triangle);
  const auto uses = texture_uses(m);
  if (render_features.textures &&
      std::any_of(uses.begin(), uses.end(), [](const TextureUse* use) { return use->used(); }))
    return true;
  const bool broad = m.roughness > least_broad_roughness && !(m.coat.factor > 0.0f);
  if (m.unlit || broad || !render_features.lights()) return false;
  if (t.face) return world.face(triangle).kind != ShapeFace::Kind::disk;
  if (world.normals.empty()) return false;
  return world.normals[t.v.x] != world.normals[t.v.y] ||
         world.normals[t.v.x] != world.normals[t.v.z];
}

/// Computes the smooth surface above the triangle, if any. Must be called before a map turns the
/// shading normal.
void find_smooth_surface(const World& world, const Triangle& t,
                         const std::array<glm::vec3, 3>& normals, float side, SurfacePoint& point) {
  const SmoothTriangle smooth{
      {world.positions[t.v.x], world.positions[t.v.y], world.positions[t.v.z]}, normals};
  point.lift =
      height_of_smooth(smooth, {t.b0, t.b1, t.b2}, point.geometric_normal, side, point.extent);
  if (point.lift != glm::vec3(0.0f)) point.smooth_normal = point.shading_normal;
}

/// Computes the shading normal, on the side of the geometric normal for any winding, and its
/// spread.
void shade_normal(const World& world, const RenderFeatures& render_features, const Hit& hit,
                  const Triangle& t, const TextureUse& map, const MipChains* mips,
                  SurfacePoint& point) {
  point.shading_normal = point.geometric_normal;
  if (world.normals.empty() && !t.face) return;
  const std::array<glm::vec3, 3> normals = corner_normals(world, hit);
  const glm::vec3 mixed = t.mix(normals[0], normals[1], normals[2]);
  const glm::vec3 smooth = normalized_or(mixed, point.geometric_normal);
  const float side = glm::dot(smooth, point.geometric_normal) < 0.0f ? -1.0f : 1.0f;
  point.shading_normal = side * smooth;
  const float length = glm::length(mixed);
  if (!t.face) find_smooth_surface(world, t, normals, side, point);
  if (!point.footprint.point() && length > 0.0f)
    point.spread = interpolated_spread(normals, point.footprint, smooth, length);
  if (render_features.normal_maps && map.used()) map_normal(world, hit, map, mips, side, point);
}

/// Computes position and geometric normal on a triangle.
void place_on_triangle(const World& world, const Triangle& t, SurfacePoint& point) {
  const glm::vec3 p0 = world.positions[t.v.x];
  const glm::vec3 p1 = world.positions[t.v.y];
  const glm::vec3 p2 = world.positions[t.v.z];

  // The position is computed from the corners, so that its error is bounded by their size alone,
  // not by the ray's length.
  point.position = t.b0 * p0 + t.b1 * p1 + t.b2 * p2;
  point.error = gamma_bound(7) * (glm::abs(t.b0 * p0) + glm::abs(t.b1 * p1) + glm::abs(t.b2 * p2));
  const glm::vec3 size = glm::max(p0, glm::max(p1, p2)) - glm::min(p0, glm::min(p1, p2));
  point.extent = std::max({size.x, size.y, size.z});

  // The geometric normal needs double precision: the cross product of a sliver cancels badly, and
  // shadows depend on the normal.
  const glm::dvec3 cross =
      glm::cross(glm::dvec3(p1) - glm::dvec3(p0), glm::dvec3(p2) - glm::dvec3(p0));
  const double length = glm::length(cross);
  if (length > 0.0) point.geometric_normal = glm::vec3(cross / length);
  point.to_edge =
      std::min({t.b0, t.b1, t.b2}) * static_cast<float>(length) / (longest_side * point.extent);
}

/// Sets the geometric normal of a lit line's ribbon to the line's normal. The ribbon faces the
/// viewer, but light arrives from where the normals point. Normals are taken on the viewer's side,
/// as for double-sided surfaces.
void face_along_normals(const World& world, const Hit& hit, const Triangle& t, glm::vec3 to_viewer,
                        SurfacePoint& point) {
  const std::array<glm::vec3, 3> normals = corner_normals(world, hit);
  const glm::vec3 normal =
      normalized_or(t.mix(normals[0], normals[1], normals[2]), point.geometric_normal);
  point.geometric_normal = glm::dot(normal, to_viewer) < 0.0f ? -normal : normal;
}

/// Computes position and normal on a face of an analytic shape. Only the final rounding to single
/// precision moves the point off the shape, since rays are tested in double precision.
void place_on_face(const World& world, const Hit& hit, SurfacePoint& point) {
  const ShapeFace& face = world.face(hit.triangle);
  const FacePoint at = face_point(face, hit.b1, hit.b2);
  point.position = glm::vec3(at.position);
  point.geometric_normal = glm::vec3(at.normal);
  constexpr double rounding_in_double = 1e-12;
  point.error = gamma_bound(2) * glm::abs(point.position) +
                static_cast<float>(rounding_in_double * face.size);
}

}  // namespace

SurfacePoint surface_point(const World& world, const RenderFeatures& render_features,
                           const Hit& hit, glm::vec3 to_viewer, const SampleExtent& extent) {
  const Triangle t(world, hit);
  SurfacePoint point;
  point.triangle = hit.triangle;
  if (t.face) {
    place_on_face(world, hit, point);
  } else {
    place_on_triangle(world, t, point);
  }
  if (glm::dot(point.geometric_normal, to_viewer) < 0.0f) {
    point.geometric_normal = -point.geometric_normal;
  }

  if (!extent.point() && shows_footprint(world, render_features, hit.triangle, t)) {
    point.footprint = shaped(footprint_on(world, hit,
                                          patch_on_plane(*extent.spacing, -to_viewer, hit.t,
                                                         point.geometric_normal, extent.side)),
                             extent.shape);
    point.footprint.side = extent.side;
    point.footprint.colours = extent.colours;
  }
  const Material& material = world.material_of(hit.triangle);
  if (material.stroke && !material.unlit) face_along_normals(world, hit, t, to_viewer, point);
  shade_normal(world, render_features, hit, t, material.normal_texture,
               extent.point() ? nullptr : extent.mips, point);
  return point;
}

void map_normal(const World& world, const Hit& hit, const TextureUse& map, const MipChains* mips,
                float side, SurfacePoint& point) {
  map_normal(world, hit, map, mean_of_map(world, hit, map, point.footprint, mips), side, point);
}

void map_normal(const World& world, const Hit& hit, const TextureUse& map, const MeanNormal& mean,
                float side, SurfacePoint& point) {
  const MappedNormal mapped = mapped_normal(world, hit, map, side * point.shading_normal, mean);
  point.spread.variance = mapped.variance;
  // A mapped normal that points below the surface is ignored.
  if (glm::dot(side * mapped.normal, point.geometric_normal) > 0.0f)
    point.shading_normal = side * mapped.normal;
}

SurfacePoint coat_point(const World& world, const RenderFeatures& render_features, const Hit& hit,
                        const MipChains* mips, const SurfacePoint& point) {
  const Material& material = world.material_of(hit.triangle);
  if (!render_features.normal_maps || !has_normal_map(material)) return point;
  SurfacePoint coat = point;
  coat.spread = {};
  shade_normal(world, render_features, hit, Triangle(world, hit), material.coat.normal_texture,
               mips, coat);
  return coat;
}

std::array<glm::vec3, 3> corner_normals(const World& world, const Hit& hit) {
  if (world.is_face(hit.triangle)) {
    const double u = hit.b1, v = hit.b2;
    const FacePoint at = face_point(world.face(hit.triangle), u, v);
    const glm::dvec3 n0 = at.normal - u * at.normal_u - v * at.normal_v;
    return {glm::vec3(n0), glm::vec3(n0 + at.normal_u), glm::vec3(n0 + at.normal_v)};
  }
  const glm::uvec3 v = world.triangles[hit.triangle];
  if (!world.normals.empty()) return {world.normals[v.x], world.normals[v.y], world.normals[v.z]};
  const glm::dvec3 normal = hit_plane(world, hit).normal();
  const double length = glm::length(normal);
  const glm::vec3 flat = length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f);
  return {flat, flat, flat};
}

NormalSpread normal_turn(const World& world, const Hit& hit, const Patch& patch, glm::vec3 normal) {
  if (world.normals.empty() && !world.is_face(hit.triangle)) return {};
  const Triangle t(world, hit);
  const std::array<glm::vec3, 3> normals = corner_normals(world, hit);
  if (normals[0] == normals[1] && normals[0] == normals[2]) return {};
  const glm::vec3 mixed = t.mix(normals[0], normals[1], normals[2]);
  const float length = glm::length(mixed);
  if (!(length > 0.0f)) return {};
  NormalSpread turn = interpolated_spread(normals, footprint_on(world, hit, patch), mixed / length,
                                          glm::dot(mixed, normal) < 0.0f ? -length : length);
  return turn;
}

float clear_height(const SurfacePoint& point) {
  // The ray-triangle test uses corners relative to the ray's origin: a dozen operations on lengths
  // of up to the triangle's extent.
  return 2.0f *
         (glm::dot(glm::abs(point.geometric_normal), point.error) + gamma_bound(12) * point.extent);
}

glm::vec3 spawn_origin(const SurfacePoint& point, glm::vec3 direction) {
  const glm::vec3 n = point.horizon();
  const float height = clear_height(point);
  return point.lit_position() + (glm::dot(n, direction) < 0.0f ? -height : height) * n;
}

}  // namespace asos
