#pragma once

#include "renderer/asos/block_queue.h"
#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/asos/sky_courses.h"
#include "renderer/asos/sky_lit.h"
#include "renderer/geometry/bounds2.h"
#include "renderer/pyray/square.h"
#include "renderer/samples/bounced_light.h"
#include "renderer/samples/recycled.h"
#include "renderer/samples/sampled_lights.h"
#include "renderer/samples/sobol_places.h"
#include "renderer/sampling/sobol_points.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shadows/leaf_context.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// What the leaves of a block get of the sky: by rays in directions that are well distributed over
/// each leaf's hemisphere, first a few, then as many as its share of the sky makes worth while,
/// unless others of its surface tell what it gets (SkyCourses). Those of plane leaves start all
/// over them: what stands on the plane may shade a sliver alone. Where all of the sky's light is
/// known in closed form, rays find out what is hidden of it. With bounces, they bring what hides it
/// instead (BouncedLight). The rays of all leaves share packets.
class SkyShares {
 public:
  /// `eye` has to outlive this.
  explicit SkyShares(const EyeContext& eye);
  SkyShares(const SkyShares&) = delete;
  SkyShares& operator=(const SkyShares&) = delete;

  /// Begins the contribution of the sky to a leaf; its number.
  std::uint32_t start(std::uint32_t root, SampleId sample, double weight);
  /// Adds a surface of the leaf to its contribution.
  void add(std::uint32_t number, const SkyLitPoint& point, const LeafContext& leaf);
  /// Leaves a contribution out.
  void drop(std::uint32_t number) { queue_.drop(number); }

  /// What a surface gets at once, as part of a leaf of this weight; none waits.
  [[nodiscard]] glm::vec3 at_once(const SkyLitPoint& point, const LeafContext& leaf);

  /// Traces all that was added. Valid until the next leaf; none waits then.
  std::span<const Contribution> run();

 private:
  struct Sent {
    std::size_t lit = 0;
    glm::vec3 carried{0.0f};
    glm::vec3 weight{0.0f};
    std::uint32_t number = 0;  // of the surface's rays
  };
  /// Rays on their way, a packet after the other: so few that they stay in the cache.
  struct Packet {
    static constexpr std::size_t size = 1024;
    std::size_t count = 0;
    std::array<Ray, size> rays;
    std::array<Sent, size> sent;
    std::array<glm::vec3, size> passed;
  };
  [[nodiscard]] bool held(const SkyLit& lit) const { return !queue_[lit.share].dropped; }
  [[nodiscard]] SobolPixel leaf_places(const SkyLit& lit) const;
  [[nodiscard]] LeafRegion region(const SkyLit& lit) const {
    return {lit.square, std::span(borders_).subspan(lit.first_edge, lit.edges)};
  }
  [[nodiscard]] glm::vec3 beside(const SkyLit& lit, const Bounds2& box,
                                 const SobolPixel& leaf) const;
  void send(std::size_t index, std::uint32_t end);
  void trace();
  void trace_bounces();
  void share_surfaces();
  void expect();
  [[nodiscard]] SkyCourses::Expected expected(const SkyLit& lit, double of_neighbours) const;

  const EyeContext* eye_;
  BlockQueue queue_;
  std::vector<SkyLit> lit_;
  std::vector<BorderEdge> borders_;
  std::vector<SkyCourses::Expected> expected_;  // of each
  Recycled<Packet> packet_ = Recycler<Packet>::make();
  // With bounces, what they bring.
  bool bounces_;
  SobolPlaces places_;
  SampledLights lights_;
  BouncedLight bounced_;
  std::vector<SkyRay> sky_rays_;
  std::vector<glm::dvec3> brought_;
};

}  // namespace asos
