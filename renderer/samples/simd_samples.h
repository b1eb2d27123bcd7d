#pragma once

#include "renderer/kernels/sky_kernel.h"
#include "renderer/kernels/surface_batch.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/prepared/view_context.h"
#include "renderer/samples/sampled_lights.h"
#include "renderer/samples/thread_local_cache.h"
#include "renderer/shading/simd_materials.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace asos {

/// The SIMD path for hits on opaque triangles with simple materials, shaded in batches: those of
/// the viewer's rays, or of rays that continue samples after reflections. Shader shades everything
/// else, one point at a time, with the same result up to rounding.
class SimdSamples {
 public:
  /// Both arguments have to outlive this.
  SimdSamples(const RenderScene& scene, const ViewContext& viewer);

  /// See SampleSums.
  void widen_colours(float times) { colours_ = times; }
  /// Adds the hit of the viewer's ray number `index` to the batch. Returns the reason if the hit
  /// needs Shader instead.
  [[nodiscard]] SamplePath add(std::size_t index, const Ray& ray, const Hit& hit, float side);
  /// Adds the hit of another ray, with the spacing of its own picture. All points of a batch are of
  /// the same kind.
  [[nodiscard]] SamplePath add_reflected(std::size_t index, const ViewedRay& seen);
  [[nodiscard]] std::size_t count() const { return arrays_ ? arrays_->hits.count : 0; }
  /// Returns the number of point i's ray.
  [[nodiscard]] std::size_t index(std::size_t i) const { return arrays_->index[i]; }
  void clear() {
    own_spacings_ = false;
    if (arrays_) arrays_->hits.count = arrays_->looked_up_count = 0;
  }

  /// Returns the radiance of rays without a hit, if it is the same for all.
  [[nodiscard]] const std::optional<glm::vec3>& background() const { return background_; }

  /// Computes the points. Returns false if any is not finite; then none is valid.
  [[nodiscard]] bool shade(ShadingPoints& points);

  // The following are for point i of the batch, after `shade`.

  /// Returns whether a reflection may be followed.
  [[nodiscard]] bool may_mirror(std::size_t i) const {
    return arrays_->bounces[i] < reflections_ &&
           (arrays_->materials.roughness[i] <= roughest_mirror_ || arrays_->material[i]->own_dfr);
  }
  /// Follows its reflection, as Shader::reflect does, and records that in `points`.
  [[nodiscard]] bool reflect(std::size_t i, const ViewedRay& seen, ShadingPoints& points,
                             LightTransport& transport, RenderStatistics& counts) const;
  /// Notes whether its reflection is followed, so that the sky contributes only diffusely.
  void set_mirrors(std::size_t i, bool mirrors) { arrays_->mirrors[i] = mirrors; }
  /// Computes the sky radiance that all points reflect. Requires set_mirrors for each point.
  void reflect_skies(const ShadingPoints& points);
  /// Returns its radiance without lights and reflections.
  [[nodiscard]] glm::vec3 unlit_radiance(std::size_t i, const ShadingPoints& points) const;
  /// Returns its own emission.
  [[nodiscard]] glm::vec3 emission(std::size_t i) const { return arrays_->emission[i]; }
  /// Adds a ray to the sky or its occluder through `transport`.
  void add_sky(std::size_t i, const ShadingPoints& points, LightTransport& transport,
               RenderStatistics& counts) const;

 private:
  [[nodiscard]] SamplePath add(std::size_t index, const Ray& ray, const Hit& hit, float side,
                               int bounces, bool hides_lights);
  /// Returns the emission that the point's ray includes.
  [[nodiscard]] glm::vec3 shown(std::size_t i, glm::vec3 emission) const;
  struct Arrays {
    TriangleBatch hits;
    SurfaceRest rest;
    MaterialBatch materials;
    SkyBatch sky;
    SpacingBatch spacing;  // only of reflected rays
    std::array<bool, ShadingPoints::size> mirrors;
    std::array<bool, ShadingPoints::size> hides_lights;
    std::array<int, ShadingPoints::size> bounces;
    std::array<glm::vec3, ShadingPoints::size> emission;
    std::array<const SimdMaterial*, ShadingPoints::size> material;
    std::array<Hit, ShadingPoints::size> hit;
    std::array<std::size_t, ShadingPoints::size> index;
    std::array<std::size_t, ShadingPoints::size> looked_up;  // points whose materials are looked up
    std::size_t looked_up_count = 0;
  };
  [[nodiscard]] ViewedMaterial viewed_material(std::size_t i, const ShadingPoints& points) const;
  [[nodiscard]] bool lobe_reflects_sky(std::size_t i) const;
  void look_up_material(std::size_t i, ShadingPoints& points);

  const World& world_;
  std::uint32_t triangles_;
  const RenderFeatures& needs_;
  const SimdMaterials& table_;
  const ViewContext& viewer_;
  const MipChains* mips_;
  const Sky* sky_;
  SamplePath path_;         // of all rays: lanes, or the reason against them
  SamplePath viewer_path_;  // of the viewer's rays
  bool own_spacings_ = false;
  int reflections_;
  float roughest_mirror_;
  Sky::PictureLobes picture_;
  bool same_sky_;                 // the same in all directions
  glm::vec3 sky_radiance_{0.0f};  // of such a sky
  std::optional<glm::vec3> background_;
  float colours_ = 1.0f;
  CachedPtr<Arrays> arrays_;  // allocated at the first plain point
};

}  // namespace asos
