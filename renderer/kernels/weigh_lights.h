#pragma once

#include "renderer/kernels/light_constants.h"
#include "renderer/kernels/shading_points.h"

#include <limits>
#include <span>

namespace asos {

/// Bounds of a light in single precision, by which its contribution is estimated. All members are
/// floats, so that kernels gather them.
struct LightBounds {
  // The centre in homogeneous coordinates: for infinite lights the direction to them, and 0.
  glm::vec3 centre{0.0f};
  float finite = 1.0f;
  glm::vec3 towards{0.0f};
  glm::vec3 power{0.0f};
  float extent = 1.0f;  ///< power times this is the intensity; for infinite lights, the irradiance
  // Irradiance is proportional to 1 / max(distance (distance + near_linear), near_square).
  float near_linear = 0.0f;
  float near_square = std::numeric_limits<float>::min();
  // The light emits max(all_round, front c, -back c) of its power, with the cosine c to `towards`.
  float all_round = 1.0f;
  float front = 0.0f;
  float back = 0.0f;
  // Half edges, and 1 / their squared lengths; 0 where there are none. `round` is the radius about
  // them of lights that are not flat.
  glm::vec3 half_u{0.0f};
  glm::vec3 half_v{0.0f};
  float per_u2 = 0.0f;
  float per_v2 = 0.0f;
  float round = 0.0f;
  float inverse_range = 0.0f;
  float cone_scale = 0.0f;
  float cone_offset = 1.0f;
  float shown_from = 0.0f;

  explicit LightBounds(const LightConstants& light);
};

/// Estimates the unshadowed contribution of each light at each point, in the brightest channel:
/// bounds on flux, distance, cone and horizons (as in Conty Estevez and Kulla 2018, "Importance
/// Sampling of Many Lights with Adaptive Tree Splitting", section 5), times the BRDF towards the
/// light's centre. The lobe is widened by the light's spread of half vectors. An estimate is never
/// 0 where any part of the light contributes. For lights that are small compared with their
/// distance the error is 3 %. Nowhere is the estimate less than a tenth of the samples'
/// contribution (root mean square). `weights` has one array per light. The bits do not depend on
/// the instruction set.
void weigh_lights(std::span<const LightBounds> lights, const ShadingPoints& points,
                  std::span<ShadingPoints::Floats> weights);
/// Sets the same weights at point i alone, faster. `weights` has room for a multiple
/// of 16 lights.
void weigh_lights(std::span<const LightBounds> lights, const ShadingPoints& points, std::size_t i,
                  std::span<float> weights);

}  // namespace asos
