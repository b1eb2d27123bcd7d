#include "asos/trace.h"

#include "renderer/api/convert.h"
#include "renderer/api/ready_picture.h"
#include "renderer/api/scene_impl.h"
#include "renderer/asos/pixel_trace.h"
#include "renderer/comparison/method.h"

#include <fmt/format.h>

#include <utility>

namespace asos::api {
namespace {

TracedCell cell_of(const asos::TracedCell& from) {
  TracedCell to{from.level, from.corner.x, from.corner.y, from.side, name_of(from.fate), {}, {}};
  for (const TracedBoundary& edge : from.boundaries)
    to.edges.push_back({edge.from.x, edge.from.y, edge.to.x, edge.to.y});
  for (const asos::TracedSample& sample : from.samples)
    to.samples.push_back({sample.at.x, sample.at.y, sample.weight, array_of(sample.radiance)});
  return to;
}

}  // namespace

Result<PixelTrace> trace_pixel(const Scene& scene, const Camera& camera, const Settings& settings,
                               int x, int y) {
  return guarded("trace", [&]() -> Result<PixelTrace> {
    Result<ReadyPicture> ready = ready_picture(scene, camera, settings);
    if (!ready) return ready.error();
    Snapshot& snapshot = ready->snapshot;
    if (!in_object_space(snapshot.settings.method))
      return failure(ErrorCode::invalid_argument, "method",
                     "only asos and asos-published split pixels");
    if (x < 0 || y < 0 || x >= settings.width || y >= settings.height)
      return failure(ErrorCode::invalid_argument, "pixel",
                     fmt::format("{},{} lies outside the picture of {}x{} pixels", x, y,
                                 settings.width, settings.height));
    if (const auto found = with_boundaries(snapshot.scene); !found)
      return failure(ErrorCode::out_of_memory, found.error());
    const RenderSettings wanted = as_published(snapshot.settings);
    const View view(viewed_camera(*snapshot.scene, snapshot.camera, wanted), wanted.width,
                    wanted.height, radius_around_origin(snapshot.scene->world().bounds));
    const asos::PixelTrace traced = asos::trace_pixel(*snapshot.scene, view, wanted, x, y);
    PixelTrace trace;
    trace.radiance = array_of(traced.radiance);
    trace.level = traced.level;
    trace.cause = name_of(traced.cause);
    trace.unresolved_area = traced.unresolved_area;
    for (const asos::TracedCell& cell : traced.cells) trace.cells.push_back(cell_of(cell));
    return trace;
  });
}

}  // namespace asos::api
