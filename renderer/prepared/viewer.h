#pragma once

#include "renderer/geometry/view.h"
#include "renderer/reflections/mirror_plane.h"
#include "renderer/reflections/ray_bundle.h"
#include "renderer/shading/shade.h"

#include <optional>

namespace asos {

/// Who looks at the scene: a camera, or a pyray that a surface has mirrored, whose picture has one
/// pixel. Keeps references.
struct Viewer {
  const View& view;
  const Shader& shader;
  PixelSpacing spacing;  ///< of the view
  float width = 0.0f;    ///< these four: see ViewedRay
  int bounces = 0;
  float throughput = 1.0f;
  bool hides_lights = false;
  std::optional<MirrorPlane> mirror = std::nullopt;  ///< that its rays leave, if it is flat
  VolumePath passage = {};                           ///< its rays', see ViewedRay
  std::optional<RayBundle> bundle = std::nullopt;    ///< that its picture stands for, if refracted
  float pixel = 1.0f;  ///< side of the square that a pixel is the mean of, in pixels

  /// Whether its rays may meet lights that no surface shows.
  [[nodiscard]] bool sees_bare_lights() const {
    return bounces > passage.refractions && !hides_lights &&
           !shader.lights_without_geometry().empty();
  }

  /// A camera whose picture is the shader's.
  [[nodiscard]] static Viewer camera(const View& view, const Shader& shader,
                                     double filter_width = 1.0) {
    const ViewedRay eye = shader.eye_ray({}, {}, 0.0f);
    Viewer viewer{view, shader, PixelSpacing::of(view), eye.width};
    viewer.pixel = static_cast<float>(filter_width);
    return viewer;
  }
  [[nodiscard]] ViewedRay viewed(const Ray& ray, const Hit& hit, float side,
                                 const PartShape& shape = square_part) const {
    return {ray,        hit,          side,  &spacing, width,  bounces,
            throughput, hides_lights, shape, false,    passage};
  }
};

}  // namespace asos
