#include "renderer/reflections/mirror_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {
namespace {

// At a shared corner, a ray hits all of the plane's triangles there.
constexpr int most_at_corner = 16;

bool lies_in(const MirrorPlane& plane, const World& world, std::uint32_t triangle) {
  const glm::uvec3 v = world.triangles[triangle];
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 p(world.positions[v[i]]);
    const double rounding =
        std::numeric_limits<float>::epsilon() * glm::dot(glm::abs(p), glm::abs(plane.above.normal));
    if (!(std::abs(plane.above.height(p)) <= rounding)) return false;
  }
  return true;
}

bool met_mirror(const MirrorPlane& plane, const World& world, const Ray& ray, const Hit& hit) {
  return hit.valid() && !world.is_face(hit.triangle) &&
         plane.above.height(glm::dvec3(ray.at(hit.t))) < plane.hit_tolerance &&
         lies_in(plane, world, hit.triangle);
}

}  // namespace

void pass_mirror(const MirrorPlane& plane, const World& world, const RayScene& scene, Culling faces,
                 std::span<Ray> rays, std::span<Hit> hits) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    for (int k = 0; k < most_at_corner && met_mirror(plane, world, rays[i], hits[i]); ++k) {
      rays[i].t_near = std::nextafter(hits[i].t, std::numeric_limits<float>::infinity());
      hits[i] = scene.closest(rays[i], faces);
    }
  }
}

}  // namespace asos
