#include "renderer/shading/surface.h"

#include "renderer/shading/anisotropy.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/hit_triangle.h"
#include "renderer/shading/smooth_surface.h"
#include "renderer/shading/tangent_frame.h"
#include "renderer/shading/texture.h"
#include "renderer/shading/texture_filter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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

MappedNormal mapped_normal(const World& world, const Hit& hit, const TextureUse& use,
                           glm::vec3 normal, const Footprint& footprint, const MipChains* mips) {
  const TangentFrame frame = tangent_frame(world, hit, use, normal);
  if (!frame.known()) return {normal};
  const MeanNormal mean =
      mips ? filtered_normal(world, *mips, use, {hit.triangle, hit.b1, hit.b2, footprint})
           : MeanNormal{sample_texture(world, use, hit.triangle, hit.b1, hit.b2, Encoding::linear)};
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

/// Turns the shading normal by a normal map; see map_normal.
void turn_by_map(const World& world, const Hit& hit, const TextureUse& map, const MipChains* mips,
                 float side, SurfacePoint& point) {
  const MappedNormal mapped =
      mapped_normal(world, hit, map, side * point.shading_normal, point.footprint, mips);
  point.spread.variance = mapped.variance;
  // A mapped normal that points below the surface is ignored.
  if (glm::dot(side * mapped.normal, point.geometric_normal) > 0.0f)
    point.shading_normal = side * mapped.normal;
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
  if (render_features.normal_maps && map.used()) turn_by_map(world, hit, map, mips, side, point);
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

/// Orients the ribbon of a lit line by the line's normals. The ribbon faces the viewer, but light
/// arrives from where the normals point. Normals are taken on the viewer's side, as for
/// double-sided surfaces.
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

/// Makes a material from its base colour; `sample(use, kind)` looks up the other textures.
template <typename Sample>
SurfaceMaterial material_with(const Material& material, const RenderFeatures& render_features,
                              glm::vec4 base, const Sample& sample) {
  SurfaceMaterial surface;
  surface.base_color = glm::vec3(base);
  surface.unlit = material.unlit;
  surface.transmission = std::clamp(material.transmission, 0.0f, 1.0f);
  if (surface.transmission > 0.0f && render_features.textures &&
      material.transmission_texture.used())
    surface.transmission *= sample(material.transmission_texture, TexelKind::data).r;
  if (material.alpha_mode == AlphaMode::blend) {
    surface.opacity = std::clamp(base.a, 0.0f, 1.0f);
  } else if (material.alpha_mode == AlphaMode::mask && material.transmission > 0.0f) {
    // Without transmission, RayScene has applied the cut-off already.
    surface.opacity = base.a >= material.alpha_cutoff ? 1.0f : 0.0f;
  }
  const auto emission = [&] {
    glm::vec3 emitted = material.emissive * material.emissive_strength;
    if (material.emissive_texture.used() && emitted != glm::vec3(0.0f))
      emitted *= glm::vec3(sample(material.emissive_texture, emissive_kind(material)));
    return emitted;
  };
  if (surface.unlit) {
    if (material.stroke && render_features.emission) surface.base_color += emission();
    return surface;
  }

  surface.metallic = material.metallic;
  surface.roughness = material.roughness;
  if (render_features.textures && material.metallic_roughness_texture.used()) {
    const glm::vec4 texel = sample(material.metallic_roughness_texture, TexelKind::data);
    surface.roughness *= texel.g;
    surface.metallic *= texel.b;
  }
  if (render_features.textures && material.occlusion_texture.used()) {
    const float seen = sample(material.occlusion_texture, TexelKind::data).r;
    surface.occlusion = 1.0f + material.occlusion_texture.scale * (seen - 1.0f);
  }
  const float dielectric = (material.ior - 1.0f) / (material.ior + 1.0f);
  // KHR_materials_specular. An index of 0 means an infinite one: everything is reflected.
  glm::vec3 specular_color = material.specular_color;
  float specular = material.specular;
  if (render_features.textures && material.specular_color_texture.used())
    specular_color *= glm::vec3(sample(material.specular_color_texture, TexelKind::color));
  if (render_features.textures && material.specular_texture.used())
    specular *= sample(material.specular_texture, TexelKind::data).a;
  surface.f0 = glm::min(dielectric * dielectric * specular_color, glm::vec3(1.0f)) * specular;
  surface.f90 = specular;
  surface.dielectric_f0 = std::max({surface.f0.x, surface.f0.y, surface.f0.z});
  surface.dielectric_f90 = surface.f90;
  if (render_features.metals) {
    surface.f0 = glm::mix(surface.f0, surface.base_color, surface.metallic);
    surface.f90 = glm::mix(surface.f90, 1.0f, surface.metallic);
  }

  if (material.coat.factor > 0.0f) {
    surface.coat = {material.coat.factor, material.coat.roughness};
    if (render_features.textures && material.coat.texture.used())
      surface.coat.factor *= sample(material.coat.texture, TexelKind::data).r;
    if (render_features.textures && material.coat.roughness_texture.used())
      surface.coat.roughness *= sample(material.coat.roughness_texture, TexelKind::data).g;
  }

  if (material.sheen.used()) {
    surface.sheen = {material.sheen.color, material.sheen.roughness};
    if (render_features.textures && material.sheen.color_texture.used())
      surface.sheen.color *= glm::vec3(sample(material.sheen.color_texture, TexelKind::color));
    if (render_features.textures && material.sheen.roughness_texture.used())
      surface.sheen.roughness *= sample(material.sheen.roughness_texture, TexelKind::data).a;
  }

  if (material.film.used()) {
    surface.film = {material.film.factor, material.film.ior, material.film.thickness_max_nm};
    if (render_features.textures && material.film.texture.used())
      surface.film.factor *= sample(material.film.texture, TexelKind::data).r;
    if (render_features.textures && material.film.thickness_texture.used()) {
      const float g = sample(material.film.thickness_texture, TexelKind::data).g;
      surface.film.thickness_nm =
          glm::mix(material.film.thickness_min_nm, material.film.thickness_max_nm, g);
    }
  }

  if (material.anisotropy.used()) {
    const TextureUse& use = material.anisotropy.texture;
    surface.anisotropy =
        render_features.textures && use.used()
            ? anisotropy_of(material.anisotropy, glm::vec3(sample(use, TexelKind::data)))
            : anisotropy_of(material.anisotropy);
  }

  if (material.diffuse_transmission.used()) {
    const DiffuseTransmission& through = material.diffuse_transmission;
    surface.diffuse_transmission = through.factor;
    surface.diffuse_transmission_color = through.color;
    if (render_features.textures && through.texture.used())
      surface.diffuse_transmission *= sample(through.texture, TexelKind::data).a;
    if (render_features.textures && through.color_texture.used())
      surface.diffuse_transmission_color *=
          glm::vec3(sample(through.color_texture, TexelKind::color));
  }

  if (render_features.emission) surface.emission = emission();
  return surface;
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

void map_normal(const World& world, const Hit& hit, const MipChains* mips, float side,
                SurfacePoint& point) {
  turn_by_map(world, hit, world.material_of(hit.triangle).normal_texture, mips, side, point);
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

SurfaceMaterial surface_material(const World& world, const RenderFeatures& render_features,
                                 const Hit& hit, const Footprint& footprint,
                                 const MipChains* mips) {
  const Material& material = world.material_of(hit.triangle);
  const bool tinted = render_features.vertex_colors && !world.colors.empty();
  const glm::vec4 tint =
      tinted ? vertex_color(world, hit.triangle, hit.b1, hit.b2) : glm::vec4(1.0f);
  // The texture's alpha from which on a mask is opaque.
  std::optional<float> seen_from;
  if (material.alpha_mode == AlphaMode::mask)
    seen_from = material.alpha_cutoff / (material.base_color.a * tint.a);
  const auto sample = [&](const TextureUse& use, TexelKind kind) {
    // Textures with alpha keep their size: averaged over more than the footprint, each layer would
    // show the holes of others.
    const Footprint shown = kind == TexelKind::color ? of_colours(footprint) : footprint;
    if (mips)
      return filtered_texture(world, *mips, use, {kind, seen_from},
                              {hit.triangle, hit.b1, hit.b2, shown});
    return sample_texture(world, use, hit.triangle, hit.b1, hit.b2,
                          kind == TexelKind::data ? Encoding::linear : Encoding::srgb);
  };

  glm::vec4 base = material.base_color;
  if (render_features.textures && material.base_color_texture.used()) {
    glm::vec4 texel = sample(material.base_color_texture, base_color_kind(material));
    // The cut-off is tested at a point, as rays do.
    if (mips && material.alpha_mode == AlphaMode::mask && material.transmission > 0.0f) {
      texel.a = sample_texture(world, material.base_color_texture, hit.triangle, hit.b1, hit.b2,
                               Encoding::srgb)
                    .a;
    }
    base *= texel;
  }
  if (tinted) base *= tint;

  return material_with(material, render_features, base, sample);
}

void average_colours(const World& world, const RenderFeatures& render_features, const Hit& hit,
                     const Footprint& square, std::span<const WeightedShape> parts,
                     const MipChains& mips, SurfaceMaterial& material) {
  // With alpha blending, colours are weighted by opacity.
  const bool blends = world.material_of(hit.triangle).alpha_mode == AlphaMode::blend;
  glm::vec3 color(0.0f), emission(0.0f);
  float opacity = 0.0f;
  for (const WeightedShape& part : parts) {
    Footprint footprint = shaped(square, part.shape);
    footprint.side *= std::sqrt(part.share);
    const SurfaceMaterial own = surface_material(world, render_features, hit, footprint, &mips);
    const float share = part.share * (blends ? own.opacity : 1.0f);
    color += share * own.base_color;
    emission += share * own.emission;
    opacity += share;
  }
  if (blends) {
    material.opacity = opacity;
    if (!(opacity > 0.0f)) return;
    color /= opacity, emission /= opacity;
  }
  material.base_color = color;
  material.emission = emission;
}

SurfaceMaterial untextured_material(const Material& material,
                                    const RenderFeatures& render_features) {
  return material_with(material, render_features, material.base_color,
                       [](const TextureUse&, TexelKind) { return glm::vec4(1.0f); });
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

glm::vec4 vertex_color(const World& world, std::uint32_t triangle, float b1, float b2) {
  if (world.is_face(triangle)) return glm::vec4(1.0f);
  const glm::uvec3 v = world.triangles[triangle];
  const glm::vec4 c = world.colors[v.x];
  // A hit at an edge may lie beyond it by a rounding error; the result must not be negative.
  return glm::max(c + b1 * (world.colors[v.y] - c) + b2 * (world.colors[v.z] - c), 0.0f);
}

NormalSpread normal_turn(const World& world, const Hit& hit, const Patch& patch, glm::vec3 normal) {
  if (world.normals.empty() && !world.is_face(hit.triangle)) return {};
  const Triangle t(world, hit);
  const std::array<glm::vec3, 3> normals = corner_normals(world, hit);
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
