#pragma once

#include "renderer/asos/block_queue.h"
#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/asos/sky_fits.h"
#include "renderer/geometry/bounds2.h"
#include "renderer/samples/bounced_light.h"
#include "renderer/samples/sampled_lights.h"
#include "renderer/samples/sobol_sampler.h"
#include "renderer/samples/thread_local_cache.h"
#include "renderer/sampling/sobol_points.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shadows/leaf.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// Computes the sky's contribution to the leaves of a block by rays. Their directions are well
/// distributed over each leaf's hemisphere. Each leaf takes a few rays, then as many as the sky's
/// contribution is worth, unless a fit through other leaves of its surface gives it (SkyFits).
/// Rays of a plane leaf start all over the leaf, since an object on the plane may shade only a
/// sliver of it. If the unoccluded contribution has a closed form, the rays estimate the occluded
/// part. With bounces, each ray also returns the radiance of the occluder (BouncedLight). The rays
/// of all leaves share packets.
class SkyContributions {
 public:
  /// `eye` has to outlive this.
  explicit SkyContributions(const EyeContext& eye);
  SkyContributions(const SkyContributions&) = delete;
  SkyContributions& operator=(const SkyContributions&) = delete;

  /// Begins the sky's contribution to a leaf and returns its number.
  std::uint32_t start(const Leaf& leaf) { return queue_.add(leaf); }
  /// Queues the sky rays of a surface of the leaf.
  void add(std::uint32_t number, const SkyQuery& point, const Leaf& leaf);
  /// Drops a contribution.
  void drop(std::uint32_t number) { queue_.drop(number); }

  /// Returns the sky's contribution to a surface of a leaf, immediately.
  [[nodiscard]] glm::vec3 at_once(const SkyQuery& point, const Leaf& leaf);

  /// Traces all deferred rays and empties the queue. The result is valid until the next leaf.
  std::span<const Contribution> run();

 private:
  struct Sent {
    std::size_t lit = 0;
    glm::vec3 carried{0.0f};
    glm::vec3 weight{0.0f};
    std::uint32_t number = 0;  // number of the ray among the surface's rays
  };
  /// A packet of rays, small enough to stay in the cache.
  struct Packet {
    static constexpr std::size_t size = 1024;
    std::size_t count = 0;
    std::array<Ray, size> rays;
    std::array<Sent, size> sent;
    std::array<glm::vec3, size> passed;
  };
  [[nodiscard]] bool held(const SkyLeaf& lit) const { return !queue_[lit.share].dropped; }
  [[nodiscard]] SobolPixel leaf_places(const SkyLeaf& lit) const;
  [[nodiscard]] glm::vec3 beside(const SkyLeaf& lit, const Bounds2& box,
                                 const SobolPixel& leaf) const;
  void send(std::size_t index, std::uint32_t end);
  void trace();
  void trace_bounces();
  void share_surfaces();
  void expect();
  [[nodiscard]] SkyFits::Expected expected(const SkyLeaf& lit, double of_neighbours) const;

  const EyeContext* eye_;
  BlockQueue queue_;
  std::vector<SkyLeaf> lit_;
  std::vector<SkyFits::Expected> expected_;  // one per element of `lit_`
  CachedPtr<Packet> packet_ = ThreadLocalCache<Packet>::make();
  // Occluders of the sky contribute bounced light.
  bool bounces_;
  SobolSampler places_;
  SampledLights lights_;
  BouncedLight bounced_;
  std::vector<SkyRay> sky_rays_;
  std::vector<glm::dvec3> brought_;
};

}  // namespace asos
