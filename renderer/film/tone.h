#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace asos {

struct Film;

/// How radiance becomes what a screen can show. `none` clips at white. `neutral` is Khronos PBR
/// Neutral (2024): base colours come out as they are told, and what is brighter is compressed
/// without a change of hue. `agx` is Sobotka's AgX, after Wrensch's fit: film-like, with colours
/// that fade towards white.
enum class ToneCurve : std::uint8_t { none, neutral, agx };

/// How a picture is shown: what its bytes follow from. An exposure alone is one, too.
struct DisplayTransform {
  float exposure_ev;  ///< stops
  ToneCurve tone;

  DisplayTransform(float ev = 0.0f, ToneCurve curve = ToneCurve::none)
      : exposure_ev(ev), tone(curve) {}

  bool operator==(const DisplayTransform&) const = default;
};

struct NamedTone {
  ToneCurve value;
  const char* name;
};
inline constexpr std::array tone_names{NamedTone{ToneCurve::none, "none"},
                                       NamedTone{ToneCurve::neutral, "neutral"},
                                       NamedTone{ToneCurve::agx, "agx"}};

/// The linear colour, 0 to 1, that a screen shows for `radiance`. Its luminance never falls as all
/// channels rise together (agx: but for less than a tenth of an 8-bit step near white, which is the
/// fit's). With `none` it is the exposed radiance as it is. What is no number shows as black.
[[nodiscard]] glm::vec3 tone_mapped(glm::vec3 radiance, const DisplayTransform& display);

/// The same for a pixel with the unlit part `unlit` (FinishedTile::unlit). Exposure and curve leave
/// that part as it is. They map the mean radiance of the lit part, weighted by its share of the
/// pixel.
[[nodiscard]] glm::vec3 tone_mapped(glm::vec3 radiance, glm::vec4 unlit,
                                    const DisplayTransform& display);

/// The same without an exposure, and clipped at white whatever the curve: the intensity that EPS
/// and contrasts are differences of.
[[nodiscard]] glm::dvec3 displayed_intensity(glm::dvec3 radiance, ToneCurve curve);

/// By how much a curve makes a difference of radiance larger at most, where it is small and the
/// channels rise together: what is only known to be off by so much radiance may show as so much
/// more. Neutral takes as much from each where the least channel alone rises: 2 there.
[[nodiscard]] constexpr double steepness(ToneCurve curve) {
  return curve == ToneCurve::agx ? 1.7 : 1.0;
}

/// As `display_rgb` and `display_bytes` (film.h), by any curve.
[[nodiscard]] glm::vec3 display_rgb(glm::vec3 radiance, const DisplayTransform& display);
[[nodiscard]] glm::u8vec3 display_bytes(glm::vec3 radiance, const DisplayTransform& display);
/// The same of a pixel that may show unlit surfaces.
[[nodiscard]] glm::vec3 display_rgb(const Film& film, std::size_t pixel,
                                    const DisplayTransform& display);
[[nodiscard]] glm::u8vec3 display_bytes(const Film& film, std::size_t pixel,
                                        const DisplayTransform& display);

}  // namespace asos
