#pragma once

#include "renderer/geometry/view.h"
#include "renderer/shading/shade.h"

namespace asos {

/// Who looks at the scene: a camera, or a pyray that a surface has mirrored, whose picture has one
/// pixel. Keeps references.
struct Viewer {
  const View& view;
  const Shader& shader;
  PixelSpacing spacing;  ///< of the view
  float width = 0.0f;    ///< these three: see ViewedRay
  int bounces = 0;
  float throughput = 1.0f;

  /// A camera whose picture is the shader's.
  [[nodiscard]] static Viewer camera(const View& view, const Shader& shader) {
    const ViewedRay eye = shader.eye_ray({}, {}, 0.0f);
    return {view, shader, PixelSpacing::of(view), eye.width, 0, 1.0f};
  }
  [[nodiscard]] ViewedRay viewed(const Ray& ray, const Hit& hit, float side) const {
    return {ray, hit, side, &spacing, width, bounces, throughput};
  }
};

}  // namespace asos
