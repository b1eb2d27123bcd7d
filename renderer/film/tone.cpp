#include "renderer/film/tone.h"

#include "renderer/film/film.h"

#include <algorithm>
#include <cmath>

namespace asos {

namespace {

constexpr float most_radiance = 1e30f;  // prevents overflow in the tone curves

glm::vec3 made_finite(glm::vec3 radiance) {
  for (int k = 0; k < 3; ++k)
    radiance[k] = radiance[k] > 0.0f ? std::min(radiance[k], most_radiance) : 0.0f;
  return radiance;
}

// A smaller lit fraction of a pixel is invisible on any display.
constexpr float least_lit_share = 1e-5f;

// Khronos PBR Neutral Tone Mapper, specification 1.0.
glm::vec3 pbr_neutral(glm::vec3 colour) {
  constexpr float reflected = 0.04f;  // reflectance of a dielectric, which the curve subtracts
  constexpr float start = 0.8f - reflected, desaturation = 0.15f;
  const float least = std::min({colour.x, colour.y, colour.z});
  colour -= least < 2.0f * reflected ? least - least * least / (4.0f * reflected) : reflected;
  const float peak = std::max({colour.x, colour.y, colour.z});
  if (peak < start) return colour;
  constexpr float room = 1.0f - start;
  const float compressed = 1.0f - room * room / (peak + room - start);
  colour *= compressed / peak;
  const float faded = 1.0f - 1.0f / (desaturation * (peak - compressed) + 1.0f);
  return glm::mix(colour, glm::vec3(compressed), faded);
}

// Sobotka's contrast curve, approximated by a polynomial of degree 6 (Wrensch 2023).
float agx_contrast(float x) {
  const float x2 = x * x, x4 = x2 * x2;
  return 15.5f * x4 * x2 - 40.14f * x4 * x + 31.96f * x4 - 6.868f * x2 * x + 0.4298f * x2 +
         0.1191f * x - 0.00232f;
}

glm::vec3 agx(glm::vec3 colour) {
  const glm::mat3 inset(0.842479062253094f, 0.0423282422610123f, 0.0423756549057051f,
                        0.0784335999999992f, 0.878468636469772f, 0.0784336f, 0.0792237451477643f,
                        0.0791661274605434f, 0.879142973793104f);
  const glm::mat3 outset(1.19687900512017f, -0.0528968517574562f, -0.0529716355144438f,
                         -0.0980208811401368f, 1.15190312990417f, -0.0980434501171241f,
                         -0.0990297440797205f, -0.0989611768448433f, 1.15107367264116f);
  constexpr float darkest_ev = -12.47393f, brightest_ev = 4.026069f;
  glm::vec3 shown = inset * colour;
  for (int k = 0; k < 3; ++k) {
    const float ev = std::clamp(std::log2(std::max(shown[k], 1e-10f)), darkest_ev, brightest_ev);
    shown[k] = agx_contrast((ev - darkest_ev) / (brightest_ev - darkest_ev));
  }
  shown = glm::clamp(outset * shown, 0.0f, 1.0f);
  constexpr float screen_gamma = 2.2f;  // for which the approximation was made
  return glm::pow(shown, glm::vec3(screen_gamma));
}

}  // namespace

glm::vec3 tone_mapped(glm::vec3 radiance, const DisplayTransform& display) {
  const glm::vec3 exposed = radiance * std::exp2(display.exposure_ev);
  switch (display.tone) {
    case ToneCurve::neutral:
      return glm::clamp(pbr_neutral(made_finite(exposed)), 0.0f, 1.0f);
    case ToneCurve::agx:
      return agx(made_finite(exposed));
    case ToneCurve::none:
      break;
  }
  return exposed;
}

glm::vec3 tone_mapped(glm::vec3 radiance, glm::vec4 unlit, const DisplayTransform& display) {
  const float lit_share = 1.0f - unlit.w;
  if (lit_share >= 1.0f) return tone_mapped(radiance, display);
  const glm::vec3 as_it_is(unlit);
  if (!(lit_share > least_lit_share)) return as_it_is;
  const glm::vec3 lit = glm::max(radiance - as_it_is, 0.0f) / lit_share;
  return lit_share * tone_mapped(lit, display) + as_it_is;
}

glm::dvec3 displayed_intensity(glm::dvec3 radiance, ToneCurve curve) {
  if (curve == ToneCurve::none) return glm::clamp(radiance, 0.0, 1.0);
  return glm::dvec3(tone_mapped(glm::vec3(radiance), {0.0f, curve}));
}

glm::vec3 display_rgb(glm::vec3 radiance, const DisplayTransform& display) {
  return display_rgb(tone_mapped(radiance, display), 0.0f);
}

glm::u8vec3 display_bytes(glm::vec3 radiance, const DisplayTransform& display) {
  return display_bytes(tone_mapped(radiance, display), 0.0f);
}

namespace {

glm::vec3 tone_mapped_pixel(const Film& film, std::size_t pixel, const DisplayTransform& display) {
  return film.unlit.empty() ? tone_mapped(film.radiance[pixel], display)
                            : tone_mapped(film.radiance[pixel], film.unlit[pixel], display);
}

}  // namespace

glm::vec3 display_rgb(const Film& film, std::size_t pixel, const DisplayTransform& display) {
  return display_rgb(tone_mapped_pixel(film, pixel, display), 0.0f);
}

glm::u8vec3 display_bytes(const Film& film, std::size_t pixel, const DisplayTransform& display) {
  return display_bytes(tone_mapped_pixel(film, pixel, display), 0.0f);
}

}  // namespace asos
