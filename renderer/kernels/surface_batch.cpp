#include "renderer/kernels/surface_batch.h"

namespace asos {

SurfacePoint surface_at(const TriangleBatch& hits, const SurfaceRest& rest, const LitBatch& points,
                        std::uint32_t triangle, std::size_t i) {
  SurfacePoint point;
  point.position = points.position.at(i);
  point.error = rest.error.at(i);
  point.geometric_normal = points.geometric.at(i);
  point.shading_normal = points.normal.at(i);
  point.extent = rest.extent[i];
  point.to_edge = points.to_edge[i];
  point.triangle = triangle;
  point.footprint = footprint_at(hits, rest, i);
  point.spread = {points.spread_right.at(i), points.spread_down.at(i), points.spread_variance[i]};
  return point;
}

}  // namespace asos
