#pragma once

#include "renderer/kernels/surface_batch.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/prepared/viewer.h"
#include "renderer/samples/recycled.h"
#include "renderer/samples/sampled_lights.h"
#include "renderer/shading/plain_materials.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace asos {

/// Shades a batch of points of plain surfaces, triangles of opaque materials, in arrays: a viewer's
/// rays at their first hits. Shader shades all else, one point at a time, and these to the same
/// values but for roundings.
class PlainSamples {
 public:
  /// Both have to outlive this.
  PlainSamples(const RenderScene& scene, const Viewer& viewer);

  /// See SampleSums.
  void widen_colours(float times) { colours_ = times; }
  /// Adds what ray number `index` met to the batch; false where it is not plain.
  [[nodiscard]] bool add(std::size_t index, const Ray& ray, const Hit& hit, float side);
  [[nodiscard]] std::size_t count() const { return arrays_ ? arrays_->hits.count : 0; }
  /// The number of the ray of point i.
  [[nodiscard]] std::size_t index(std::size_t i) const { return arrays_->index[i]; }
  void clear() {
    if (arrays_) arrays_->hits.count = arrays_->looked_up_count = 0;
  }

  /// What rays see that meet nothing, where that is the same for all.
  [[nodiscard]] const std::optional<glm::vec3>& background() const { return background_; }

  /// Makes the points. False where any is not finite: then none counts.
  [[nodiscard]] bool shade(LitBatch& points);

  // Of point i of the batch, once it was made.

  /// Whether a reflection may be followed.
  [[nodiscard]] bool may_mirror(std::size_t i) const {
    return reflections_ &&
           (arrays_->materials.roughness[i] <= roughest_mirror_ || arrays_->material[i]->own_dfr);
  }
  /// Follows its reflection, as Shader::reflect does; `points` is told.
  [[nodiscard]] bool reflect(std::size_t i, const ViewedRay& seen, LitBatch& points,
                             LightTransport& transport, RenderStatistics& counts) const;
  /// What the viewer sees of it but lights and reflections; of the sky only the diffuse share where
  /// it `mirrors`.
  [[nodiscard]] glm::vec3 unlit_radiance(std::size_t i, const LitBatch& points, bool mirrors) const;
  /// What it sends out itself.
  [[nodiscard]] glm::vec3 emission(std::size_t i) const { return arrays_->emission[i]; }
  /// Adds a ray to the sky, or to what hides it, by `transport`.
  void add_sky(std::size_t i, const LitBatch& points, bool mirrors, LightTransport& transport,
               RenderStatistics& counts) const;

 private:
  /// What the viewer's rays show of it.
  [[nodiscard]] glm::vec3 shown(glm::vec3 emission, std::uint32_t triangle) const;
  struct Arrays {
    TriangleBatch hits;
    SurfaceRest rest;
    MaterialBatch materials;
    std::array<glm::vec3, LitBatch::size> emission;
    std::array<const PlainMaterial*, LitBatch::size> material;
    std::array<Hit, LitBatch::size> hit;
    std::array<std::size_t, LitBatch::size> index;
    std::array<std::size_t, LitBatch::size> looked_up;  // the points whose materials are
    std::size_t looked_up_count = 0;
  };
  [[nodiscard]] ViewedMaterial viewed_material(std::size_t i, const LitBatch& points) const;
  void look_up_material(std::size_t i, LitBatch& points);

  const World& world_;
  std::uint32_t triangles_;
  const SceneNeeds& needs_;
  const PlainMaterials& table_;
  const Viewer& viewer_;
  const MipChains* mips_;
  const Sky* sky_;
  bool usable_;
  bool reflections_;
  float roughest_mirror_;
  bool same_sky_;                 // all over
  glm::vec3 sky_radiance_{0.0f};  // of such a sky
  std::optional<glm::vec3> background_;
  float colours_ = 1.0f;
  Recycled<Arrays> arrays_;  // once there is a plain point
};

}  // namespace asos
