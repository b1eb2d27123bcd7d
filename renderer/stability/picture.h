#pragma once

#include "renderer/film/film.h"
#include "renderer/film/statistics.h"
#include "renderer/result.h"
#include "renderer/scene/scene.h"
#include "renderer/settings/settings.h"
#include "renderer/stability/case.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <string>

namespace asos::stability {

/// The pixels along each side of most cases' pictures, and of those of materials and textures.
inline constexpr int picture_side = 16;
inline constexpr int small_side = 8;

/// A picture of a scene by its first camera, with its statistics.
struct Picture {
  Film film;
  RenderStatistics statistics;
  std::uint64_t bad_pixels = 0;  ///< pixels whose radiance is not finite

  [[nodiscard]] double at(int x, int y) const;  ///< red
};

/// Settings for ASOS with EPS 0, so that only MAX decides, and one worker.
[[nodiscard]] RenderSettings settings_of(int width, int height, int max_level = 3);

/// A deliberate error in the next picture that a thread renders, with which tests check that a case
/// fails: a factor of all lights, or a shift of everything in pixels.
struct InjectedError {
  double light = 1.0;
  glm::dvec2 pixels{0.0};  ///< x to the right, y down
};
/// Injects an error into the first picture that this thread renders while the object lives.
class ErrorInjection {
 public:
  explicit ErrorInjection(const InjectedError& disturbance);
  ErrorInjection(const ErrorInjection&) = delete;
  ErrorInjection& operator=(const ErrorInjection&) = delete;
  ~ErrorInjection();
};

/// Renders the scene by its first camera, which it must have. Invalid settings are an error.
[[nodiscard]] Result<Picture> render(const Scene& scene, const RenderSettings& settings);

/// The description of a case's quantity, before it is measured.
struct Measure {
  std::string quantity;
  double bound = 0.0;
  std::string reason;
};

/// Returns the pixel whose red differs most from `expected`.
[[nodiscard]] Result<Outcome> worst_pixel(const Measure& measure, const Result<Picture>& picture,
                                          const std::function<double(int x, int y)>& expected);
/// Returns the outcome at the pixel where two pictures of the same size differ most.
[[nodiscard]] Result<Outcome> worst_difference(const Measure& measure,
                                               const Result<Picture>& expected,
                                               const Result<Picture>& picture);
/// Returns one number, measured in a picture.
[[nodiscard]] Result<Outcome> one_value(const Measure& measure, double expected,
                                        const Result<Picture>& picture,
                                        const std::function<double(const Picture&)>& value);
/// Returns a number that needs no picture.
[[nodiscard]] Outcome plain_value(const Measure& measure, double expected, double got);

}  // namespace asos::stability
