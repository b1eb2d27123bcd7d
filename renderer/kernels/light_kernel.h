#pragma once

#include "renderer/kernels/light_constants.h"
#include "renderer/kernels/lit_batch.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace asos {

/// Where on a light each point of a batch looks: 32-bit binary fractions of the unit square.
struct LightPlaceBatch {
  // A kernel may write a whole vector at the end.
  static constexpr std::size_t room = LitBatch::size + 16;
  struct alignas(64) Fractions : std::array<std::uint32_t, room> {};
  Fractions u{}, v{};
};

/// Shadow rays of a batch, as arrays, and what each carries into its sum if nothing is in its way.
struct ShadowRayBatch {
  // A kernel may write a whole vector at the end.
  static constexpr std::size_t room = LitBatch::size + 16;
  struct alignas(64) Floats : std::array<float, room> {};

  std::size_t count = 0;
  std::size_t rejected = 0;  ///< that would have carried what is not finite: left out
  std::array<Floats, 3> origin{};
  std::array<Floats, 3> direction{};  ///< unit
  Floats t_far{};
  std::array<Floats, 3> carried{};
  struct alignas(64) Indices : std::array<std::uint32_t, room> {};
  Indices point{};  ///< index into the batch, ascending
};

/// A direction of each point's lobe.
struct LobeBatch {
  LitBatch::Vectors direction;
};

/// The shadow rays that a light's points send back to it, as sample_light, reflected_towards (or
/// reflected_share, by the published rule) and shadow_ray make them for one point in double
/// precision; of the highlight of a light with an area, on a lobe that is no broad one, the share
/// that is not shade_lobe's. Those that carry nothing are left out. The bits of a point's ray
/// depend on the point and the light alone, not on its place in the batch nor on the instructions
/// that the processor has.
void shade_batch(const LitBatch& points, const LightConstants& light, const LightPlaceBatch& places,
                 ShadowRayBatch& rays);

/// What points get of a rectangle that casts no shadow: what they scatter by the closed form of
/// unshadowed_irradiance, the highlight by that of a sample. `rays` has no rays then but what they
/// would carry.
void shade_unshadowed(const LitBatch& points, const LightConstants& light,
                      const LightPlaceBatch& places, ShadowRayBatch& rays);

/// Mirrors each point's view at a normal that it sees, by the GGX lobe of its roughness.
void choose_lobes(const LitBatch& points, const LightPlaceBatch& places, LobeBatch& lobes);

/// The shadow rays that lobes send to a light with an area, each with the rest of the highlight;
/// none to other lights, of points with broad lobes, and by the published rule.
void shade_lobe(const LitBatch& points, const LightConstants& light, const LobeBatch& lobes,
                ShadowRayBatch& rays);

}  // namespace asos
