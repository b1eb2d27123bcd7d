#pragma once

#include "renderer/kernels/light_constants.h"
#include "renderer/kernels/shading_points.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace asos {

/// The sample on a light of each point of a batch, as 32-bit binary fractions of the unit square.
struct LightPointBatch {
  // A kernel may write a whole vector beyond the end.
  static constexpr std::size_t room = ShadingPoints::size + 16;
  struct alignas(64) Fractions : std::array<std::uint32_t, room> {};
  Fractions u{}, v{};
};

/// Shadow rays of a batch, as arrays, with the unshadowed contribution of each.
struct ShadowRayBatch {
  // A kernel may write a whole vector beyond the end.
  static constexpr std::size_t room = ShadingPoints::size + 16;
  struct alignas(64) Floats : std::array<float, room> {};

  std::size_t count = 0;
  std::size_t rejected = 0;  ///< rays left out because their contribution is not finite
  std::array<Floats, 3> origin{};
  std::array<Floats, 3> direction{};  ///< unit
  Floats t_far{};
  std::array<Floats, 3> carried{};
  struct alignas(64) Indices : std::array<std::uint32_t, room> {};
  Indices point{};  ///< index into the batch, ascending
};

/// A direction of each point's lobe.
struct LobeBatch {
  ShadingPoints::Vectors direction;
};

/// Numbers of a light at each point of a batch; their meaning depends on the light's shape.
struct LightArcs {
  struct alignas(64) Doubles : std::array<double, ShadingPoints::size> {};

  ShadingPoints::Floats first, second, third, fourth;
  /// Of a rectangle, the same for all samples on it: whether they are known, and the solid angle,
  /// sine and cosine of the angle at its first side, and the normals of two sides.
  bool known = false;
  Doubles solid_angle, sine, cosine, normal_0, normal_2;
};

/// Computes the shadow rays from points to samples of a light, as sample_light, reflected_towards
/// (or reflected_share, by the published rule) and shadow_ray do in double precision. For a light
/// with an area and a narrow lobe, the highlight has its weight by multiple importance sampling;
/// shade_lobe has the rest. Rays without a contribution are left out. The bits of a point's ray
/// depend only on the point and the light, not on its place in the batch or the instruction set.
void shade_batch(const ShadingPoints& points, const LightConstants& light,
                 const LightPointBatch& places, ShadowRayBatch& rays);
/// Does so with the `arcs` of an earlier call for the same points and light. If they are not known,
/// they are set.
void shade_batch(const ShadingPoints& points, const LightConstants& light,
                 const LightPointBatch& places, LightArcs& arcs, ShadowRayBatch& rays);

/// Computes the contributions of a light that casts no shadow. For a rectangle, the diffuse part
/// uses the closed form of unshadowed_irradiance, the highlight one sample, and `rays` then holds
/// contributions only. Other lights are as in shade_batch.
void shade_unshadowed(const ShadingPoints& points, const LightConstants& light,
                      const LightPointBatch& places, ShadowRayBatch& rays);

/// Reflects each point's view direction at a visible normal, sampled from the GGX lobe of its
/// roughness.
void choose_lobes(const ShadingPoints& points, const LightPointBatch& places, LobeBatch& lobes);

/// Computes the shadow rays of lobe samples to a light with an area, each with the rest of the
/// highlight's weight. There are none to other lights, from points with broad lobes, or by the
/// published rule.
void shade_lobe(const ShadingPoints& points, const LightConstants& light, const LobeBatch& lobes,
                LightArcs& arcs, ShadowRayBatch& rays);

}  // namespace asos
