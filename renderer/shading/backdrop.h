#pragma once

#include "renderer/geometry/view.h"
#include "renderer/settings/background.h"
#include "renderer/shading/footprint.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos {

class Sky;

/// The background of a picture, as its camera sees it.
class Backdrop {
 public:
  /// The environment.
  Backdrop() = default;
  Backdrop(const Background& chosen, const View& view);

  /// Linear radiance along an eye ray that meets nothing, averaged over a square of `side` pixels
  /// where there is a `spacing`; a null sky is the neutral one. Colours are a linear function of
  /// the place, whose mean over a square is that of its middle.
  [[nodiscard]] glm::vec3 radiance(const Sky* sky, const Ray& ray, const PixelSpacing* spacing,
                                   float side) const;
  /// The same, where it is one for all rays.
  [[nodiscard]] std::optional<glm::vec3> everywhere(const Sky* sky) const;

  [[nodiscard]] PixelContent content() const { return chosen_.content; }
  [[nodiscard]] bool shows_light() const { return chosen_.content == PixelContent::light; }

 private:
  Background chosen_;
  std::optional<Frame> picture_;  // of a gradient
  glm::vec3 right_{0.0f};  // the square of directions that is blurred over, along the picture
  glm::vec3 down_{0.0f};
};

}  // namespace asos
