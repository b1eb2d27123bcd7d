#pragma once

#include "renderer/lights/prepared_light.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace asos {

/// A rectangle through which a receiver sees a whole light.
struct LightWindow {
  /// The light's part of the window.
  enum class Inside {
    all,
    ellipse,    ///< that touches the sides
    outlines,   ///< the light's own
    silhouette  ///< `outline`
  };

  glm::dvec3 middle, half_u, half_v;  ///< the centre is relative to the receiver
  Inside inside = Inside::all;
  std::vector<glm::dvec3> outline{};  ///< silhouette: in the window's plane, from the receiver

  /// Returns the window around the circle in which a cone from the receiver touches a ball; nothing
  /// inside the ball.
  [[nodiscard]] static std::optional<LightWindow> around_ball(glm::dvec3 to_centre, double radius);
};

/// Returns the window from `apex` to a light with an area: through its plane or around its rim.
/// Returns nothing for other lights and inside a ball.
[[nodiscard]] std::optional<LightWindow> light_window(const PreparedLight& light, glm::dvec3 apex);

/// Returns the fraction of the way along `towards`, from a point to a light's window, at which a
/// ray reaches the light. A flat light lies in its window. Others begin where the ray enters them.
[[nodiscard]] double way_to_light(const PreparedLight& light, glm::dvec3 from, glm::dvec3 towards);

}  // namespace asos
