#include "renderer/asos/leaf.h"

#include "renderer/shading/brdf.h"

#include <algorithm>
#include <cmath>

namespace asos {

Leaf Leaf::of(const EyeContext& eye, const EyeSamples& samples, SampleId sample, double weight,
              const LeafRegion& region) {
  Leaf leaf;
  leaf.sample = sample;
  leaf.weight = weight;
  leaf.region = region;
  leaf.at = samples.at(sample);
  leaf.ray = samples.ray(sample);
  leaf.hit = samples.hit(sample);
  if (!leaf.hit.valid()) return leaf;
  leaf.material = &eye.scene->world().material_of(leaf.hit.triangle);
  leaf.point = samples.point(sample);
  leaf.distance = eye.viewer.spacing.distance(leaf.hit.t);
  // Compute the patch of a square with the leaf's area, and the patch of a square that reaches the
  // leaf's farthest corner. A shadow's edge may lie at the far end of a long, thin leaf.
  const Patch pixel = samples.patch(sample, 1.0);
  const auto side = static_cast<float>(std::sqrt(weight));
  leaf.square = {side * pixel.right, side * pixel.down};
  glm::vec2 farthest(0.0f);
  region.for_each_edge([&](const BorderEdge& edge) {
    farthest = glm::max(farthest, glm::abs(edge.from - leaf.at));
  });
  const glm::vec2 reach = 2.0f * static_cast<float>(eye.block.width) * farthest;
  leaf.around = {reach.x * pixel.right, reach.y * pixel.down};
  return leaf;
}

float Leaf::albedo() const {
  const glm::vec3 diffuse = diffuse_share(*material) * glm::vec3(material->base_color);
  const glm::vec3 c = glm::clamp(diffuse + material->sheen.color, 0.0f, 1.0f);
  return std::max({c.x, c.y, c.z});
}

}  // namespace asos
