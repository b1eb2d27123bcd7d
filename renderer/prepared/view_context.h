#pragma once

#include "renderer/geometry/view.h"
#include "renderer/reflections/mirror_plane.h"
#include "renderer/reflections/ray_bundle.h"
#include "renderer/shading/shade.h"

#include <optional>

namespace asos {

/// The viewer of the scene: a camera, or a reflected pyray, whose picture has one pixel. Stores
/// references.
struct ViewContext {
  const View& view;
  const Shader& shader;
  PixelSpacing spacing;  ///< of the view
  float width = 0.0f;    ///< these four: see ViewedRay
  int bounces = 0;
  float throughput = 1.0f;
  bool hides_lights = false;
  /// The flat mirror that the viewer's rays leave, if any.
  std::optional<MirrorPlane> mirror = std::nullopt;
  VolumePath passage = {};  ///< of its rays, see ViewedRay
  /// The ray bundle that the camera's picture approximates, after a refraction.
  std::optional<RayBundle> bundle = std::nullopt;
  float pixel = 1.0f;  ///< side of the square over which a pixel is averaged, in pixels

  /// Returns whether the viewer's rays may hit lights that no surface shows.
  [[nodiscard]] bool sees_bare_lights() const {
    return bounces > passage.refractions && !hides_lights &&
           !shader.lights_without_geometry().empty();
  }

  /// Returns the viewer of a camera, for the shader's picture.
  [[nodiscard]] static ViewContext camera(const View& view, const Shader& shader,
                                          double filter_width = 1.0) {
    const ViewedRay eye = shader.eye_ray({}, {}, 0.0f);
    ViewContext viewer{view, shader, PixelSpacing::of(view), eye.width};
    viewer.pixel = static_cast<float>(filter_width);
    return viewer;
  }
  [[nodiscard]] ViewedRay viewed(const Ray& ray, const Hit& hit, float side,
                                 const FootprintShape& shape = square_part) const {
    return {ray,        hit,          side,  &spacing, width,  bounces,
            throughput, hides_lights, shape, false,    passage};
  }
};

}  // namespace asos
