#include "renderer/shading/lobe.h"

#include <cmath>

namespace asos {

float Lobe::alpha_along() const {
  const float across = alpha();
  if (stretch.none()) return across;
  return std::min(1.0f, std::sqrt(across * across + glm::dot(stretch.along, stretch.along)));
}

float Lobe::widest_roughness() const {
  return stretch.none() ? roughness : std::sqrt(alpha_along());
}

float Lobe::round_roughness() const {
  return stretch.none() ? roughness : std::sqrt(std::sqrt(alpha() * alpha_along()));
}

float Lobe::away_from_peak(glm::vec3 normal, glm::vec3 half) const {
  const float away2 = std::max(0.0f, 2.0f - 2.0f * glm::dot(normal, half));
  if (stretch.none()) return std::sqrt(away2);
  const float along = glm::dot(half, glm::normalize(stretch.along));
  const float narrower = alpha() / alpha_along();
  const float across2 = std::max(0.0f, away2 - along * along);
  return std::sqrt(across2 + along * along * narrower * narrower);
}

}  // namespace asos
