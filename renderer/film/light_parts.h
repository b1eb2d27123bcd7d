#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace asos {

/// How radiance reaches the camera from the surfaces along an eye ray. The parts add up to the
/// whole radiance.
enum class LightPart : std::uint8_t {
  direct,        ///< lamps and sky, scattered by the surface
  emission,      ///< of the surface, or the colour of an unlit one
  reflection,    ///< along a ray that the surface reflects
  transmission,  ///< along a ray that it refracts or scatters to its other side
  background,    ///< behind all surfaces
};
inline constexpr std::size_t light_part_count = static_cast<std::size_t>(LightPart::background) + 1;

/// Radiance by part, as a weighted sum.
struct LightSum {
  std::array<glm::dvec3, light_part_count> radiance{};
  double weight = 0.0;

  void add(LightPart part, glm::dvec3 value) { radiance[static_cast<std::size_t>(part)] += value; }
  /// Adds the radiance of a part of the pixel that has this weight, without its weight.
  void add_radiance(const LightSum& part, double part_weight) {
    if (!(part.weight > 0.0)) return;
    for (std::size_t i = 0; i < light_part_count; ++i)
      radiance[i] += part_weight / part.weight * part.radiance[i];
  }
  void add(const LightSum& part, double part_weight) {
    if (!(part.weight > 0.0)) return;
    add_radiance(part, part_weight);
    weight += part_weight;
  }
  [[nodiscard]] glm::dvec3 mean(LightPart part) const {
    return weight > 0.0 ? radiance[static_cast<std::size_t>(part)] / weight : glm::dvec3(0.0);
  }
};

}  // namespace asos
