#pragma once

#include "renderer/film/statistics.h"
#include "renderer/geometry/ray.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/scene/needs.h"
#include "renderer/scene/world.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace asos {

/// Opacity of a triangle's material at a point (base colour alpha times texture times vertex
/// colour, times what transmission leaves), 0 to 1; the RayScene's alpha test. A masked material's
/// is the value that its cut-off is compared with.
[[nodiscard]] float alpha_at(const World& world, std::uint32_t triangle, float b1, float b2);

/// What is shaded and what is left out.
struct ShadingSettings {
  bool shadows = true;  ///< lights cast shadows
  LightRule light_rule = LightRule::physical;
  Faces faces = Faces::all;  ///< which surfaces lie behind blended ones
  /// What textures, and highlights on surfaces that turn, are averaged with over what a sample
  /// stands for; null: every sample is a point.
  const MipChains* mips = nullptr;
  PixelSpacing spacing;                   ///< of the picture; only with mips
  const LightCuts* light_cuts = nullptr;  ///< of the world; null, or a list that is missing: none
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
  /// Blended surfaces are composited in depth order. Lights that cast shadows go by way of
  /// `transport`. Counts the eye rays that go on behind a blended surface. Results that are not
  /// finite are returned as they are; the caller drops and counts them.
  [[nodiscard]] glm::vec3 radiance(const Ray& ray, const Hit& hit, float side,
                                   LightTransport& transport, RenderStatistics& counts) const;

  [[nodiscard]] std::span<const PreparedLight> lights() const { return lights_; }

 private:
  /// A layer that a ray meets: its share of the ray's radiance, and how many lie before it.
  struct Layer {
    glm::vec3 share{1.0f};
    int number = 0;
  };
  void add_reflected(const SurfacePoint& point, const SurfaceMaterial& material,
                     glm::vec3 to_viewer, const Layer& layer, LightTransport& transport,
                     glm::vec3& radiance, RenderStatistics& counts) const;

  const World& world_;
  const SceneNeeds& needs_;
  const RayScene& rays_;
  ShadingSettings settings_;
  std::vector<PreparedLight> lights_;
};

}  // namespace asos
