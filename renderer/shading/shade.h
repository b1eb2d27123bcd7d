#pragma once

#include "renderer/film/statistics.h"
#include "renderer/geometry/ray.h"
#include "renderer/lights/lighting.h"
#include "renderer/lights/lights_without_geometry.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/shading/background_radiance.h"
#include "renderer/shading/layers.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shading/surface.h"
#include "renderer/shading/volume_boundary.h"
#include "renderer/world/render_features.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <vector>

namespace asos {

class Sky;

/// Returns the opacity of a triangle's material at a point, 0 to 1: the base colour's alpha times
/// texture, vertex colour and (1 - transmission). It is the RayScene's alpha test. For a masked
/// material it is the value that is compared with the cut-off.
[[nodiscard]] float alpha_at(const World& world, std::uint32_t triangle, float b1, float b2);

/// Returns the opacity without transmission; for a masked material 0 or 1, by its cut-off.
[[nodiscard]] float opacity_at(const World& world, std::uint32_t triangle, float b1, float b2);

/// Returns the transmittance of a blended surface without deflection; it is the RayScene's
/// TransmissionAt. It has two parts: the fraction that the opacity leaves, and the transmitted
/// fraction after layers and Fresnel's term, tinted by the base colour. A volume's boundary does
/// not deflect here, either.
[[nodiscard]] StraightTransmission passage_at(const World& world, const Hit& hit,
                                              glm::vec3 direction);

/// Selects what shading includes.
struct ShadingSettings {
  bool shadows = true;       ///< lights cast shadows
  bool sky_shadows = false;  ///< surfaces shadow the sky, too
  /// Occluders of the sky contribute bounced light; only with sky_shadows.
  bool bounces = false;
  LightRule light_rule = LightRule::physical;
  Culling faces = Culling::none;  ///< which surfaces are visible behind blended ones
  /// The mip chains for averaging textures and highlights over a sample's extent; null: every
  /// sample is a point.
  const MipChains* mips = nullptr;
  PixelSpacing spacing;                ///< of the picture; used only with mips
  const Sky* sky = nullptr;            ///< the surroundings of the world; null: the neutral one
  int reflections = 0;                 ///< largest number of bounces
  float roughest_mirror = 0.35f;       ///< see RenderSettings
  const Dfr* dfr = nullptr;            ///< for all reflections; null: each material's own
  const MaterialDfrs* dfrs = nullptr;  ///< the materials' own; null: there are none
  /// Display intensity by which a pixel's centre may differ from its mean before lights are
  /// integrated over its patch; 1: never.
  float bend = 1.0f;
  BackgroundRadiance backdrop{};  ///< background of eye rays behind all surfaces
};

/// Computes the radiance of a scene along rays; every method shades with this class. It stores
/// references only; thread-safe.
class Shader {
 public:
  Shader(const World& world, const RenderFeatures& render_features, const RayScene& rays,
         const Lighting& lighting, ShadingSettings settings = {});

  /// Returns the linear radiance that arrives along a ray. Blended surfaces are composited in depth
  /// order. `transport` computes reflections and the lights that cast shadows. Rays that continue
  /// behind a blended surface are counted. Results that are not finite are returned unchanged; the
  /// caller drops and counts them.
  /// Some backgrounds request another value than radiance:
  /// - Coverage: the fraction of the ray that surfaces hide, by colour. Volume boundaries and
  /// frosted glass have full coverage where they are followed, since they contain the environment.
  /// - Unlit surfaces: the fraction of unlit layers, or their colour. Reflections and followed
  /// glass count as lit, even those of unlit surfaces.
  /// Behind LayerCount::most surfaces the rest is dropped, and counted if it may be visible.
  [[nodiscard]] glm::vec3 radiance(const ViewedRay& seen, LightTransport& transport,
                                   RenderStatistics& counts) const;
  /// Returns the radiance along an eye ray.
  [[nodiscard]] glm::vec3 radiance(const Ray& ray, const Hit& hit, float side,
                                   LightTransport& transport, RenderStatistics& counts) const;

  /// Returns the transparent surfaces along a ray, in depth order, and the surface behind them, as
  /// long as they are visible. Counts the rays that continue.
  [[nodiscard]] std::vector<SurfaceLayer> layers(const ViewedRay& seen,
                                                 RenderStatistics& counts) const;

  /// Returns the surfaces along a ray with the part of it that each of them covers: their sum is
  /// the coverage, the mean of its colours. Surfaces of opacity 0 are left out. Only for a
  /// background that requests coverage.
  [[nodiscard]] CoveredRay covered(const ViewedRay& seen, RenderStatistics& counts) const;

  /// Returns the eye ray with the nearest hit `hit`, for a square of `side` pixels.
  [[nodiscard]] ViewedRay eye_ray(const Ray& ray, const Hit& hit, float side) const;

  [[nodiscard]] const PixelSpacing& spacing() const { return settings_.spacing; }
  [[nodiscard]] int reflections() const { return settings_.reflections; }
  [[nodiscard]] const ShadingSettings& settings() const { return settings_; }
  /// Returns the lights that are visible in reflections without a surface in the scene, by index
  /// into lights().
  [[nodiscard]] std::span<const std::uint32_t> lights_without_geometry() const {
    return lighting_.lights_without_geometry;
  }
  /// Returns the nearest light without geometry along a ray, if any, ignoring all surfaces.
  [[nodiscard]] std::optional<LightHit> nearest_light_without_geometry(const Ray& ray) const;
  /// Returns the blur width of a surface's reflection, as Reflection::width; nothing if the
  /// reflection is not followed.
  [[nodiscard]] std::optional<glm::vec3> mirror_width(const ViewedRay& seen,
                                                      const SurfacePoint& point, float roughness,
                                                      glm::vec3 reflected) const;

  /// Returns the lights that a material's reflection contains. Lights in a GGX lobe are its
  /// highlights, integrated over the light, down to roughness_floor. With a defocusing ratio, or by
  /// the published rule, the reflection contains the lights themselves (CGF'98 section 5.1).
  [[nodiscard]] MirroredLights mirrored_lights(std::uint32_t triangle, float roughness) const;

  /// Returns whether a surface's emission is visible to a ray; `hides_lights` is that of ViewedRay.
  [[nodiscard]] bool shows_emission(bool hides_lights, std::uint32_t triangle) const {
    return !(hides_lights && lighting_.shows_even_light[world_.triangle_part[triangle]] != 0);
  }

  /// A surface along a ray, with its weight in the ray's radiance and the number of surfaces in
  /// front of it.
  struct Layer {
    glm::vec3 share{1.0f};
    int number = 0;
    Hit hit;
    VolumePath passage;  ///< the volumes at the start of its reflections
    const VolumeBoundary* boundary = nullptr;
  };
  /// Passes a surface's reflection to `transport`, if it is followed. An anisotropic lobe is not
  /// followed if its rougher direction is too rough for a mirror.
  [[nodiscard]] bool reflect(const ViewedRay& seen, const SurfacePoint& point,
                             const ViewedMaterial& material, const Layer& layer,
                             LightTransport& transport, glm::vec3& radiance,
                             RenderStatistics& counts) const;
  /// Passes the refraction at a volume's boundary, or the transmission of a rough thin wall, to
  /// `transport`, if it is followed. `through` is its weight in the ray's radiance. Returns the
  /// weight that is left. A thin wall's lobe is the mirrored one on its other side
  /// (KHR_materials_transmission, "Transmission BTDF").
  [[nodiscard]] glm::vec3 add_refracted(const ViewedRay& seen, const SurfacePoint& point,
                                        float roughness, const Layer& layer, glm::vec3 through,
                                        LightTransport& transport, glm::vec3& radiance,
                                        RenderStatistics& counts) const;
  /// Returns whether the reflection is blurred by the GGX lobe. A defocusing ratio uses a square of
  /// directions instead (CGF'98 section 5.1).
  [[nodiscard]] bool mirrors_by_lobe(std::uint32_t triangle, float roughness) const;

  /// Returns the scene's lights, by the rule of the settings.
  [[nodiscard]] std::span<const PreparedLight> lights() const { return lights_; }

 private:
  /// Radiance of the surfaces along a ray, and the weight of the background behind them.
  struct Layers {
    glm::vec3 radiance{0.0f};
    glm::vec3 behind{0.0f};
  };
  /// Returns the colour of an unlit layer where it is opaque; 1 where pixels contain the fraction
  /// of unlit surfaces.
  [[nodiscard]] glm::vec3 unlit_colour(const SurfaceMaterial& material) const;
  /// Adds the surfaces to `covers`, unless that is null.
  [[nodiscard]] Layers look_along(const ViewedRay& seen, const SampleExtent& extent,
                                  LightTransport& transport, RenderStatistics& counts,
                                  std::vector<SurfaceCover>* covers = nullptr) const;
  /// Adds the emission and reflection of a material, layer by layer. A volume's boundary is one of
  /// the layers. Returns the fraction of light that passes the layers.
  float add_material(const ViewedRay& seen, const SurfacePoint& point,
                     const SurfaceMaterial& material, const Layer& layer, const MipChains* mips,
                     LightTransport& transport, glm::vec3& radiance,
                     RenderStatistics& counts) const;
  void add_lit(const ViewedRay& seen, const ViewedPoint& point, const ViewedMaterial& material,
               const Layer& layer, LightTransport& transport, glm::vec3& radiance,
               RenderStatistics& counts) const;
  [[nodiscard]] bool follows(const ViewedRay& seen, glm::vec3 share) const;
  [[nodiscard]] const Dfr* own_dfr(std::uint32_t triangle) const;

  const World& world_;
  const RenderFeatures& needs_;
  const RayScene& rays_;
  const Lighting& lighting_;
  ShadingSettings settings_;
  std::span<const PreparedLight> lights_;
  bool sums_patches_ = false;  // some light is integrated over a patch
};

}  // namespace asos
