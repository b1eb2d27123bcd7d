#include "renderer/shading/thin_film.h"

#include "renderer/shading/ggx.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

constexpr float pi_f = std::numbers::pi_v<float>;

template <typename T>
T squared(T x) {
  return x * x;
}

template <typename T>
T f0_between(T inner_ior, float outer_ior) {
  return squared((inner_ior - outer_ior) / (inner_ior + outer_ior));
}

glm::vec3 ior_of(glm::vec3 f0) {
  const glm::vec3 root = glm::sqrt(glm::clamp(f0, 0.0f, 0.9999f));
  return (1.0f + root) / (1.0f - root);
}

/// Returns the linear RGB of a spectrum that is a cosine of the wave number, with this optical path
/// difference and phases. It is the Fourier transform of the eye's sensitivities, as sums of
/// Gaussians.
glm::vec3 sensitivity(float path_nm, glm::vec3 shift) {
  constexpr glm::vec3 value(5.4856e-13f, 4.4201e-13f, 5.2481e-13f);
  constexpr glm::vec3 position(1.6810e6f, 1.7953e6f, 2.2084e6f);
  constexpr glm::vec3 variance(4.3278e9f, 9.3046e9f, 6.6121e9f);
  constexpr float second_value = 9.7470e-14f, second_position = 2.2399e6f,
                  second_variance = 4.5282e9f, all = 1.0685e-7f;
  const float phase = 2.0f * pi_f * path_nm * 1e-9f;
  glm::vec3 xyz = value * glm::sqrt(2.0f * pi_f * variance) * glm::cos(position * phase + shift) *
                  glm::exp(-squared(phase) * variance);
  xyz.x += second_value * std::sqrt(2.0f * pi_f * second_variance) *
           std::cos(second_position * phase + shift.x) *
           std::exp(-second_variance * squared(phase));
  xyz /= all;
  // Columns: XYZ to the primaries of Rec. 709.
  const glm::mat3 rgb_from_xyz(3.2404542f, -0.9692660f, 0.0556434f, -1.5371385f, 1.8760108f,
                               -0.2040259f, -0.4985314f, 0.0415560f, 1.0572252f);
  return rgb_from_xyz * xyz;
}

}  // namespace

glm::vec3 thin_film_fresnel(const SurfaceThinFilm& film, glm::vec3 base_f0, float cosine) {
  constexpr float air = 1.0f;
  // A film with vanishing thickness becomes air.
  constexpr float vanishing_nm = 0.03f;
  const float ior = glm::mix(air, film.ior, glm::smoothstep(0.0f, vanishing_nm, film.thickness_nm));
  const float inner_cosine2 = 1.0f - squared(air / ior) * (1.0f - squared(cosine));
  if (inner_cosine2 < 0.0f) return glm::vec3(1.0f);  // total reflection
  const float inner_cosine = std::sqrt(inner_cosine2);

  // Reflectance at the film's two sides. Reflection at the denser side turns the phase.
  const float r12 = schlick(f0_between(ior, air), 1.0f, schlick_weight(cosine));
  const float t121 = 1.0f - r12;
  const glm::vec3 base_ior = ior_of(base_f0);
  const glm::vec3 r23 =
      schlick(f0_between(base_ior, ior), glm::vec3(1.0f), schlick_weight(inner_cosine));
  const float phi21 = ior < air ? 0.0f : pi_f;
  const glm::vec3 phi23 =
      glm::mix(glm::vec3(0.0f), glm::vec3(pi_f), glm::lessThan(base_ior, glm::vec3(ior)));

  // The reflectance without interference, and then the term of each further round.
  const float path_nm = 2.0f * ior * film.thickness_nm * inner_cosine;
  const glm::vec3 phi = phi21 + phi23;
  const glm::vec3 r123_squared = glm::clamp(r12 * r23, 0.0f, 0.9999f);
  const glm::vec3 r123 = glm::sqrt(r123_squared);
  const glm::vec3 rs = squared(t121) * r23 / (1.0f - r123_squared);
  glm::vec3 reflected = r12 + rs;
  glm::vec3 amplitude = rs - t121;
  for (const float m : {1.0f, 2.0f}) {
    amplitude *= r123;
    reflected += amplitude * 2.0f * sensitivity(m * path_nm, m * phi);
  }
  return glm::clamp(reflected, 0.0f, 1.0f);
}

}  // namespace asos
