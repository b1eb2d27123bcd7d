#pragma once

#include "renderer/geometry/view.h"
#include "renderer/settings/background.h"
#include "renderer/shading/footprint.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos {

class Sky;

/// The background of a picture behind all surfaces.
class BackgroundRadiance {
 public:
  /// Uses the environment as background.
  BackgroundRadiance() = default;
  BackgroundRadiance(const Background& chosen, const View& view);

  /// Returns the linear radiance along an eye ray that hits nothing. With a `spacing` it is
  /// averaged over a square of `side` pixels. A null sky is the neutral one. Colour backgrounds are
  /// linear in the place, so their mean over a square is the value at its centre.
  [[nodiscard]] glm::vec3 radiance(const Sky* sky, const Ray& ray, const PixelSpacing* spacing,
                                   float side) const;
  /// Returns the radiance if it is the same for all rays.
  [[nodiscard]] std::optional<glm::vec3> everywhere(const Sky* sky) const;

  [[nodiscard]] PixelContent content() const { return chosen_.content; }
  [[nodiscard]] bool shows_light() const { return chosen_.content == PixelContent::light; }

 private:
  Background chosen_;
  std::optional<Frame> picture_;  // of a gradient
  glm::vec3 right_{0.0f};         // edges of the square of directions for the blur
  glm::vec3 down_{0.0f};
};

}  // namespace asos
