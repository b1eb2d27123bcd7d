#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace asos {

struct Film;

/// The tone curve from radiance to display values. `none` clips at white. `neutral` is Khronos PBR
/// Neutral (2024): it keeps base colours, and compresses brighter values without a change of hue.
/// `agx` is Sobotka's AgX with Wrensch's approximation: a film-like curve, in which bright colours
/// fade towards white.
enum class ToneCurve : std::uint8_t { none, neutral, agx };

/// The display settings of a picture: exposure and tone curve. An exposure converts to it
/// implicitly.
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

/// Returns the displayed linear colour, 0 to 1, for `radiance`. Its luminance never falls if all
/// channels rise together (agx: except for less than a tenth of an 8-bit step near white, an error
/// of the approximation). `none` returns the exposed radiance unclipped. NaN becomes black.
[[nodiscard]] glm::vec3 tone_mapped(glm::vec3 radiance, const DisplayTransform& display);

/// Returns the displayed colour of a pixel with the unlit part `unlit` (FinishedTile::unlit), which
/// exposure and curve do not change. They are applied to the mean radiance of the lit part. The
/// result is weighted by that part's fraction of the pixel.
[[nodiscard]] glm::vec3 tone_mapped(glm::vec3 radiance, glm::vec4 unlit,
                                    const DisplayTransform& display);

/// Returns the displayed value without exposure, and clipped at white for any curve: the intensity
/// in which EPS and contrasts are measured.
[[nodiscard]] glm::dvec3 displayed_intensity(glm::dvec3 radiance, ToneCurve curve);

/// Returns the maximal slope of a curve for small differences of radiance, if the channels rise
/// together: a factor from errors in radiance to displayed errors. For `neutral` the slope is 2 if
/// only the smallest channel rises, since the curve subtracts the same amount from each channel.
[[nodiscard]] constexpr double steepness(ToneCurve curve) {
  return curve == ToneCurve::agx ? 1.7 : 1.0;
}

/// Return display_rgb and display_bytes (film.h) for any curve.
[[nodiscard]] glm::vec3 display_rgb(glm::vec3 radiance, const DisplayTransform& display);
[[nodiscard]] glm::u8vec3 display_bytes(glm::vec3 radiance, const DisplayTransform& display);
/// Return the display colour of a film's pixel, which may show unlit surfaces.
[[nodiscard]] glm::vec3 display_rgb(const Film& film, std::size_t pixel,
                                    const DisplayTransform& display);
[[nodiscard]] glm::u8vec3 display_bytes(const Film& film, std::size_t pixel,
                                        const DisplayTransform& display);

}  // namespace asos
