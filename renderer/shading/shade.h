#pragma once

#include "renderer/film/statistics.h"
#include "renderer/geometry/ray.h"
#include "renderer/lights/lighting.h"
#include "renderer/lights/lights_without_geometry.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/shading/backdrop.h"
#include "renderer/shading/layers.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shading/surface.h"
#include "renderer/shading/volume_boundary.h"
#include "renderer/world/needs.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <vector>

namespace asos {

class Sky;

/// Opacity of a triangle's material at a point (base colour alpha times texture times vertex
/// colour, times what transmission leaves), 0 to 1; the RayScene's alpha test. A masked material's
/// is the value that its cut-off is compared with.
[[nodiscard]] float alpha_at(const World& world, std::uint32_t triangle, float b1, float b2);

/// The same without transmission, and with a masked material's cut-off applied: 0 or 1.
[[nodiscard]] float opacity_at(const World& world, std::uint32_t triangle, float b1, float b2);

/// What the light that goes straight through a blended surface becomes: its opacity lets the rest
/// pass, and of that which meets it the layers' and Fresnel's terms leave the transmitted share,
/// tinted by the base colour; at a volume's boundary, too, which bends nothing here. The RayScene's
/// PassageAt.
[[nodiscard]] StraightPassage passage_at(const World& world, const Hit& hit, glm::vec3 direction);

/// The choice of what is shaded and what is left out.
struct ShadingSettings {
  bool shadows = true;       ///< lights cast shadows
  bool sky_shadows = false;  ///< and so does the sky; else it is open
  bool bounces = false;      ///< what hides the sky sends light instead; only with sky_shadows
  LightRule light_rule = LightRule::physical;
  Culling faces = Culling::none;  ///< which surfaces lie behind blended ones
  /// The mip chains by which textures, and highlights on surfaces that turn, are averaged over the
  /// extent that a sample stands for; null: every sample is a point.
  const MipChains* mips = nullptr;
  PixelSpacing spacing;                ///< of the picture; only with mips
  const Sky* sky = nullptr;            ///< the surroundings of the world; null: the neutral one
  int reflections = 0;                 ///< bounces that are followed
  float roughest_mirror = 0.35f;       ///< see RenderSettings
  const Dfr* dfr = nullptr;            ///< of all that mirrors; null: of each material its own
  const MaterialDfrs* dfrs = nullptr;  ///< the materials' own; null: none has any
  /// Display intensity by which a pixel's middle may differ from its mean before lights are summed
  /// up over its patch; 1: never.
  float bend = 1.0f;
  Backdrop backdrop{};  ///< what eye rays see behind all surfaces
};

/// Samples the light that a scene sends along rays: every method shades through this one class.
/// Keeps references and copies nothing; thread-safe.
class Shader {
 public:
  Shader(const World& world, const SceneNeeds& needs, const RayScene& rays,
         const Lighting& lighting, ShadingSettings settings = {});

  /// Linear radiance arriving along a ray. Blended surfaces are composited in depth order. Lights
  /// that cast shadows, and reflections, go by way of `transport`. Counts the rays that go on
  /// behind a blended surface. Results that are not finite are returned as they are; the caller
  /// drops and counts them. Where the backdrop holds coverage: what share of the ray surfaces hide,
  /// by colour; a volume's boundary and frosted glass hide all where they are followed, for what is
  /// seen in them is the environment. Where it holds what is unlit: the share of unlit layers or
  /// their colour. What is seen in mirrors and in such glass is light, unlit surfaces included.
  /// Behind LayerCount::most surfaces the rest is dropped, and counted where it may be seen.
  [[nodiscard]] glm::vec3 radiance(const ViewedRay& seen, LightTransport& transport,
                                   RenderStatistics& counts) const;
  /// Along an eye ray.
  [[nodiscard]] glm::vec3 radiance(const Ray& ray, const Hit& hit, float side,
                                   LightTransport& transport, RenderStatistics& counts) const;

  /// The surfaces along a ray that let light straight through, in depth order, and the one behind
  /// them, as far as anything of it is seen. Counts the rays that go on.
  [[nodiscard]] std::vector<SeenLayer> layers(const ViewedRay& seen,
                                              RenderStatistics& counts) const;

  /// An eye ray whose nearest hit is `hit`, for the square of `side` pixels that it stands for.
  [[nodiscard]] ViewedRay eye_ray(const Ray& ray, const Hit& hit, float side) const;

  /// A pixel's steps in the picture.
  [[nodiscard]] const PixelSpacing& spacing() const { return settings_.spacing; }
  [[nodiscard]] int reflections() const { return settings_.reflections; }
  [[nodiscard]] const ShadingSettings& settings() const { return settings_; }
  /// Lights that reflections show although no surface of the scene does, by index into lights().
  [[nodiscard]] std::span<const std::uint32_t> lights_without_geometry() const {
    return lighting_.lights_without_geometry;
  }
  /// The first of them on a ray, if any, whatever else lies on it.
  [[nodiscard]] std::optional<LightHit> nearest_light_without_geometry(const Ray& ray) const;
  /// By how much the surface blurs what it mirrors, as Reflection::width; nothing where it is not
  /// followed.
  [[nodiscard]] std::optional<glm::vec3> mirror_width(const ViewedRay& seen,
                                                      const SurfacePoint& point, float roughness,
                                                      glm::vec3 reflected) const;

  /// What the reflection of a material shows of lights. Those of a lobe are its highlights, which
  /// are summed up over the light, down to roughness_floor. By a defocusing ratio, and by the
  /// published rule, highlights are the mirrored lights (CGF'98 section 5.1).
  [[nodiscard]] MirroredLights mirrored_lights(std::uint32_t triangle, float roughness) const;

  /// Whether a ray shows what a surface emits; `hides_lights` is ViewedRay's.
  [[nodiscard]] bool shows_emission(bool hides_lights, std::uint32_t triangle) const {
    return !(hides_lights && lighting_.shows_even_light[world_.triangle_part[triangle]] != 0);
  }

  /// Hands what the nearest surface on a ray mirrors to `transport`, where it is followed.
  [[nodiscard]] bool reflect(const ViewedRay& seen, const SurfacePoint& point,
                             const ViewedMaterial& material, LightTransport& transport,
                             glm::vec3& radiance, RenderStatistics& counts) const {
    return add_mirrored(seen, point, material, {glm::vec3(1.0f), 0, seen.hit, seen.passage},
                        transport, radiance, counts);
  }
  /// Whether what such a surface mirrors is what its lobe shows, and not the mean over a square of
  /// directions, as a defocusing ratio makes it (CGF'98 section 5.1).
  [[nodiscard]] bool mirrors_by_lobe(std::uint32_t triangle, float roughness) const;

  /// The scene's, by the rule of the settings.
  [[nodiscard]] std::span<const PreparedLight> lights() const { return lights_; }

 private:
  /// What surfaces on a ray send along it, and how much of the backdrop is seen behind them.
  struct Layers {
    glm::vec3 radiance{0.0f};
    glm::vec3 behind{0.0f};
  };
  /// The colour of an unlit layer where it is opaque; 1 where pixels hold the share of unlit
  /// surfaces.
  [[nodiscard]] glm::vec3 unlit_colour(const SurfaceMaterial& material) const;
  [[nodiscard]] Layers look_along(const ViewedRay& seen, const SampleExtent& extent,
                                  LightTransport& transport, RenderStatistics& counts) const;
  /// A layer that a ray meets: its share of the ray's radiance, and how many lie before it.
  struct Layer {
    glm::vec3 share{1.0f};
    int number = 0;
    Hit hit;
    VolumePath passage;  ///< of what it reflects
    const VolumeBoundary* boundary = nullptr;
  };
  /// All that a material shows: what it emits and reflects, layer by layer. Returns the share of
  /// what lies below its layers that they let through; a volume's boundary is one of them.
  float add_material(const ViewedRay& seen, const SurfacePoint& point,
                     const SurfaceMaterial& material, const Layer& layer, const MipChains* mips,
                     LightTransport& transport, glm::vec3& radiance,
                     RenderStatistics& counts) const;
  void add_lit(const ViewedRay& seen, const ViewedPoint& point, const ViewedMaterial& material,
               const Layer& layer, LightTransport& transport, glm::vec3& radiance,
               RenderStatistics& counts) const;
  [[nodiscard]] bool add_mirrored(const ViewedRay& seen, const SurfacePoint& point,
                                  const ViewedMaterial& material, const Layer& layer,
                                  LightTransport& transport, glm::vec3& radiance,
                                  RenderStatistics& counts) const;
  /// Hands what shines through a volume's boundary, or blurred through a rough thin wall, to
  /// `transport`, where it is followed; `through` is its share of the ray's radiance. Returns what
  /// is left of that. A thin wall's lobe is the mirrored one, on its other side
  /// (KHR_materials_transmission, "Transmission BTDF").
  [[nodiscard]] glm::vec3 add_refracted(const ViewedRay& seen, const SurfacePoint& point,
                                        float roughness, const Layer& layer, glm::vec3 through,
                                        LightTransport& transport, glm::vec3& radiance,
                                        RenderStatistics& counts) const;
  [[nodiscard]] bool follows(const ViewedRay& seen, glm::vec3 share) const;
  [[nodiscard]] const Dfr* own_dfr(std::uint32_t triangle) const;

  const World& world_;
  const SceneNeeds& needs_;
  const RayScene& rays_;
  const Lighting& lighting_;
  ShadingSettings settings_;
  std::span<const PreparedLight> lights_;
  bool sums_patches_ = false;  // some light is summed up over a patch
};

}  // namespace asos
