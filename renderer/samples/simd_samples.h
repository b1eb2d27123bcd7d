#pragma once

#include "renderer/kernels/batch_textures.h"
#include "renderer/kernels/sky_kernel.h"
#include "renderer/kernels/surface_batch.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/prepared/view_context.h"
#include "renderer/samples/sampled_lights.h"
#include "renderer/samples/thread_local_cache.h"
#include "renderer/shading/simd_materials.h"
#include "renderer/shading/volume_boundary.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// The SIMD path for hits on triangles, shaded in batches: those of the viewer's rays, or of rays
/// that continue samples. Shader shades everything else, one point at a time, with the same result
/// up to rounding. A point is one layer of a surface; those of one hit follow each other, from the
/// top down.
class SimdSamples {
 public:
  /// Both arguments have to outlive this.
  SimdSamples(const RenderScene& scene, const ViewContext& viewer);

  /// See SampleSums.
  void widen_colours(float times) { colours_ = times; }
  /// From now on, blended surfaces need Shader.
  void leave_blended() { takes_blended_ = false; }
  /// Adds the hit of the viewer's ray number `index` to the batch, which must have room. Returns
  /// the reason if the hit needs Shader instead.
  [[nodiscard]] SamplePath add(std::size_t index, const Ray& ray, const Hit& hit, float side);
  /// Adds the hit of another ray, with the spacing of its own picture. All points of a batch are of
  /// the same kind.
  [[nodiscard]] SamplePath add_reflected(std::size_t index, const ViewedRay& seen);
  [[nodiscard]] std::size_t count() const { return arrays_ ? arrays_->hits.count : 0; }
  /// Returns whether there is no room for another hit.
  [[nodiscard]] bool full_for(const Hit& hit) const {
    if (count() + MaterialLayers::most <= ShadingPoints::size || hit.triangle >= triangles_)
      return false;
    return count() + table_.of(world_, hit.triangle).layers.size() > ShadingPoints::size;
  }
  /// Returns the number of point i's ray.
  [[nodiscard]] std::size_t index(std::size_t i) const { return arrays_->index[i]; }
  /// Returns whether point i is the top of its hit.
  [[nodiscard]] bool is_top(std::size_t i) const {
    return i == 0 || arrays_->index[i] != arrays_->index[i - 1];
  }
  void clear();

  /// Returns the radiance of rays without a hit, if it is the same for all.
  [[nodiscard]] const std::optional<glm::vec3>& background() const { return background_; }

  /// Computes the points. Returns false if any is not finite; then none is valid.
  [[nodiscard]] bool shade(ShadingPoints& points);

  // The following are for point i of the batch, after `shade`.

  /// Returns the layer's weight in the radiance of its ray.
  [[nodiscard]] glm::vec3 share(std::size_t i) const { return arrays_->share[i]; }
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
  /// Returns its radiance without lights and reflections, and without its share.
  [[nodiscard]] glm::vec3 unlit_radiance(std::size_t i, const ShadingPoints& points) const;
  /// Returns its own emission, or the colour of an unlit surface.
  [[nodiscard]] glm::vec3 emission(std::size_t i) const { return arrays_->emission[i]; }
  /// Adds a ray to the sky or its occluder through `transport`. Returns the radiance of the sky
  /// that this adds at once, without the weight of the point's ray.
  [[nodiscard]] glm::vec3 add_sky(std::size_t i, const ShadingPoints& points,
                                  LightTransport& transport, RenderStatistics& counts) const;

  /// A blended surface of the batch, behind which its ray continues.
  struct Passage {
    std::size_t point = 0;    ///< the surface's own layer
    bool clear = false;       ///< its opacity is 0
    glm::vec3 beside{0.0f};   ///< weight of the light that it leaves, in the ray's radiance
    glm::vec3 through{0.0f};  ///< weight of the light that it transmits
    float roughness = 0.0f;   ///< of transmission
    bool bends = false;       ///< transmission is blurred or refracted
    VolumePath before;        ///< the volumes in front of it and, if the ray goes on, behind it
    VolumePath behind;
    std::optional<VolumeBoundary> boundary;
  };
  [[nodiscard]] std::span<const Passage> passages() const {
    return arrays_ ? std::span<const Passage>(arrays_->passages) : std::span<const Passage>();
  }
  /// Returns the geometry of a point.
  [[nodiscard]] SurfacePoint point(std::size_t i, const ShadingPoints& points) const;

 private:
  /// The part of a ray's state that its points use.
  struct RayState {
    int bounces = 0;
    bool hides_lights = false;
    float colours = 1.0f;
    const VolumePath& passage;
    float start = 0.0f;  ///< ViewedRay::start
  };
  /// The boundary of a volume at a hit.
  struct MetVolume {
    VolumeBoundary boundary;
    VolumePath before;  ///< in the medium in front of it

    /// Returns the path after reflection.
    [[nodiscard]] VolumePath reflected() const { return boundary.reflected(before); }
  };
  /// A hit whose layers are viewed one by one.
  struct LayeredHit {
    std::size_t top = 0;  ///< its first point
    SurfaceMaterial material;
  };
  struct Arrays {
    TriangleBatch hits;
    SurfaceRest rest;
    MaterialBatch materials;
    SkyBatch sky;
    SpacingBatch spacing;  // only of reflected rays
    std::array<bool, ShadingPoints::size> mirrors;
    std::array<bool, ShadingPoints::size> hides_lights;
    std::array<int, ShadingPoints::size> bounces;
    std::array<float, ShadingPoints::size> colours;
    std::array<glm::vec3, ShadingPoints::size> share;
    std::array<int, ShadingPoints::size> volume;  // index of MetVolume; -1: none
    std::array<glm::vec3, ShadingPoints::size> emission;
    std::array<const SimdMaterial*, ShadingPoints::size> material;
    std::array<Hit, ShadingPoints::size> hit;
    std::array<std::size_t, ShadingPoints::size> index;
    std::array<std::size_t, ShadingPoints::size> looked_up;  // tops whose materials are looked up
    std::size_t looked_up_count = 0;
    // Tops of one material after the other, and the values of their textures.
    std::array<std::size_t, ShadingPoints::size> by_material;
    std::array<std::size_t, ShadingPoints::size> first_texel;  // of a top
    std::array<std::size_t, ShadingPoints::size> texel_stride;
    std::vector<glm::vec4> texels;
    BatchTextures textures;
    std::vector<MetVolume> volumes;
    std::vector<LayeredHit> layered;
    std::vector<Passage> passages;
  };

  [[nodiscard]] SamplePath add(std::size_t index, const Ray& ray, const Hit& hit, float side,
                               const RayState& state);
  void add_point(std::size_t index, const Ray& ray, const Hit& hit, float side,
                 const RayState& state, const SimdMaterial& material);
  void meet_volume(std::size_t top, const Ray& ray, const RayState& state);
  [[nodiscard]] const MetVolume* volume_of(std::size_t i) const {
    return arrays_->volume[i] < 0 ? nullptr
                                  : &arrays_->volumes[static_cast<std::size_t>(arrays_->volume[i])];
  }
  /// Returns the emission that the point's ray includes.
  [[nodiscard]] glm::vec3 shown(std::size_t i, glm::vec3 emission) const;
  [[nodiscard]] ViewedMaterial viewed_material(std::size_t i, const ShadingPoints& points) const;
  [[nodiscard]] bool lobe_reflects_sky(std::size_t i) const;
  void look_up_textures();
  void look_up_textures(std::span<const std::size_t> tops);
  [[nodiscard]] LookedUpTexels texels(std::size_t top) const;
  void look_up_material(std::size_t top, ShadingPoints& points);
  void set_material(std::size_t top, const SurfaceMaterial& material);
  void map_normals(std::size_t i, const TextureUse& map, glm::vec4 mean, ShadingPoints& points);
  void turn_behind(std::size_t i, ShadingPoints& points);
  [[nodiscard]] bool view_layers(const LayeredHit& hit, ShadingPoints& points);
  void set_viewed(std::size_t i, const ViewedMaterial& seen, ShadingPoints& points);
  void weigh_layers(const LayeredHit& hit, const ShadingPoints& points);
  void add_passage(const LayeredHit& hit, glm::vec3 weight, float opacity, float left);

  const World& world_;
  const RayScene& rays_;
  std::uint32_t triangles_;
  const RenderFeatures& needs_;
  const SimdMaterials& table_;
  const ViewContext& viewer_;
  const MipChains* mips_;
  const Sky* sky_;
  SamplePath path_;         // of all rays: lanes, or the reason against them
  SamplePath viewer_path_;  // of the viewer's rays
  bool takes_blended_ = true;
  bool own_spacings_ = false;
  int reflections_;
  float roughest_mirror_;
  Sky::PictureLobes picture_;
  bool same_sky_;                 // the same in all directions
  glm::vec3 sky_radiance_{0.0f};  // of such a sky
  std::optional<glm::vec3> background_;
  float colours_ = 1.0f;
  CachedPtr<Arrays> arrays_;  // allocated at the first point
};

}  // namespace asos
