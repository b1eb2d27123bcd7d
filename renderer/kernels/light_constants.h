#pragma once

#include "renderer/lights/prepared_light.h"

#include <glm/glm.hpp>

namespace asos {

/// The data of one light that kernels use: in single precision, except for the sampling of
/// rectangles and segments.
struct LightConstants {
  LightShape shape;
  const PreparedLight* light = nullptr;
  glm::vec3 power{0.0f};
  // The position in two parts, so that nearby points lose no digits where coordinates are large.
  glm::vec3 position{0.0f};
  glm::vec3 position_rest{0.0f};
  glm::vec3 towards{0.0f};
  float radius = 0.0f;           ///< ball, disk; sun: tangent of half its angular diameter
  float one_less_cosine = 0.0f;  ///< sun: 1 - the cosine of its half angle
  glm::vec3 half_u{0.0f};        ///< as in PreparedLight
  glm::vec3 half_v{0.0f};
  glm::vec3 u_axis{0.0f};  ///< unit
  glm::vec3 v_axis{0.0f};
  float u_length = 0.0f;
  float v_length = 0.0f;
  float area = 0.0f;              ///< flat
  float highlight_radius = 0.0f;  ///< of the representative point in a highlight
  float thickness = 0.0f;         ///< flat
  bool two_sided = false;
  /// Smallest ShadingPoints::shows_lights of reflections that contain the light; infinite: none.
  float shown_from = 0.0f;
  LightRule rule = LightRule::physical;
  float inverse_range = 0.0f;
  float cone_scale = 0.0f;
  float cone_offset = 1.0f;

  explicit LightConstants(const PreparedLight& prepared);
};

}  // namespace asos
