#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/lobe.h"
#include "renderer/shading/mip_chain.h"
#include "renderer/shading/normal_spread.h"
#include "renderer/shading/texel_means.h"
#include "renderer/world/render_features.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// The geometry of a hit, oriented to the viewer for any winding of the triangle.
struct SurfacePoint {
  glm::vec3 position{0.0f};
  glm::vec3 error{0.0f};             ///< bound of position's rounding error, per coordinate
  glm::vec3 geometric_normal{0.0f};  ///< unit, towards the viewer; 0 for a zero-area triangle
  glm::vec3 shading_normal{0.0f};    ///< unit, in the geometric normal's half-space
  /// Where a mesh represents a smooth surface that bulges above it, lights illuminate that surface
  /// (height_of_smooth). `lift` is its displacement from `position`, and `smooth_normal` its unit
  /// normal without normal maps. 0: the triangle itself is lit.
  glm::vec3 lift{0.0f};
  glm::vec3 smooth_normal{0.0f};
  float extent = 0.0f;  ///< largest side of the triangle's box
  /// A lower bound of the distance to the triangle's border; infinite for analytic shapes.
  float to_edge = std::numeric_limits<float>::infinity();
  std::uint32_t triangle = Hit::none;
  Footprint footprint;
  NormalSpread spread;  ///< of the shading normals over the footprint

  /// The point where light arrives, and the normal of the horizon below which none does.
  [[nodiscard]] glm::vec3 lit_position() const { return position + lift; }
  [[nodiscard]] glm::vec3 horizon() const {
    return smooth_normal == glm::vec3(0.0f) ? geometric_normal : smooth_normal;
  }
  /// Makes lights illuminate the triangle itself.
  void forget_smooth_surface() { lift = smooth_normal = glm::vec3(0.0f); }
};

/// Clearcoat at a point.
struct SurfaceCoat {
  float factor = 0.0f;  ///< 0: none
  float roughness = 0.0f;
};

/// Iridescence at a point.
struct SurfaceThinFilm {
  float factor = 0.0f;  ///< 0: none
  float ior = 1.3f;
  float thickness_nm = 0.0f;
};

/// Anisotropy at a point.
struct SurfaceAnisotropy {
  float strength = 0.0f;  ///< 0: none
  /// Direction of greater roughness, unit, in tangent and bitangent.
  glm::vec2 direction{1.0f, 0.0f};
};

/// Sheen at a point.
struct SurfaceSheen {
  glm::vec3 color{0.0f};  ///< black: none
  float roughness = 0.0f;
};

/// Reflectance and emission of a material at a point: factors, textures and vertex colours.
struct SurfaceMaterial {
  glm::vec3 base_color{1.0f};
  float opacity = 1.0f;  ///< coverage by the alpha mode, 0 to 1, without transmission
  float transmission = 0.0f;
  /// Fraction of the diffuse part that is transmitted to the other side.
  float diffuse_transmission = 0.0f;
  glm::vec3 diffuse_transmission_color{1.0f};
  float metallic = 0.0f;
  float roughness = 1.0f;
  glm::vec3 emission{0.0f};
  glm::vec3 f0{0.04f};  ///< reflectance at normal incidence
  float f90 = 1.0f;     ///< reflectance at grazing incidence
  // Largest colour of the dielectric's reflectance; the diffuse part lies below it.
  float dielectric_f0 = 0.04f;
  float dielectric_f90 = 1.0f;
  /// Visible fraction of the sky, where no shadows of the sky are computed.
  float occlusion = 1.0f;
  bool unlit = false;
  SurfaceCoat coat;
  SurfaceSheen sheen;
  SurfaceThinFilm film;
  SurfaceAnisotropy anisotropy;
  /// Computed from the anisotropy for a viewer; surface_material leaves it out.
  LobeStretch stretch;
};

/// The extent of a sample: a square of `side` pixels, and the mip chains that average textures over
/// its patch. The default is a point.
struct SampleExtent {
  const PixelSpacing* spacing = nullptr;
  const MipChains* mips = nullptr;
  float side = 0.0f;
  FootprintShape shape = {};
  float colours = 1.0f;  ///< factor of the width over which colours are averaged

  [[nodiscard]] bool point() const { return !spacing || !mips || !(side > 0.0f); }
};

/// Returns the geometry of a hit. `to_viewer` is unit; the hit is that of a unit direction.
[[nodiscard]] SurfacePoint surface_point(const World& world, const RenderFeatures& render_features,
                                         const Hit& hit, glm::vec3 to_viewer,
                                         const SampleExtent& extent = {});
/// Returns the material at a hit, averaged over a footprint if there are `mips`.
[[nodiscard]] SurfaceMaterial surface_material(const World& world,
                                               const RenderFeatures& render_features,
                                               const Hit& hit, const Footprint& footprint = {},
                                               const MipChains* mips = nullptr);

/// A texture that a material looks up.
struct TextureLookUp {
  TextureUse use;
  TexelKind kind = TexelKind::data;
};
/// Returns the textures that surface_material looks up, in its order.
[[nodiscard]] std::vector<TextureLookUp> texture_look_ups(const Material& material,
                                                          const RenderFeatures& render_features);
/// Values of those textures at a point, `stride` apart.
struct LookedUpTexels {
  const glm::vec4* first = nullptr;
  std::size_t stride = 1;
  bool averaged = false;  ///< over a footprint
};
/// Returns the material at a hit from its textures' values.
[[nodiscard]] SurfaceMaterial surface_material(const World& world,
                                               const RenderFeatures& render_features,
                                               const Hit& hit, const LookedUpTexels& texels);
/// Returns the cut-off of surface_material's look-ups at a hit, if the material has one.
[[nodiscard]] std::optional<float> texel_cutoff(const World& world,
                                                const RenderFeatures& render_features,
                                                const Hit& hit);

/// Replaces the material's base colour and emission by their means over the parts of a square's
/// footprint.
void average_colours(const World& world, const RenderFeatures& render_features, const Hit& hit,
                     const Footprint& square, std::span<const WeightedShape> parts,
                     const MipChains& mips, SurfaceMaterial& material);

/// Returns a material without textures and vertex colours.
[[nodiscard]] SurfaceMaterial untextured_material(const Material& material,
                                                  const RenderFeatures& render_features);

/// Turns the shading normal by a normal map, which must exist. With `mips` it uses the mean over
/// the point's footprint. `side` is -1 where the shading normal is the interpolated one negated, to
/// be on the geometric normal's side; else 1.
void map_normal(const World& world, const Hit& hit, const TextureUse& map, const MipChains* mips,
                float side, SurfacePoint& point);

/// Does so with the map's mean already known.
void map_normal(const World& world, const Hit& hit, const TextureUse& map, const MeanNormal& mean,
                float side, SurfacePoint& point);

/// Returns the point for the material's coat, with the coat's own normals.
[[nodiscard]] SurfacePoint coat_point(const World& world, const RenderFeatures& render_features,
                                      const Hit& hit, const MipChains* mips,
                                      const SurfacePoint& point);

/// Returns the values of the interpolated normal at the corners of the hit's triangle. On a face of
/// an analytic shape they are those of a linear function with the normal's value and derivatives at
/// the hit. Without vertex normals, all are the triangle's normal.
[[nodiscard]] std::array<glm::vec3, 3> corner_normals(const World& world, const Hit& hit);

/// Returns the vertex colour at (b1, b2) of a triangle, as linear RGBA. Exact where the corners
/// have the same colour, so that white has no effect.
[[nodiscard]] glm::vec4 vertex_color(const World& world, std::uint32_t triangle, float b1,
                                     float b2);

/// Returns the turn of the interpolated normal along the edges of a patch around a hit; 0 where the
/// surface is flat. It is on the side of `normal`, the unit shading normal there.
[[nodiscard]] NormalSpread normal_turn(const World& world, const Hit& hit, const Patch& patch,
                                       glm::vec3 normal);

/// A triangle's longest side is at most this times its extent. With it and twice the triangle's
/// area (longest side times least height), the smallest barycentric weight gives `to_edge`.
inline constexpr float longest_side = 1.7320509f;

/// Returns the height above the surface at which a ray starts or ends without hitting it, along the
/// normal.
[[nodiscard]] float clear_height(const SurfacePoint& point);

/// Returns the offset by which a ray leaves a surface with the unit normal `n` towards the unit
/// direction `d`. The ray is then `height` above the surface, or below it for a `d` that points
/// there. The offset is along `d`, so that the ray does not move sideways past other surfaces. For
/// grazing directions this part is at most four times the height, and at most `to_edge`, the extent
/// of the surface, since a wall may stand there. The rest is along the normal.
template <typename Vector, typename Number>
[[nodiscard]] Vector clear_way(Number height, Number to_edge, const Vector& n, const Vector& d) {
  constexpr Number least_cosine = Number(0.25);
  const Number along = glm::dot(n, d), cosine = std::abs(along);
  const Number steep = height / std::max(cosine, least_cosine);
  const Number way = steep > to_edge ? to_edge : steep;
  const Number rest = height - way * cosine;
  return way * d + (along < Number(0) ? -rest : rest) * n;
}

/// Returns where a ray towards a light in `direction` starts without hitting its own surface. It is
/// the lit position moved along the horizon's normal. The distance is the point's own error bound
/// plus that of the ray-triangle test, which grows with the triangle (pbrt, "Managing Rounding
/// Error").
[[nodiscard]] glm::vec3 spawn_origin(const SurfacePoint& point, glm::vec3 direction);

}  // namespace asos
