#pragma once

#include <glm/glm.hpp>

// The neutral surroundings of every scene, all of them in this one place.

namespace asos {

/// Radiance of the constant grey sky: the background, and what surfaces reflect of it. A display
/// shows it as a middling grey on which both white and black objects stand out.
inline constexpr float sky_radiance = 0.35f;

/// The share of the sky that an average surface sees. The ambient light is taken as unoccluded
/// (closed form, no rays), and this stands in for the occlusion that is not computed.
inline constexpr float sky_visibility = 0.6f;

/// The same of what a lobe of this roughness mirrors: a mirror follows its rays, and sees all of
/// the sky that they reach; the roughest lobe sees as much of it as matte surfaces do. In between
/// goes its width (alpha, roughness squared).
inline float mirrored_visibility(float roughness) {
  return 1.0f - (1.0f - sky_visibility) * roughness * roughness;
}

/// Irradiance over pi that the sky gives to every surface, whatever its normal.
inline constexpr float ambient_radiance = sky_radiance * sky_visibility;

inline constexpr glm::vec3 background_radiance{sky_radiance};

}  // namespace asos
