#include "renderer/kernels/surface_batch.h"

namespace asos {

SurfacePoint surface_at(const TriangleBatch& hits, const SurfaceRest& rest,
                        const ShadingPoints& points, std::uint32_t triangle, std::size_t i) {
  SurfacePoint point;
  point.position = rest.position.at(i);
  point.error = rest.error.at(i);
  point.geometric_normal = rest.geometric.at(i);
  point.lift = rest.lift.at(i);
  point.smooth_normal = rest.smooth_normal.at(i);
  point.shading_normal = points.normal.at(i);
  point.extent = rest.extent[i];
  point.to_edge = points.to_edge[i];
  point.triangle = triangle;
  point.footprint = footprint_at(hits, rest, i);
  point.spread = {points.spread_right.at(i), points.spread_down.at(i), points.spread_variance[i]};
  return point;
}

}  // namespace asos
