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

/// A picture of a scene by its first camera, and what was met on the way.
struct Picture {
  Film film;
  RenderStatistics statistics;
  std::uint64_t bad_pixels = 0;  ///< whose radiance is not finite

  [[nodiscard]] double at(int x, int y) const;  ///< red
};

/// ASOS with EPS 0, so that MAX alone decides, and one worker.
[[nodiscard]] RenderSettings settings_of(int width, int height, int max_level = 3);

/// What is wrong on purpose with the next picture that a thread renders, of which tests see whether
/// a case notices: all lights this much brighter, or everything moved by so many pixels.
struct Disturbance {
  double light = 1.0;
  glm::dvec2 pixels{0.0};  ///< x to the right, y down
};
/// For the first picture that is rendered on this thread in the lifetime of this.
class Disturbed {
 public:
  explicit Disturbed(const Disturbance& disturbance);
  Disturbed(const Disturbed&) = delete;
  Disturbed& operator=(const Disturbed&) = delete;
  ~Disturbed();
};

/// Renders the scene by its first camera, which it must have. Refused settings are an error.
[[nodiscard]] Result<Picture> render(const Scene& scene, const RenderSettings& settings);

/// The description of a case's figure, before it is measured.
struct Measure {
  std::string quantity;
  double bound = 0.0;
  std::string reason;
};

/// The pixel whose red is farthest from what `expected` says of it.
[[nodiscard]] Result<Outcome> worst_pixel(const Measure& measure, const Result<Picture>& picture,
                                          const std::function<double(int x, int y)>& expected);
/// The pixel of which two pictures of one size say most differently.
[[nodiscard]] Result<Outcome> worst_difference(const Measure& measure,
                                               const Result<Picture>& expected,
                                               const Result<Picture>& picture);
/// One number of a picture.
[[nodiscard]] Result<Outcome> one_value(const Measure& measure, double expected,
                                        const Result<Picture>& picture,
                                        const std::function<double(const Picture&)>& value);
/// A number that no picture is needed for.
[[nodiscard]] Outcome plain_value(const Measure& measure, double expected, double got);

}  // namespace asos::stability
