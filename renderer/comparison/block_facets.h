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

/// The triangles of a scene as a block of pixels sees them, object by object, and the radiance at
/// points of them. For methods that compute areas of polygons: beam, cone, covers, mask. Opaque
/// surfaces only; each looks at all triangles of the scene. Keeps references to the job's parts.
class BlockFacets {
 public:
  /// `margin`: pixels around the block in which facets are found, too.
  explicit BlockFacets(const BlockJob& job, int margin = 0);

  [[nodiscard]] std::span<const Facet> facets() const { return facets_; }
  /// The facets of each object (World::parts) that is seen: consecutive ones.
  [[nodiscard]] std::span<const std::span<const Facet>> objects() const { return objects_; }

  /// The square of `side` pixels around the centre of pixel (x, y) of the block.
  [[nodiscard]] FrameRectangle square(int x, int y, double side = 1.0) const;
  /// A pixel's side in the frame's units.
  [[nodiscard]] double pixel() const { return pixel_; }

  /// Radiance of a facet, or of the background for null, at a point of the frame, for a square of
  /// `side` pixels. Each light takes as many shadow rays as the settings have samples.
  [[nodiscard]] glm::vec3 radiance(const Facet* facet, glm::dvec2 at, double side);
  /// Renders each pixel (x, y) of the block by `render`, which returns its radiance and sets
  /// `split` where it shows several surfaces.
  [[nodiscard]] BlockResult run(const std::function<glm::vec3(int x, int y, bool& split)>& render);

 private:
  [[nodiscard]] Hit hit_of(const Facet& facet, glm::dvec2 at, const Ray& ray) const;
  [[nodiscard]] double nearness_of(double depth) const;
  [[nodiscard]] bool shows_back(std::uint32_t triangle) const;

  BlockJob job_;
  glm::dvec2 corner_;  // of the frame, in pixels of the picture
  double pixel_;
  Frame frame_;
  Shader shader_;
  GridPlaces places_;
  int light_samples_;
  SampledLights lights_;
  std::vector<glm::dvec3> sums_;
  std::vector<Facet> facets_;
  std::vector<std::span<const Facet>> objects_;
  RenderStatistics statistics_;
};

}  // namespace asos
