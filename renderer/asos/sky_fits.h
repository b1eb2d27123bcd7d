#pragma once

#include "renderer/geometry/largest.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shadows/leaf.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// A leaf's surface under the sky, and the sums of its rays. A ray's error is its radiance minus
/// the radiance without occlusion, divided by `unit`.
struct SkyLeaf {
  std::uint32_t share = 0;  ///< number of the leaf's contribution
  const Leaf* leaf = nullptr;
  bool flat = false;  ///< the surface within the leaf is a plane
  SurfacePoint point;
  std::uint32_t smooth_surface = 0;  ///< number of the connected surface
  ViewedMaterial material;
  glm::vec3 to_viewer{0.0f};
  float n_dot_v = 1.0f;
  const Sky* sky = nullptr;
  bool mirrors = false;
  glm::vec3 factor{1.0f};
  glm::vec3 open{0.0f};  ///< the sky's contribution without occlusion
  /// Largest possible contribution: `open`, or with bounces that of white surroundings.
  glm::vec3 unit{0.0f};

  std::uint32_t rays = 0;
  glm::dvec3 arrived{0.0};  ///< radiance of all rays
  glm::dvec3 sent{0.0};     ///< the rays' sum without occlusion
  double error = 0.0;       ///< sums of the rays' errors and squared errors
  double error2 = 0.0;
  std::optional<glm::dvec3> fitted{};  ///< mean radiance from the fit through other leaves

  [[nodiscard]] SkyQuery lit_point(const ViewedPoint& view) const {
    return {sky, view, material, mirrors, factor};
  }
  /// Returns the visible fraction of the sky, by radiance, at most 1.
  [[nodiscard]] double seen() const {
    return largest(sent) > 0.0 ? std::min(1.0, largest(arrived) / largest(sent)) : 1.0;
  }
  /// Returns the mean radiance. Where most of the sky is visible, the rays estimate the hidden part
  /// instead.
  [[nodiscard]] glm::dvec3 mean() const {
    if (fitted) return *fitted;
    const double all = rays;
    if (seen() < 0.5) return arrived / all;
    return glm::max(glm::dvec3(open) - (sent - arrived) / all, 0.0);
  }
  /// Adds a ray with this radiance; `whole` is its radiance without occlusion. Its error is clamped
  /// at white.
  void arrive(glm::dvec3 brought, glm::vec3 whole) {
    arrived += brought;
    const glm::dvec3 off = brought - glm::dvec3(whole);
    const double one = static_cast<double>(unit.x + unit.y + unit.z);
    const double by = one > 0.0 ? std::min(3.0, off.x + off.y + off.z) / one : 0.0;
    error += by;
    error2 += by * by;
  }
  /// Returns the sum of squared deviations of the errors from their mean.
  [[nodiscard]] double squares() const {
    return rays > 0 ? std::max(0.0, error2 - error * error / rays) : 0.0;
  }
  /// Returns the squared error of the mean of `rays` rays of a Sobol sequence, if one ray's error
  /// has this variance. Only strata that an occluder's outline crosses contribute. Their fraction
  /// falls with the root of the number of rays. It grows with the outline's length, which is
  /// proportional to the root of the hidden area.
  [[nodiscard]] static double variance_of_mean(double variance, double rays) {
    return 0.5 * std::sqrt(variance) / (rays * std::sqrt(rays));
  }
  /// Returns the number of rays whose mean has the squared error `error2`.
  [[nodiscard]] static double rays_for(double variance, double error2) {
    return std::cbrt(0.25 * variance / (error2 * error2));
  }
};

/// Shares the sky's contribution between a block's leaves on one surface. Nodes spread over the
/// surface are sampled densely. A fit through the nodes (PolynomialFit) is accepted if its misfit
/// is within the noise of the nodes and does not contradict the few rays of the other leaves. Then
/// all leaves use the fit. Otherwise the surface is divided, and leaves without a fit are sampled
/// themselves. A leaf's error is thus that of its nodes, plus a curvature below the noise.
class SkyFits {
 public:
  /// Leaves that may share a fit.
  struct Cell {
    std::vector<std::uint32_t> lits;
    std::vector<std::uint32_t> nodes;  ///< subset of `lits` with densely sampled rays
    std::uint32_t node_rays = 0;       ///< number of rays per node
  };
  /// Expected noise and cost of a leaf's rays.
  struct Expected {
    double variance = 0.0;   ///< variance of one ray, divided by the leaf's unit
    std::uint32_t rays = 0;  ///< rays that the leaf would need by itself
  };

  /// `standard_error`: allowed error of a whole pixel, in display units. The spans have to outlive
  /// this.
  SkyFits(std::span<SkyLeaf> lits, std::span<const Expected> expected, double standard_error)
      : lits_(lits), expected_(expected), standard_error_(standard_error) {}

  /// Groups the leaves that may share a fit, by surface.
  [[nodiscard]] std::vector<Cell> cells() const;
  /// Chooses nodes. Returns false if sharing does not pay.
  [[nodiscard]] bool choose_nodes(Cell& cell) const;
  /// Assigns the fit to all leaves that do not contradict it, after the nodes were sampled. Returns
  /// false if the nodes do not fit, or too many leaves contradict the fit.
  [[nodiscard]] bool assign(const Cell& cell) const;
  /// Adds a cell's quarters.
  void divide(const Cell& cell, std::vector<Cell>& quarters) const;

 private:
  [[nodiscard]] bool alike(const SkyLeaf& a, const SkyLeaf& b) const;
  [[nodiscard]] std::uint32_t rays_of_nodes(const Cell& cell) const;
  [[nodiscard]] double variance(std::uint32_t lit) const;

  std::span<SkyLeaf> lits_;
  std::span<const Expected> expected_;
  double standard_error_;
};

}  // namespace asos
