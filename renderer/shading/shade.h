#pragma once

#include "renderer/film/statistics.h"
#include "renderer/geometry/ray.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/scene/needs.h"
#include "renderer/scene/world.h"
#include "renderer/shading/light.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <vector>

namespace asos {

/// Opacity of a triangle's material at a point (base colour alpha times texture times vertex
/// colour, times what transmission leaves), 0 to 1; the RayScene's alpha test. A masked material's
/// is the value that its cut-off is compared with.
[[nodiscard]] float alpha_at(const World& world, std::uint32_t triangle, float b1, float b2);

/// What is shaded and what is left out.
struct ShadingSettings {
  bool shadows = true;  ///< lights cast shadows
  /// What textures, and highlights on surfaces that turn, are averaged with over what a sample
  /// stands for; null: every sample is a point.
  const MipChains* mips = nullptr;
  PixelSpacing spacing;  ///< of the picture; only with mips
};

/// Samples the light that a scene sends along rays: every method shades through this one class.
/// Keeps references; thread-safe. Making one prepares the lights: make one a block, not one a
/// sample.
class Shader {
 public:
  Shader(const World& world, const SceneNeeds& needs, const RayScene& rays,
         ShadingSettings settings = {});

  /// Surfaces that are composited along one ray before what lies behind them is dropped.
  static constexpr int max_layers = 64;

  /// Linear radiance arriving along `ray`, of unit direction, whose nearest hit is `hit` (invalid:
  /// the background). The sample stands for a square of `side` pixels around the ray, 0: a point.
  /// Blended surfaces are composited in depth order. Counts the rays it casts: those to lights, and
  /// eye rays that go on behind a blended surface. Results that are not finite (a light right on
  /// the surface) are returned as they are; the caller drops and counts them.
  [[nodiscard]] glm::vec3 radiance(const Ray& ray, const Hit& hit, float side,
                                   RenderStatistics& counts) const;

 private:
  [[nodiscard]] glm::vec3 reflected(const SurfacePoint& point, const SurfaceMaterial& material,
                                    glm::vec3 to_viewer, RenderStatistics& counts) const;
  [[nodiscard]] float visibility(const PreparedLight& light, const SurfacePoint& point,
                                 glm::vec3 direction, RenderStatistics& counts) const;

  const World& world_;
  const SceneNeeds& needs_;
  const RayScene& rays_;
  ShadingSettings settings_;
  std::vector<PreparedLight> lights_;
};

}  // namespace asos
