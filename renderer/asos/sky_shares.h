#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/samples/bounced_light.h"
#include "renderer/samples/sampled_lights.h"
#include "renderer/samples/sobol_places.h"
#include "renderer/sampling/sobol_points.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shadows/leaf_context.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// What the leaves of a block get of the sky: by rays in directions that are well distributed over
/// each leaf's hemisphere, first a few, then as many as its share of the sky makes worth while.
/// Where all of the sky's light is known in closed form, rays find out what is hidden of it. With
/// bounces, they bring what hides it instead (BouncedLight). The rays of all leaves share packets.
class SkyShares {
 public:
  /// `eye` has to outlive this.
  explicit SkyShares(const EyeContext& eye);
  SkyShares(const SkyShares&) = delete;
  SkyShares& operator=(const SkyShares&) = delete;

  /// What a leaf of a root gets.
  struct Share {
    std::uint32_t root = 0;
    SampleId sample = no_sample;  ///< the leaf's; none: dropped
    double weight = 1.0;          ///< the leaf's
    glm::dvec3 radiance{0.0};     ///< times its weight
    std::uint64_t rays = 0;
  };
  /// Begins the share of a leaf; its number.
  std::uint32_t start(std::uint32_t root, SampleId sample, double weight);
  /// Adds a surface of the leaf to its share.
  void add(std::uint32_t share, const SkyLitPoint& point, const LeafContext& leaf);
  /// Leaves a share out.
  void drop(std::uint32_t share) { shares_[share].sample = no_sample; }

  /// What a surface gets at once, as part of a leaf of this weight; none waits.
  [[nodiscard]] glm::vec3 at_once(const SkyLitPoint& point, const LeafContext& leaf);

  /// Traces all that was added. Valid until the next leaf; none waits then.
  std::span<const Share> run();

 private:
  /// A surface, and what its rays have found so far.
  struct Lit {
    std::uint32_t share = 0;
    SurfacePoint point;
    ViewedMaterial material;
    glm::vec3 to_viewer{0.0f};
    float n_dot_v = 1.0f;
    const Sky* sky = nullptr;
    bool mirrors = false;
    glm::vec3 factor{1.0f};
    std::uint64_t seed = 0;           ///< its own
    std::optional<glm::vec3> open{};  ///< all of the sky's light, if nothing hid it
    std::uint32_t rays = 0;
    glm::dvec3 arrived{0.0};  ///< of all rays
    glm::dvec3 sent{0.0};     ///< if nothing were in the way
    double error = 0.0;       ///< of one ray, whose sum is `mean`'s: their sum and that of squares
    double error2 = 0.0;

    /// The share of what its rays would carry that arrives; 1 where they carry nothing.
    [[nodiscard]] double seen() const;
    /// All that arrives.
    [[nodiscard]] glm::dvec3 mean() const;
  };
  struct Sent {
    std::size_t lit = 0;
    glm::vec3 carried{0.0f};
    glm::vec3 weight{0.0f};
    std::uint32_t number = 0;  // of the surface's rays
  };
  [[nodiscard]] bool held(const Lit& lit) const { return shares_[lit.share].sample != no_sample; }
  void send(std::size_t index, std::uint32_t end);
  void trace();
  void trace_bounces();
  /// What a block's surfaces tell of each other.
  struct Neighbours {
    double seen = 0.5;       ///< share of the sky
    double variance = 0.25;  ///< of what a ray brings, with bounces
  };
  [[nodiscard]] Neighbours neighbours() const;
  [[nodiscard]] double spread(const Lit& lit, const Neighbours& neighbours) const;
  [[nodiscard]] std::uint32_t rays_of(const Lit& lit, const Neighbours& neighbours) const;

  const EyeContext* eye_;
  std::vector<Share> shares_;
  std::vector<Share> done_;
  std::vector<Lit> lit_;
  // Rays on their way.
  std::vector<Ray> rays_;
  std::vector<Sent> sent_;
  std::vector<glm::vec3> passed_;
  // With bounces, what they bring.
  bool bounces_;
  SobolPlaces places_;
  SampledLights lights_;
  BouncedLight bounced_;
  std::vector<SkyRay> sky_rays_;
  std::vector<glm::dvec3> brought_;
};

}  // namespace asos
