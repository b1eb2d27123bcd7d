#include "renderer/reflections/own_side.h"

#include "renderer/rays/back_face.h"

#include <cmath>
#include <limits>

namespace asos {
namespace {

// A ray that grazes facets has fewer such hits than this. With mixed windings of triangles, it may
// have more.
constexpr int most_passed = 16;

bool met_own_side(const VolumePath& passage, const World& world, const Ray& ray, const Hit& hit) {
  return hit.valid() && world.triangle_part[hit.triangle] == passage.part &&
         meets_back(world, hit, ray.direction) != passage.inside;
}

}  // namespace

void pass_own_side(const VolumePath& passage, const World& world, const RayScene& scene,
                   Culling faces, std::span<const Ray> rays, std::span<Hit> hits) {
  if (!passage.left_boundary()) return;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    // Attenuation starts at the original t_near, so only a copy of the ray moves.
    Ray ray = rays[i];
    for (int k = 0; k < most_passed && met_own_side(passage, world, ray, hits[i]); ++k) {
      ray.t_near = std::nextafter(hits[i].t, std::numeric_limits<float>::infinity());
      hits[i] = scene.closest(ray, faces);
    }
  }
}

}  // namespace asos
