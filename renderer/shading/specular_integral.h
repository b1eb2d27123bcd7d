#pragma once

#include "renderer/lights/prepared_light.h"
#include "renderer/lights/receiver.h"
#include "renderer/shading/ltc.h"

#include <glm/glm.hpp>

namespace asos {

/// What the GGX lobe of brdf.h mirrors of a light with nothing in the way, without the colours: the
/// radiance is power * (f0 * lobe + (f90 - f0) * fresnel), with the power of the PreparedLight.
struct SpecularIntegral {
  double lobe = 0.0;
  double fresnel = 0.0;
};

/// A surface and its viewer, looked up once for all lights.
struct SpecularView {
  SpecularView(const Receiver& at, glm::dvec3 viewer, double surface_roughness);

  Receiver receiver;
  glm::dvec3 to_viewer;  ///< unit
  double roughness;
  LtcPair ltc;
};

/// Clipped to both of the receiver's horizons; finite for all finite input, at least 0. Of a point
/// or distant light the BRDF's own value; of all others the closed form of the fitted lobe
/// (ltc_error says how good that is; segments by Heitz and Hill 2017), except that the points of a
/// segment by the published rule, which shine the same in all directions, are summed up. Other
/// lights are taken by the physical rule whatever theirs is.
[[nodiscard]] SpecularIntegral specular_of(const PreparedLight& light, const SpecularView& view);

}  // namespace asos
