#include "renderer/shading/thin_film.h"

#include "renderer/shading/brdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

// KHR_materials_iridescence: reflectance of a thin film, against Airy's sum per wavelength.

namespace asos {
namespace {

/// Colour matching functions, CIE 1931 (Wyman, Sloan and Shirley 2013), by wavelength in nm.
glm::dvec3 sensitivities(double nm) {
  const auto lobe = [nm](double middle, double before, double after) {
    const double t = (nm - middle) / (nm < middle ? before : after);
    return std::exp(-0.5 * t * t);
  };
  return {1.056 * lobe(599.8, 37.9, 31.0) + 0.362 * lobe(442.0, 16.0, 26.7) -
              0.065 * lobe(501.1, 20.4, 26.2),
          0.821 * lobe(568.8, 46.9, 40.5) + 0.286 * lobe(530.9, 16.3, 31.1),
          1.217 * lobe(437.0, 11.8, 36.0) + 0.681 * lobe(459.0, 26.0, 13.8)};
}

double schlick(double f0, double cosine) {
  return f0 + (1.0 - f0) * std::pow(1.0 - cosine, 5.0);
}

/// The extension's functions ("Iridescence", evalSensitivity): Gaussians of the wave number. Their
/// transforms have the exponent -variance * phase^2, so `variance` is half of theirs.
glm::dvec3 gaussian_sensitivities(double nm) {
  const auto lobe = [nm](double value, double position, double variance) {
    const double off = 1e9 / nm - position;
    return value / std::numbers::sqrt2 * std::exp(-off * off / (4.0 * variance));
  };
  return {lobe(5.4856e-13, 1.6810e6, 4.3278e9) + lobe(9.7470e-14, 2.2399e6, 4.5282e9),
          lobe(4.4201e-13, 1.7953e6, 9.3046e9), lobe(5.2481e-13, 2.2084e6, 6.6121e9)};
}

struct FilmCase {
  double ior = 1.3, base_f0 = 0.04, nm = 120.0, cosine = 1.0;
};

/// Reflectance of a film over a grey base: sums all internal reflections per wavelength. The mean
/// over wavelengths is white, as in the extension; the deviation from it is weighted by the colour
/// matching functions.
template <typename Sensitivities>
glm::dvec3 airy(const FilmCase& film, Sensitivities eye, double white_per_step) {
  const double root = std::sqrt(film.base_f0), base_ior = (1.0 + root) / (1.0 - root);
  const double ior = film.ior;
  const double inner = std::sqrt(1.0 - (1.0 - film.cosine * film.cosine) / (ior * ior));
  const double r12 = std::sqrt(schlick(std::pow((ior - 1.0) / (ior + 1.0), 2.0), film.cosine));
  const double r23 = std::sqrt(schlick(std::pow((base_ior - ior) / (base_ior + ior), 2.0), inner)) *
                     (base_ior < ior ? 1.0 : -1.0);
  const auto reflectance = [&](double nm) {
    const double phase = 2.0 * std::numbers::pi * 2.0 * ior * film.nm * inner / nm;
    const std::complex<double> round = r23 * std::polar(1.0, phase);
    // The denser side reverses the phase: -r12 outside, r12 inside.
    return std::norm((-r12 + round) / (1.0 - r12 * round));
  };
  const double r2 = r12 * r12, s2 = r23 * r23;
  const double mean = r2 + (1.0 - r2) * (1.0 - r2) * s2 / (1.0 - r2 * s2);
  glm::dvec3 xyz(0.0), all(0.0);
  for (double nm = 250.0; nm < 1100.0; nm += 1.0) {
    // Integrates per wave number for the extension's functions.
    const double step = white_per_step > 0.0 ? 1e9 / (nm * nm) : 1.0;
    xyz += step * (reflectance(nm) - mean) * eye(nm);
    all += step * eye(nm);
  }
  xyz /= white_per_step > 0.0 ? glm::dvec3(white_per_step) : all;
  return glm::dvec3(mean) + glm::dvec3(3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
                                       -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
                                       0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z);
}

template <typename Expected>
void expect_all(Expected expected_of, double allowed) {
  for (const double ior : {1.3, 1.8}) {
    for (const double base_f0 : {0.04, 0.3}) {
      for (const double nm : {120.0, 250.0, 380.0, 520.0}) {
        for (const double cosine : {1.0, 0.7, 0.4}) {
          const SurfaceThinFilm film{1.0f, static_cast<float>(ior), static_cast<float>(nm)};
          const glm::vec3 found = thin_film_fresnel(film, glm::vec3(static_cast<float>(base_f0)),
                                                    static_cast<float>(cosine));
          const glm::dvec3 expected =
              glm::clamp(expected_of(FilmCase{ior, base_f0, nm, cosine}), 0.0, 1.0);
          for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c], expected[c], allowed)
                << ior << ' ' << base_f0 << ' ' << nm << ' ' << cosine << ' ' << c;
        }
      }
    }
  }
}

// Against the extension's functions; the difference comes from approximating the sum by two terms.
TEST(Film, ReflectsByAirysSumToTheExtensionsEye) {
  expect_all([](const FilmCase& film) { return airy(film, gaussian_sensitivities, 1.0685e-7); },
             1e-2);
}

// Against CIE 1931; the difference comes from the extension's four Gaussians.
TEST(Film, ReflectsByAirysSum) {
  expect_all([](const FilmCase& film) { return airy(film, sensitivities, 0.0); }, 0.04);
}

// At larger angles Schlick's term reflects something even between air and air.
TEST(Film, WithZeroThicknessIsTheBase) {
  for (const float cosine : {1.0f, 0.95f}) {
    const glm::vec3 found = thin_film_fresnel({1.0f, 1.8f, 0.0f}, {0.04f, 0.5f, 0.9f}, cosine);
    const glm::vec3 expected(schlick(0.04, cosine), schlick(0.5, cosine), schlick(0.9, cosine));
    EXPECT_LT(glm::distance(found, expected), 1e-3f) << cosine;
  }
}

// From any direction, film and base together reflect at most all light.
TEST(Film, NeverReturnsMoreThanItGets) {
  SurfaceMaterial m{.base_color = glm::vec3(1.0f), .dielectric_f0 = 0.04f};
  for (const float metallic : {0.0f, 1.0f}) {
    m.metallic = metallic;
    m.f0 = glm::vec3(metallic > 0.0f ? 1.0f : 0.04f);
    for (const float nm : {0.0f, 100.0f, 333.0f, 1000.0f, 1e6f}) {
      for (const float roughness : {0.0f, 0.3f, 1.0f}) {
        m.roughness = roughness;
        m.film = {1.0f, 1.7f, nm};
        for (float cosine = 0.002f; cosine <= 1.0f; cosine += 0.05f) {
          const ViewedMaterial seen = viewed(m, cosine);
          const glm::vec3 all = seen.ambient + seen.specular;
          EXPECT_LE(std::max({all.x, all.y, all.z}), 1.0f + 1e-5f);
          EXPECT_GE(std::min({seen.diffuse.x, seen.specular.x, seen.specular.z}), 0.0f);
        }
      }
    }
  }
}

TEST(Film, WithZeroFactorChangesNoBit) {
  SurfaceMaterial m{.base_color = {0.8f, 0.3f, 0.1f}, .roughness = 0.4f};
  const ViewedMaterial bare = viewed(m, 0.6f);
  m.film = {0.0f, 1.7f, 300.0f};
  const ViewedMaterial same = viewed(m, 0.6f);
  EXPECT_EQ(bare.lobe.f0, same.lobe.f0);
  EXPECT_EQ(bare.diffuse, same.diffuse);
  EXPECT_EQ(bare.specular, same.specular);
  m.film.factor = 0.5f;
  const ViewedMaterial half = viewed(m, 0.6f);
  m.film.factor = 1.0f;
  const ViewedMaterial whole = viewed(m, 0.6f);
  EXPECT_LT(glm::distance(half.lobe.f0, 0.5f * (bare.lobe.f0 + whole.lobe.f0)), 1e-6f);
}

}  // namespace
}  // namespace asos
