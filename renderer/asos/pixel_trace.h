#pragma once

#include "renderer/features/feature_edge.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/pyray/pyray_log.h"
#include "renderer/pyray/subdivision_trace.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace asos {

// How one pixel was subdivided, as it happened while rendering. All places are in the square that
// the pixel is the mean of (see RenderSettings::filter_width): x to the right and y down, 0 to 1
// across it.

/// A point sample of a finished leaf.
struct PixelTraceSample {
  glm::vec2 at{0.0f};
  double weight = 0.0;                 ///< share of the pixel
  glm::vec3 radiance{0.0f};            ///< linear
  std::uint32_t triangle = Hit::none;  ///< of the world; Hit::none: the background
};

/// A piece of a boundary that may be visible, clipped to what the detection of its cell reaches.
struct PixelTraceBoundary {
  glm::vec2 from{0.0f};
  glm::vec2 to{0.0f};
  FeatureKind kind = FeatureKind::open;
};

struct PixelTraceCell {
  int level = 0;
  glm::vec2 corner{0.0f};
  float side = 1.0f;
  CellFate fate = CellFate::uniform;
  std::vector<PixelTraceBoundary> boundaries;
  std::uint32_t clusters = 0;  ///< groups of boundaries that were not told apart
  std::uint32_t hidden = 0;    ///< boundaries, or groups, behind what the cell shows
  std::vector<PixelTraceSample> samples;
};

/// A pyray that one of the pixel's leaves sent on, to a light or by way of a mirror. Its cells'
/// places are in its own square, and their samples' radiance is the share of the light that is
/// seen, or what is mirrored.
struct PixelTracePyray {
  LoggedPyray::Kind kind = LoggedPyray::Kind::shadow;
  std::uint32_t light = 0;  ///< shadow: index into World::lights
  int bounces = 0;          ///< mirrors before it
  int parent = -1;          ///< in PixelTrace::pyrays; -1: the pixel itself
  glm::vec2 from{0.0f};     ///< its leaf's sample, in the parent's square
  double weight = 1.0;      ///< that leaf's share of the parent
  glm::vec3 result{0.0f};   ///< mean radiance that comes back; shadow: the light's lit share
  std::vector<PixelTraceCell> cells;
};

struct PixelTrace {
  int x = 0;
  int y = 0;
  glm::vec3 radiance{0.0f};        ///< the pixel's, linear
  std::vector<LevelTally> levels;  ///< the papers' tables: K, M, in, out, L for each object
  std::vector<PixelTraceCell> cells;
  std::vector<PixelTracePyray> pyrays;  ///< those that were subdivided; PyrayLog::most at most
  double unresolved_area = 0.0;         ///< share of the pixel whose leaves stayed marginal
  bool missed = false;                  ///< split by the safety net, without a boundary near
};

/// Renders the pixel (x, y) of the picture with ASOS as the settings say, and tells how. The pixel
/// has to lie in the picture; its radiance is bit for bit what a whole rendering gives.
[[nodiscard]] PixelTrace trace_pixel(const RenderScene& scene, const View& view,
                                     const RenderSettings& settings, int x, int y);

}  // namespace asos
