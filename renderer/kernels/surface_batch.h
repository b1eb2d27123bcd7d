#pragma once

#include "renderer/kernels/shading_points.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <cstddef>

namespace asos {

/// The triangle hits of a batch of rays, as arrays. Lanes beyond `count` are undefined.
struct TriangleBatch {
  using Floats = ShadingPoints::Floats;
  using Vectors = ShadingPoints::Vectors;

  std::size_t count = 0;
  Vectors corner_0, corner_1, corner_2;
  Vectors normal_0, normal_1, normal_2;  ///< the interpolated normals at the corners
  Floats b1{}, b2{};                     ///< as in Hit
  Floats distance{};
  Vectors direction;  ///< of the ray; unit
  Floats side{};      ///< side of the square that the ray represents, in pixels
  Floats textured{};  ///< 1 where the patch always matters; else 0
  Floats shiny{};     ///< 1 where the patch matters if the normals turn; else 0

  void set_hit(std::size_t i, const Hit& hit, const Ray& ray, float of_side) {
    b1[i] = hit.b1, b2[i] = hit.b2;
    distance[i] = hit.t;
    direction.set(i, ray.direction);
    side[i] = of_side;
  }
};

/// One PixelSpacing per hit of a batch.
struct SpacingBatch {
  ShadingPoints::Vectors right, down, forward;
  ShadingPoints::Floats start{};
  ShadingPoints::Floats perspective{};  ///< 1 or 0

  void set(std::size_t i, const PixelSpacing& spacing) {
    right.set(i, spacing.right), down.set(i, spacing.down), forward.set(i, spacing.forward);
    start[i] = spacing.start;
    perspective[i] = spacing.perspective ? 1.0f : 0.0f;
  }
};

/// Fields of SurfacePoint that ShadingPoints lacks.
struct SurfaceRest {
  ShadingPoints::Vectors position, geometric;  ///< of the triangle
  ShadingPoints::Vectors lift, smooth_normal;
  ShadingPoints::Vectors error;
  ShadingPoints::Floats extent{};
  ShadingPoints::Floats normal_side{};  ///< -1 where the interpolated normal was negated; else 1
  ShadingPoints::Floats right_b1{}, right_b2{}, down_b1{}, down_b2{};  ///< of the Footprint
};

/// Fields of SurfaceMaterial, for lit surfaces.
struct MaterialBatch {
  ShadingPoints::Vectors base_color;  ///< of the part that is reflected
  ShadingPoints::Vectors f0;
  ShadingPoints::Floats f90{}, roughness{}, metallic{};
  ShadingPoints::Floats dielectric_f0{}, dielectric_f90{};
  ShadingPoints::Floats occlusion{};
  ShadingPoints::Vectors specular, ambient;  ///< outputs, as in ViewedMaterial
  ShadingPoints::Floats below{};             ///< output, as in ViewedMaterial

  void set(std::size_t i, const SurfaceMaterial& material) {
    const float reflected = (1.0f - material.transmission) * (1.0f - material.diffuse_transmission);
    base_color.set(i, reflected * material.base_color);
    f0.set(i, material.f0);
    f90[i] = material.f90;
    roughness[i] = material.roughness;
    metallic[i] = material.metallic;
    dielectric_f0[i] = material.dielectric_f0;
    dielectric_f90[i] = material.dielectric_f90;
    occlusion[i] = material.occlusion;
  }
};

/// Returns lane i as a Footprint.
[[nodiscard]] inline Footprint footprint_at(const TriangleBatch& hits, const SurfaceRest& rest,
                                            std::size_t i) {
  Footprint footprint;
  footprint.right = {rest.right_b1[i], rest.right_b2[i]};
  footprint.down = {rest.down_b1[i], rest.down_b2[i]};
  footprint.side = hits.side[i];
  return footprint;
}
[[nodiscard]] SurfacePoint surface_at(const TriangleBatch& hits, const SurfaceRest& rest,
                                      const ShadingPoints& points, std::uint32_t triangle,
                                      std::size_t i);

}  // namespace asos
