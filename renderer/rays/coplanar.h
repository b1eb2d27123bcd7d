#pragma once

#include "renderer/rays/coplanar_pairs.h"
#include "renderer/rays/filters.h"
#include "renderer/world/world.h"

#include <embree3/rtcore.h>

#include <cstddef>
#include <cstdint>
#include <vector>

// Triangles of different parts that are coplanar and overlap, such as decals. A ray hits them at
// the same place, where rounding alone would decide which is nearest. Internal to this folder.

namespace asos::tracing {

/// Marks for coplanar surfaces. 1: a triangle of another part is coplanar with this one and
/// overlaps it. There is one array for the world's own triangles and one for places of shared
/// meshes; both are empty if there are none. Places whose boxes meet other parts' boxes are marked,
/// and so are triangles in such boxes, which costs time and does not change the picture.
struct Coplanar {
  std::vector<std::uint8_t> by_triangle;
  std::vector<std::uint8_t> by_place;
  /// For each triangle that the search marked, one that it is coplanar with. A world without that
  /// one has to search again for this triangle only.
  std::vector<Partner> partners;
  std::size_t compared = 0;  ///< pairs of triangles that the search compared

  [[nodiscard]] bool empty() const { return by_triangle.empty() && by_place.empty(); }
  [[nodiscard]] bool marks(const World& world, std::uint32_t triangle) const {
    if (triangle < by_triangle.size()) return by_triangle[triangle] != 0;
    return !by_place.empty() && world.is_placed(triangle) &&
           by_place[world.placements->index_of_triangle(triangle)] != 0;
  }
};

/// Finds the coplanar triangles. `known`: those of another world, `known_world`, whose marks hold
/// for the surfaces of both (Part::surfaces); null: none. Only pairs with other surfaces are
/// compared then. It changes no mark.
[[nodiscard]] Coplanar find_coplanar(const World& world, const World* known_world = nullptr,
                                     const Coplanar* known = nullptr);

/// Returns the distance along a ray within which other hits count as at the same place as a hit on
/// a triangle.
[[nodiscard]] float reach_of_hit(const World& world, const Ray& ray, const Hit& hit);

/// Returns whether hit `a` is in front of hit `b` in the same place. Blended and cut-out surfaces
/// are in front of opaque ones; of two surfaces of one kind, the later primitive of the file is in
/// front.
[[nodiscard]] bool in_front(const World& world, const Hit& a, const Hit& b);

/// The filter of a context that collects all hits into Context::met, and keeps none.
void collecting_filter(const RTCFilterFunctionNArguments* args);

}  // namespace asos::tracing
