#pragma once

#include "asos/error.h"
#include "asos/scene.h"
#include "asos/settings.h"

#include <string>
#include <vector>

namespace asos::api {

/// A point sample of a cell. Places run from 0 to 1 across the pixel, x to the right and y down.
struct TracedSample {
  float x = 0.0f;
  float y = 0.0f;
  double weight = 0.0;       ///< area, as a share of the pixel
  Float3 radiance{0, 0, 0};  ///< linear
};

/// A piece of an edge that passes through a cell.
struct TracedEdge {
  float from_x = 0.0f;
  float from_y = 0.0f;
  float to_x = 0.0f;
  float to_y = 0.0f;
};

/// A square of the pixel's subdivision.
struct TracedCell {
  int level = 0;
  float x = 0.0f;  ///< its upper left corner
  float y = 0.0f;
  float side = 1.0f;
  /// "uniform", "cut", "uneven", "split", "stopped", "finest", "sampled", "saturated" or
  /// "by samples".
  std::string fate = {};
  std::vector<TracedEdge> edges = {};
  std::vector<TracedSample> samples = {};
};

/// How one pixel was subdivided.
struct PixelTrace {
  Float3 radiance{0, 0, 0};            ///< linear; the same bits as in the whole picture
  int level = 0;                       ///< as in layer "level"
  std::string cause = {};              ///< see `cause_name`
  double unresolved_area = 0.0;        ///< share of the pixel that stayed marginal
  std::vector<TracedCell> cells = {};  ///< level by level
};

/// Renders the pixel (x, y) of the picture and records its subdivision. Blocks; any thread. The
/// method has to be "asos" or "asos-published". Fails as `render` does, and with `invalid_argument`
/// for a pixel outside the picture.
[[nodiscard]] ASOS_API Result<PixelTrace> trace_pixel(const Scene& scene, const Camera& camera,
                                                      const Settings& settings, int x, int y);

}  // namespace asos::api
