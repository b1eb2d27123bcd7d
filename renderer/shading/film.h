#pragma once

#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

namespace asos {

/// KHR_materials_iridescence's Fresnel term: what a thin film in air over a base of reflectance
/// `base_f0` mirrors at an angle of incidence of this cosine, linear RGB, 0 to 1. Light that is
/// reflected within the film up to twice interferes (Belcour and Barla 2017, "A Practical Extension
/// to Microfacet Theory for the Modeling of Varying Iridescence").
[[nodiscard]] glm::vec3 film_fresnel(const SurfaceFilm& film, glm::vec3 base_f0, float cosine);

}  // namespace asos
