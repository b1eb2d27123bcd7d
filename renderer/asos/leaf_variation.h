#pragma once

#include "renderer/film/tone.h"
#include "renderer/pyray/caster.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// A leaf as it was shaded by its one sample.
struct ShadedLeaf {
  PyrayLeaf leaf;                 ///< without its border
  std::uint32_t surface = 0;      ///< that its sample met
  glm::vec2 at{0.0f};             ///< its sample, in the frame
  glm::vec3 radiance{0.0f};       ///< that its root got
  glm::vec3 shading{0.0f};        ///< the same but for what is exact: shadows and flat mirrors
  std::uint32_t weak_lights = 0;  ///< number of its share of the weak lights
  std::uint32_t sky = 0;          ///< and of the sky
  std::optional<std::uint32_t> lobes = {};  ///< and of what lobes mirror, if any does
};

/// What the leaves of a root tell about each other: where those of one surface differ, their one
/// samples cannot stand for what they show, whatever was expected of the surface beforehand.
class LeafVariation {
 public:
  /// Judges what the leaves show by that curve.
  explicit LeafVariation(ToneCurve judged_tone = ToneCurve::none) : judged_tone_(judged_tone) {}

  void add(const ShadedLeaf& leaf);

  /// The leaves of those surfaces, root by root, whose samples are expected to be off by more than
  /// `tolerance` in display intensity all together; none is kept then. What varies evenly across a
  /// root is no error: it is what the samples differ from a plane through them that counts, so that
  /// fewer than four tell nothing. Regions are valid until the next `add`.
  [[nodiscard]] std::vector<ShadedLeaf> take_uneven(double tolerance);

 private:
  [[nodiscard]] bool uneven(std::span<const std::uint32_t> group, double tolerance) const;

  ToneCurve judged_tone_;
  std::vector<ShadedLeaf> leaves_;
  std::vector<std::size_t> first_edge_;  // of each leaf's border
  std::vector<BorderEdge> borders_;
  std::vector<BorderEdge> taken_;
};

}  // namespace asos
