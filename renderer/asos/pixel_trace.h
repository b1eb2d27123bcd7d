#pragma once

#include "renderer/film/split_cause.h"
#include "renderer/geometry/view.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/pyray/observer.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace asos {

/// How one pixel was subdivided, as it happened while rendering. All places are in the square that
/// the pixel is the mean of (see RenderSettings::filter_width): x to the right and y down, 0 to 1
/// across it; those of a pyray that a leaf sent on in that pyray's own square.
struct PixelTrace {
  int x = 0;
  int y = 0;
  glm::vec3 radiance{0.0f};        ///< the pixel's, linear
  std::vector<LevelTally> levels;  ///< the papers' tables: K, M, in, out, L for each object
  std::vector<TracedCell> cells;
  std::vector<TracedPyray> pyrays;      ///< those that leaves sent on; Observer::most at most
  double unresolved_area = 0.0;         ///< share of the pixel whose leaves stayed marginal
  int level = 0;                        ///< the pixel's own, as in the split map
  SplitCause cause = SplitCause::none;  ///< as in the split map
  std::uint32_t samples = 0;            ///< of parts that were sampled for what varies in them
  bool missed = false;                  ///< split by the safety net, without a boundary near
};

/// Renders the pixel (x, y) of the picture with ASOS as the settings say, and tells how. The pixel
/// has to lie in the picture; its radiance is bit for bit what a whole rendering gives.
[[nodiscard]] PixelTrace trace_pixel(const RenderScene& scene, const View& view,
                                     const RenderSettings& settings, int x, int y);

}  // namespace asos
