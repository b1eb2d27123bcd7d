#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/mip_chain.h"
#include "renderer/shading/normal_spread.h"
#include "renderer/world/needs.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asos {

/// The geometry of a hit, turned to the viewer: the winding of a triangle does not matter.
struct SurfacePoint {
  glm::vec3 position{0.0f};
  glm::vec3 error{0.0f};             ///< bound of position's rounding error, by coordinate
  glm::vec3 geometric_normal{0.0f};  ///< unit, towards the viewer; 0 for a zero-area triangle
  glm::vec3 shading_normal{0.0f};    ///< unit, in the geometric normal's half-space
  /// Where a mesh stands for a smooth surface that bulges above it, that surface as lights see it
  /// (height_of_smooth): how far it lies above `position`, and its unit normal, without any map; 0:
  /// lights see the triangle.
  glm::vec3 lift{0.0f};
  glm::vec3 smooth_normal{0.0f};
  float extent = 0.0f;  ///< largest side of the triangle's box
  /// At least how far its triangle goes on in all directions; of analytic shapes without a bound.
  float to_edge = std::numeric_limits<float>::infinity();
  std::uint32_t triangle = Hit::none;
  Footprint footprint;
  NormalSpread spread;  ///< of the shading normals across the footprint

  /// Where lights and the sky reach it, and the normal below whose horizon they do not.
  [[nodiscard]] glm::vec3 lit_position() const { return position + lift; }
  [[nodiscard]] glm::vec3 horizon() const {
    return smooth_normal == glm::vec3(0.0f) ? geometric_normal : smooth_normal;
  }
  /// Lights see the triangle itself.
  void forget_smooth_surface() { lift = smooth_normal = glm::vec3(0.0f); }
};

/// Clearcoat at a point.
struct SurfaceCoat {
  float factor = 0.0f;  ///< 0: none
  float roughness = 0.0f;
};

/// Iridescence at a point.
struct SurfaceFilm {
  float factor = 0.0f;  ///< 0: none
  float ior = 1.3f;
  float thickness_nm = 0.0f;
};

/// Anisotropy at a point.
struct SurfaceAnisotropy {
  float strength = 0.0f;            ///< 0: none
  glm::vec2 direction{1.0f, 0.0f};  ///< unit, of greater roughness, in tangent and bitangent
};

/// A GGX lobe that is rougher along one direction of the tangent plane than across it.
struct LobeStretch {
  /// That direction; its length is sqrt(at^2 - ab^2), with the squared roughness `at` along it and
  /// `ab`, the material's own, across. 0: the lobe is round.
  glm::vec3 along{0.0f};
  /// How much of the viewer's part in the tangent plane is along it: squared cosine, 0 to 1.
  float seen_along2 = 0.0f;

  [[nodiscard]] bool none() const { return along == glm::vec3(0.0f); }
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
  float diffuse_transmission = 0.0f;  ///< share of the diffuse part that comes from behind
  glm::vec3 diffuse_transmission_color{1.0f};
  float metallic = 0.0f;
  float roughness = 1.0f;
  glm::vec3 emission{0.0f};
  glm::vec3 f0{0.04f};  ///< reflectance at normal incidence
  float f90 = 1.0f;     ///< the same at grazing incidence
  // The same of the part that is no metal, the largest of the colours': the diffuse part lies
  // below.
  float dielectric_f0 = 0.04f;
  float dielectric_f90 = 1.0f;
  float occlusion =
      1.0f;  ///< share of the sky that a surface sees, where its shadows are not found
  bool unlit = false;
  SurfaceCoat coat;
  SurfaceSheen sheen;
  SurfaceFilm film;
  SurfaceAnisotropy anisotropy;
  LobeStretch stretch;  ///< as anisotropy makes it for a viewer; surface_material leaves it out
};

/// The extent that a sample stands for: a square of `side` pixels, and the mip chains that average
/// textures over the patch that it shows. A default one is a point.
struct SampleExtent {
  const PixelSpacing* spacing = nullptr;
  const MipChains* mips = nullptr;
  float side = 0.0f;
  PartShape shape = {};
  float colours = 1.0f;  ///< times as wide is the square that colours are averaged over

  [[nodiscard]] bool point() const { return !spacing || !mips || !(side > 0.0f); }
};

/// `to_viewer` is unit; the hit is that of a unit direction.
[[nodiscard]] SurfacePoint surface_point(const World& world, const SceneNeeds& needs,
                                         const Hit& hit, glm::vec3 to_viewer,
                                         const SampleExtent& extent = {});
/// The mean over a footprint where there are `mips`.
[[nodiscard]] SurfaceMaterial surface_material(const World& world, const SceneNeeds& needs,
                                               const Hit& hit, const Footprint& footprint = {},
                                               const MipChains* mips = nullptr);

/// Makes the colours that the material shows and sends out their means over parts of what a
/// square's footprint shows.
void average_colours(const World& world, const SceneNeeds& needs, const Hit& hit,
                     const Footprint& square, std::span<const SharedShape> parts,
                     const MipChains& mips, SurfaceMaterial& material);

/// The same of a material without textures or vertex colours.
[[nodiscard]] SurfaceMaterial untextured_material(const Material& material,
                                                  const SceneNeeds& needs);

/// Turns the shading normal by the material's map of normals, which it has: the mean over the
/// point's footprint where there are `mips`. `side`: -1 where the shading normal is the
/// interpolated one turned round, to be on the geometric normal's side; else 1.
void map_normal(const World& world, const Hit& hit, const MipChains* mips, float side,
                SurfacePoint& point);

/// The point as the material's coat has it: its normals are the coat's own.
[[nodiscard]] SurfacePoint coat_point(const World& world, const SceneNeeds& needs, const Hit& hit,
                                      const MipChains* mips, const SurfacePoint& point);

/// The interpolated normal's values at the corners of what a hit is on; of a face of an analytic
/// shape those of the vector that is its normal, and turns as it does, at the hit. The triangle of
/// a world without normals has its own.
[[nodiscard]] std::array<glm::vec3, 3> corner_normals(const World& world, const Hit& hit);

/// Linear RGBA at (b1, b2) of a triangle of a world with vertex colours: exact where the corners
/// have one colour, so that white changes nothing.
[[nodiscard]] glm::vec4 vertex_color(const World& world, std::uint32_t triangle, float b1,
                                     float b2);

/// How the interpolated normal of a hit's surface turns along the edges of a patch around it; all 0
/// where it is flat. On the side of `normal`, the unit shading normal there.
[[nodiscard]] NormalSpread normal_turn(const World& world, const Hit& hit, const Patch& patch,
                                       glm::vec3 normal);

/// A triangle's longest side is no longer than this times its extent. By it and twice the
/// triangle's area, which is longest side times least height, the least of a place's weights tells
/// `to_edge`.
inline constexpr float longest_side = 1.7320509f;

/// How far above the surface a ray starts or ends without meeting it, along its normal.
[[nodiscard]] float clear_height(const SurfacePoint& point);

/// The way by which something leaves a surface with the unit normal `n` towards the unit direction
/// `d`, until it is `height` above it or, for a `d` below it, under it: along `d`, so that what
/// lies that way is not seen from beside; of one that grazes, at most four times the height, and
/// no further than the surface goes on, `to_edge`, for a wall may stand there. The rest is along
/// the normal.
template <typename Vector, typename Number>
[[nodiscard]] Vector clear_way(Number height, Number to_edge, const Vector& n, const Vector& d) {
  constexpr Number least_cosine = Number(0.25);
  const Number along = glm::dot(n, d), cosine = std::abs(along);
  const Number steep = height / std::max(cosine, least_cosine);
  const Number way = steep > to_edge ? to_edge : steep;
  const Number rest = height - way * cosine;
  return way * d + (along < Number(0) ? -rest : rest) * n;
}

/// Where a ray towards a light in `direction` leaves a surface without meeting it again: the lit
/// position moved along the horizon's normal by the point's own error bound and that of the
/// ray-triangle test, which grows with the triangle (pbrt, "Managing Rounding Error").
[[nodiscard]] glm::vec3 spawn_origin(const SurfacePoint& point, glm::vec3 direction);

}  // namespace asos
