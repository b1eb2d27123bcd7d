#include "renderer/shading/thin_film.h"
#include "tests/renderer/shading/seen_floor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// White furnaces: the radiance of materials under a sky of radiance 1, which is at most 1. Coats
// and sheen are in layers_test.cpp, anisotropy in anisotropy_test.cpp, thin walls in
// passage_test.cpp, volumes in asos/glass_volume_test.cpp.

namespace asos::test::furnace_test {
namespace {

constexpr double angles[] = {0.0, 0.6, 1.0, 1.3};

glm::vec3 seen_of(const Material& material, double angle) {
  const Sky white(glm::vec3(1.0f));
  return SeenFloor(material).look(angle, white, sky_samples);
}

// KHR_materials_iridescence: the lobe's integral times the film's Fresnel term for the view
// direction, plus the dielectric below with the remaining light.
TEST(Furnace, OfFilmsIsTheLobeTimesTheirFresnelTerm) {
  for (const double metallic : {0.0, 1.0}) {
    for (const float thickness : {150.0f, 400.0f, 800.0f}) {
      const Reflector r{{0.9, 0.7, 0.5}, metallic, 0.5};
      Material m = material_of(r);
      m.film.factor = 1.0f;
      m.film.thickness_max_nm = thickness;
      for (const double angle : angles) {
        const SeenPoint at = seen_at(angle);
        const double lobe = over_hemisphere(
            at, 120, [&](glm::dvec3 l) { return ggx_reference(r.roughness, at, l); });
        const SurfaceThinFilm film{1.0f, m.film.ior, thickness};
        const auto cosine = static_cast<float>(std::cos(angle));
        const glm::dvec3 of_metal(thin_film_fresnel(film, glm::vec3(r.base), cosine));
        const glm::dvec3 of_dielectric(thin_film_fresnel(film, glm::vec3(0.04f), cosine));
        const double most = std::max({of_dielectric.x, of_dielectric.y, of_dielectric.z});
        const glm::dvec3 expected =
            metallic > 0.0 ? lobe * of_metal : lobe * of_dielectric + (1.0 - most) * r.base;
        const glm::vec3 found = seen_of(m, angle);
        for (int c = 0; c < 3; ++c) {
          EXPECT_NEAR(found[c], expected[c], 1e-2) << angle << ' ' << thickness << ' ' << metallic;
          EXPECT_LE(found[c], 1.0f + 5e-3f);
        }
      }
    }
  }
}

// KHR_materials_diffuse_transmission: a fraction of the diffuse part comes from the other side.
// Under a uniform white sky that fraction is as bright, in its own colour.
TEST(Furnace, OfDiffuseTransmissionIsThatOfAnOpaqueSurface) {
  for (const double share : {0.25, 1.0}) {
    const Reflector r{{0.8, 0.4, 0.2}, 0.0, 0.6};
    const glm::dvec3 through(0.1, 0.9, 0.5);
    Material m = material_of(r);
    m.diffuse_transmission.factor = static_cast<float>(share);
    m.diffuse_transmission.color = glm::vec3(through);
    for (const double angle : angles) {
      const SeenPoint at = seen_at(angle);
      Reflector mixed = r;
      mixed.base = glm::mix(r.base, through, share);
      const LayersSeen none(r, at);
      const glm::dvec3 expected =
          over_hemisphere(at, 120, [&](glm::dvec3 l) { return gltf_brdf(mixed, at, none, l); });
      const glm::vec3 found = seen_of(m, angle);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1e-2) << angle << ' ' << share;
    }
  }
}

// Appendix B: mix(dielectric, metal, metallic); KHR_materials_transmission changes the dielectric.
// A uniform sky is reflected in closed form, without samples.
TEST(Furnace, OfHalfMetalsIsTheMixOfBoth) {
  const Sky white(glm::vec3(1.0f));
  const auto seen = [&](double metallic, double roughness, float transmission, double angle) {
    Material m = material_of({{0.9, 0.7, 0.5}, metallic, roughness});
    m.transmission = transmission;
    return SeenFloor(m).look(angle, white);
  };
  for (const float transmission : {0.0f, 0.5f}) {
    for (const double roughness : {0.0, 0.3, 0.7}) {
      for (const double angle : angles) {
        const glm::vec3 dielectric = seen(0.0, roughness, transmission, angle);
        const glm::vec3 metal = seen(1.0, roughness, transmission, angle);
        for (const double metallic : {0.25, 0.6}) {
          const glm::vec3 found = seen(metallic, roughness, transmission, angle);
          const glm::vec3 mix = glm::mix(dielectric, metal, static_cast<float>(metallic));
          for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c], mix[c], 1e-5) << metallic << ' ' << roughness << ' ' << angle;
        }
      }
    }
  }
}

}  // namespace
}  // namespace asos::test::furnace_test
