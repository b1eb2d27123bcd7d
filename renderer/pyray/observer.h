#pragma once

#include "renderer/features/feature_edge.h"
#include "renderer/pyray/caster.h"
#include "renderer/pyray/level_statistics.h"
#include "renderer/pyray/square.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

// Records the subdivision of pyrays during rendering. Places are in the pyray's own square: u to
// the right and v down, 0 to 1 across it.

namespace asos {

/// The fate of a cell.
enum class CellFate {
  uniform,  ///< no visible boundary: one sample represents it
  cut,      ///< cut along its boundaries, one sample in each part
  /// No boundary, or cut along them, but its shading varies too much: its four children follow.
  uneven,
  split,      ///< marginal: its four children follow
  stopped,    ///< marginal, but the stopping rule held: one sample
  finest,     ///< marginal at MAX: one sample, or samples distributed over it
  sampled,    ///< no visible boundary, and samples distributed over it
  saturated,  ///< so many boundaries that samples cost less than its parts
  by_samples  ///< split by the safety net, because of its samples
};
/// Returns one or two words, as in `asos trace`.
[[nodiscard]] const char* name_of(CellFate fate);

/// A point sample of a finished leaf.
struct TracedSample {
  static constexpr std::uint32_t no_triangle = 0xffffffffu;

  SampleId id = no_sample;  ///< its number in the caster
  glm::vec2 at{0.0f};
  double weight = 0.0;                   ///< fraction of the pyray
  glm::vec3 radiance{0.0f};              ///< linear; shadows: the visibility of the light
  std::uint32_t triangle = no_triangle;  ///< the world's triangle at its hit
  std::vector<BorderEdge> border{};      ///< sides of the sample's part; empty: the whole cell
};

/// A piece of a boundary that may be visible, clipped to the reach of its cell's detection.
struct TracedBoundary {
  glm::vec2 from{0.0f};
  glm::vec2 to{0.0f};
  FeatureKind kind = FeatureKind::open;  ///< `open` if the boundary is no edge of the scene
};

struct TracedCell {
  int level = 0;
  glm::vec2 corner{0.0f};
  float side = 1.0f;
  CellFate fate = CellFate::uniform;
  std::vector<TracedBoundary> boundaries;
  std::uint32_t clusters = 0;  ///< groups of boundaries that were not resolved
  std::uint32_t hidden = 0;    ///< boundaries, or groups, behind the cell's surface
  std::vector<TracedSample> samples;
};

/// A pyray of a pixel, or one cast by a leaf: to a light, or by reflection.
struct TracedPyray {
  enum class Kind { eye, shadow, mirror };

  Kind kind = Kind::eye;
  std::uint32_t light = 0;  ///< shadow: index of the light
  int bounces = 0;          ///< number of mirrors before this pyray
  int parent = -1;          ///< number of the reflected pyray whose leaf cast it; -1: the pixel
  glm::vec2 from{0.0f};     ///< that leaf's sample, in the parent's square
  double weight = 1.0;      ///< that leaf's fraction of the parent
  glm::vec3 result{0.0f};   ///< mean radiance along it; shadow: the light's visibility
  std::vector<LevelStatistics>
      levels;  ///< the papers' tables: K, M, in, out, L; those with marginal cells
  std::vector<TracedCell> cells;  ///< level by level

  /// Sets the radiance of a sample's part, where that is known later than the cells.
  void note(SampleId sample, glm::vec3 radiance) {
    for (TracedCell& cell : cells)
      for (TracedSample& of_cell : cell.samples)
        if (of_cell.id == sample) of_cell.radiance = radiance;
  }
};

/// Records one pixel's pyrays while they are traced, including up to `most` of those cast by its
/// leaves.
class Observer {
 public:
  static constexpr std::size_t most = 500;

  TracedPyray pixel;
  std::vector<TracedPyray> nested;  ///< in the order in which they were traced

  [[nodiscard]] TracedPyray& at(int number) {
    return number < 0 ? pixel : nested[static_cast<std::size_t>(number)];
  }
};

/// The observer for one pyray's leaves; null if there is none.
struct ObservedLeaf {
  Observer* observer = nullptr;
  int pyray = -1;      ///< number of the leaf's pyray
  glm::vec2 at{0.0f};  ///< the leaf's sample, in the pyray's square
  double weight = 1.0;

  [[nodiscard]] bool wants_more() const {
    return observer && observer->nested.size() < Observer::most;
  }
  /// Begins a pyray cast by the leaf and returns its number.
  [[nodiscard]] int begin(TracedPyray::Kind kind) const {
    TracedPyray& sent = observer->nested.emplace_back();
    sent.kind = kind;
    sent.parent = pyray;
    sent.from = at;
    sent.weight = weight;
    return static_cast<int>(observer->nested.size()) - 1;
  }
};

}  // namespace asos
