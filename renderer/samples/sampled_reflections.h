#pragma once

#include "renderer/reflections/mirror_plane.h"
#include "renderer/samples/sampled_lights.h"
#include "renderer/shading/shade.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace asos {

/// A point sample of the picture, with its target sum.
struct PointSample {
  glm::dvec2 at{0.0};  ///< in pixels of the picture
  float side = 1.0f;   ///< side, in pixels, of the square that it represents
  // Its places on lights and in lobes are those of sample `index` of the pixel (x, y).
  int x = 0;
  int y = 0;
  int index = 0;
  std::size_t target = 0;  ///< index of its sum
  /// The part of the radiance that the ray carries; direct: it is the sample's eye ray.
  LightPart part = LightPart::direct;
};

/// A ray that continues a sample after a reflection or behind a transparent surface.
struct ReflectedSample {
  PointSample sample;
  glm::vec3 weight{1.0f};  ///< weight of the ray's radiance in its sample
  Ray ray;
  PixelSpacing spacing;
  float side = 1.0f;
  float width = 0.0f;  ///< see ViewedRay
  int bounces = 0;
  float throughput = 1.0f;
  bool hides_lights = false;
  std::optional<MirrorPlane> mirror;  ///< the flat mirror that the ray leaves
  VolumePath passage;
  float colours = 1.0f;  ///< see ViewedRay
  PassedLayers passed;   ///< by this ray, before it was continued

  /// Returns whether the ray goes on behind a surface in its direction.
  [[nodiscard]] bool passes() const { return passed.last != Hit::none; }
  [[nodiscard]] ViewedRay viewed(const Hit& hit) const;
};

/// Reflections and refractions for sampling methods: one ray in a random direction of the lobe.
/// Rays with a small weight end at random, and the remaining ones represent them. Rays are
/// collected and traced in packets.
class SampledReflections {
 public:
  /// Both arguments have to outlive this.
  SampledReflections(const World& world, const LightSamplePoints& places)
      : world_(&world), places_(&places) {}

  /// Adds the reflection of a sample with this weight; `shader` is that of its picture.
  void add(const Reflection& reflection, const PointSample& sample, glm::vec3 weight,
           const Shader& shader);

  /// The rest of a ray behind a transparent surface.
  struct Rest {
    glm::vec3 left{1.0f};  ///< its weight in the ray's radiance
    bool clear = false;    ///< the surface is invisible
    VolumePath passage;
  };
  /// Adds the rest of a ray behind its hit at `point`, if it is visible.
  void pass(const ViewedRay& seen, const SurfacePoint& point, const Rest& rest,
            const PointSample& sample, glm::vec3 weight, const Shader& shader,
            RenderStatistics& counts);

  [[nodiscard]] bool any() const { return !pending_.empty() || !passing_.empty(); }
  /// The number of waiting reflections; `forget_since` drops all later ones.
  [[nodiscard]] std::size_t waiting() const { return pending_.size(); }
  void forget_since(std::size_t count) { pending_.resize(count); }
  /// Takes the waiting rays that pass a surface, which are coherent, or else those that were
  /// reflected, in their order.
  [[nodiscard]] std::vector<ReflectedSample> take() {
    return std::exchange(passing_.empty() ? pending_ : passing_, {});
  }

 private:
  [[nodiscard]] static bool turn_by_lobe(const Reflection& reflection, glm::dvec2 place,
                                         glm::dvec3& direction, glm::vec3& weight);
  [[nodiscard]] float chance(const Reflection& reflection, glm::vec3 weight) const;
  void add_ray(const Reflection& reflection, const ReflectedSample& start, float width,
               glm::vec3 colours, const Shader& shader);

  const World* world_;
  const LightSamplePoints* places_;
  std::vector<ReflectedSample> pending_;  // reflected or refracted
  std::vector<ReflectedSample> passing_;  // behind a transparent surface
};

}  // namespace asos
