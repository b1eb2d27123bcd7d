#pragma once

#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

namespace asos {

/// Returns the Fresnel term of KHR_materials_iridescence, linear RGB, 0 to 1: the reflectance of a
/// thin film in air over a base of reflectance `base_f0`, at an angle of incidence with this
/// cosine. Light that is reflected up to twice within the film interferes (Belcour and Barla 2017,
/// "A Practical Extension to Microfacet Theory for the Modeling of Varying Iridescence").
[[nodiscard]] glm::vec3 thin_film_fresnel(const SurfaceThinFilm& film, glm::vec3 base_f0,
                                          float cosine);

}  // namespace asos
