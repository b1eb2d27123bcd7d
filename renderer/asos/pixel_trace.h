#pragma once

#include "renderer/film/split_cause.h"
#include "renderer/geometry/view.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/pyray/observer.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace asos {

/// The subdivision of one pixel, recorded while it was rendered. Places are in the pixel's square
/// (see RenderSettings::filter_width): x to the right and y down, 0 to 1 across it. Places of a
/// pyray cast by a leaf are in that pyray's own square.
struct PixelTrace {
  int x = 0;
  int y = 0;
  glm::vec3 radiance{0.0f};             ///< the pixel's, linear
  std::vector<LevelStatistics> levels;  ///< the papers' tables: K, M, in, out, L for each object
  std::vector<TracedCell> cells;
  std::vector<TracedPyray> pyrays;      ///< cast by leaves; at most Observer::most
  double unresolved_area = 0.0;         ///< fraction of the pixel whose leaves stayed marginal
  int level = 0;                        ///< level of the pixel, as in the split map
  SplitCause cause = SplitCause::none;  ///< as in the split map
  std::uint32_t samples = 0;            ///< of parts that were sampled
  bool missed = false;                  ///< split by the safety net, without a boundary nearby
};

/// Renders the pixel (x, y) of the picture with ASOS and records its subdivision. The pixel has to
/// lie in the picture. Its radiance is that of a whole rendering, bit for bit.
[[nodiscard]] PixelTrace trace_pixel(const RenderScene& scene, const View& view,
                                     const RenderSettings& settings, int x, int y);

}  // namespace asos
