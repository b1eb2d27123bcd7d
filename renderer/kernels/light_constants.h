#pragma once

#include "renderer/lights/prepared_light.h"

#include <glm/glm.hpp>

namespace asos {

/// What kernels need of a light, once a light: single precision but for what rectangles and
/// segments are sampled by.
struct LightConstants {
  /// As PreparedLight::Shape; rectangles are a shape of their own.
  enum class Shape { point, distant, ball, sun, segment, rectangle, polygon, disk };

  Shape shape = Shape::point;
  const PreparedLight* light = nullptr;
  glm::vec3 power{0.0f};
  // The position in two parts: what is near it loses no digits where positions are large.
  glm::vec3 position{0.0f};
  glm::vec3 position_rest{0.0f};
  glm::vec3 towards{0.0f};
  float radius = 0.0f;           ///< ball, disk; sun: tangent of half its angular diameter
  float one_less_cosine = 0.0f;  ///< sun: of its half angle
  glm::vec3 half_u{0.0f};        ///< as PreparedLight's
  glm::vec3 half_v{0.0f};
  glm::vec3 u_axis{0.0f};  ///< unit
  glm::vec3 v_axis{0.0f};
  float u_length = 0.0f;
  float v_length = 0.0f;
  float area = 0.0f;              ///< polygon, disk
  float highlight_radius = 0.0f;  ///< of what stands for it in a highlight
  float thickness = 0.0f;         ///< polygon, disk
  bool two_sided = false;
  float shown_from =
      0.0f;  ///< in a reflection of LitBatch::shows_lights at least this; infinite: in none
  bool lambertian = true;       ///< segment
  bool representative = false;  ///< one point of it is the highlight of all: the published rule
  bool attenuates = false;
  float inverse_range = 0.0f;
  float cone_scale = 0.0f;
  float cone_offset = 1.0f;

  explicit LightConstants(const PreparedLight& prepared);
};

}  // namespace asos
