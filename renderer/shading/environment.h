#pragma once

#include <glm/glm.hpp>

// The neutral surroundings of every scene.

namespace asos {

/// Radiance of the constant grey sky, as background and in reflections. On a display it is a medium
/// grey on which both white and black objects stand out.
inline constexpr float sky_radiance = 0.35f;

/// The fraction of the sky that is visible from an average surface. Ambient light has a closed form
/// without rays; this factor replaces the occlusion.
inline constexpr float sky_visibility = 0.6f;

/// Returns the visible fraction for the reflection in a lobe of this roughness. A mirror follows
/// its rays, so it needs no occlusion. The roughest lobe has the occlusion of a matte surface. In
/// between it is linear in the lobe's width (alpha, roughness squared).
inline float mirrored_visibility(float roughness) {
  return 1.0f - (1.0f - sky_visibility) * roughness * roughness;
}

/// Irradiance over pi from the sky, for every normal.
inline constexpr float ambient_radiance = sky_radiance * sky_visibility;

inline constexpr glm::vec3 background_radiance{sky_radiance};

}  // namespace asos
