#pragma once

#include "renderer/comparison/exact_visibility.h"
#include "renderer/samples/block_job.h"
#include "renderer/samples/sample_block.h"
#include "renderer/samples/sampled_lights.h"
#include "renderer/shading/shade.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace asos {

/// The triangles of a scene in the view of a block of pixels, object by object, and the radiance at
/// points of them. For methods that compute polygon areas: beam, cone, covers, mask. Supports
/// opaque surfaces only, and tests all triangles of the scene. Keeps references to the job's parts.
class BlockFacets {
 public:
  /// `margin`: number of pixels around the block that are searched for facets, too.
  explicit BlockFacets(const BlockJob& job, int margin = 0);

  [[nodiscard]] std::span<const Facet> facets() const { return facets_; }
  /// Returns the facets of each visible object (World::parts), which are consecutive.
  [[nodiscard]] std::span<const std::span<const Facet>> objects() const { return objects_; }

  /// Returns the square of `side` pixels around the centre of pixel (x, y) of the block.
  [[nodiscard]] FrameRectangle square(int x, int y, double side = 1.0) const;
  /// Returns a pixel's side in the frame's units.
  [[nodiscard]] double pixel() const { return pixel_; }

  /// Returns the radiance of a facet, or of the background for null, at a point of the frame, for a
  /// square of `side` pixels. Each light with an extent gets as many shadow rays as the settings
  /// have samples, rounded up to n * n; others get one.
  [[nodiscard]] glm::vec3 radiance(const Facet* facet, glm::dvec2 at, double side);
  /// Renders each pixel (x, y) of the block by `render`, which returns its radiance and sets
  /// `split` if it shows several surfaces.
  [[nodiscard]] BlockResult run(const std::function<glm::vec3(int x, int y, bool& split)>& render);

 private:
  [[nodiscard]] Hit hit_of(const Facet& facet, glm::dvec2 at, const Ray& ray) const;
  [[nodiscard]] double nearness_of(double depth) const;
  [[nodiscard]] bool shows_back(std::uint32_t triangle) const;

  BlockJob job_;
  glm::dvec2 corner_;  // of the frame, in the picture's pixels
  double pixel_;
  Frame frame_;
  Shader shader_;
  GridSampler places_;
  int light_samples_;
  SampledLights lights_;
  std::vector<glm::dvec3> sums_;
  std::vector<Facet> facets_;
  std::vector<std::span<const Facet>> objects_;
  RenderStatistics statistics_;
};

}  // namespace asos
