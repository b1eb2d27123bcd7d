#pragma once

#include "renderer/lights/prepared_light.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shading/specular_integral.h"
#include "renderer/shading/viewed_point.h"

#include <glm/glm.hpp>

namespace asos {

/// Radiance towards the viewer per irradiance from a light. The lobe's part is that of the light's
/// representative point, made as broad as the light by the ratio of what its width was to what it
/// would be (Karis 2013): of the whole light, whatever is visible of it.
[[nodiscard]] glm::vec3 reflected_share(const PreparedLight& light, const ViewedMaterial& seen,
                                        const ViewedPoint& view, const Highlight& highlight);

/// The same of a light with a size by the physical rule, its highlight in closed form (specular_of)
/// of a lobe that is as much wider as `highlight` finds the patch to make it, then round. `own` is
/// the surface without any patch; `irradiance` that of the whole light there, not 0.
[[nodiscard]] glm::vec3 mirrored_share(const PreparedLight& light, const ViewedMaterial& seen,
                                       const ViewedPoint& view, const SpecularView& own,
                                       const Highlight& highlight, glm::vec3 irradiance);

/// Radiance towards the viewer per irradiance that comes from one direction: the BRDF, of the patch
/// that the point stands for. `to_light` is unit.
[[nodiscard]] glm::vec3 reflected_towards(const ViewedMaterial& seen, const ViewedPoint& view,
                                          glm::vec3 to_light, float light_distance);

/// Radiance towards the viewer per irradiance by a sample of the light; by the published rule that
/// of the whole light.
[[nodiscard]] glm::vec3 reflected_from(const Illumination& lit, const LightSample& sample);

/// Whether a reflection shows the light: lines and points are too thin, and suns too bright.
[[nodiscard]] bool shown_by_mirrors(const PreparedLight& light);

}  // namespace asos
