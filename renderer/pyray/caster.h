#pragma once

#include "renderer/pyray/cover.h"
#include "renderer/pyray/square.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>

namespace asos {

/// Why one sample cannot stand for what a patch of a surface looks like.
enum class Unevenness : std::uint8_t { none, shading, shadow };

/// What asks the engine: knows how to look along points of the root frame's square, and what to do
/// with what it saw. Eye, shadow and reflection pyrays are the same engine behind different
/// casters. Samples are kept by the caster and named by number.
class Caster {
 public:
  using SampleId = std::uint32_t;
  static constexpr SampleId no_sample = 0xffffffffu;

  virtual ~Caster() = default;

  /// Looks along each of the points (u, v): coherent, so they can go in packets. The samples get
  /// consecutive numbers; returns the first.
  virtual SampleId probe(std::span<const glm::vec2> points) = 0;

  /// What the surface that a sample met hides.
  [[nodiscard]] virtual Cover cover(SampleId sample) const = 0;

  /// The surface that a sample met: equal numbers for one smooth, connected piece.
  [[nodiscard]] virtual std::uint32_t surface(SampleId sample) const = 0;

  /// Whether one sample cannot stand for what a patch of the surface around it looks like, because
  /// its shading or a shadow on it varies by more than is let pass. `share` is the patch's share of
  /// its root's area. The engine then splits the patch further, down to MAX.
  [[nodiscard]] virtual Unevenness uneven(SampleId /*sample*/, double /*share*/,
                                          const LeafRegion& /*region*/) const {
    return Unevenness::none;
  }

  /// What was made of a square that a caster took over.
  struct TakenOver {
    std::uint32_t samples = 0;    ///< 0: it was not
    SampleId sample = no_sample;  ///< that stands for all of them
  };
  /// Asks to take over a square of the root `root` whose boundaries are a tangle; `weight` is its
  /// share of the root's area. Otherwise the engine takes jittered leaves of the finest size
  /// (design section 5, "Saturation").
  [[nodiscard]] virtual TakenOver sample_tangle(std::uint32_t /*root*/, const Square& /*square*/,
                                                double /*weight*/) {
    return {};
  }

  /// True once nobody wants the result any more. The engine then returns early, with whatever it
  /// has; samples and leaves need not be meant from then on.
  [[nodiscard]] virtual bool cancelled() const { return false; }

  /// A finished leaf of the root whose id is `root`; `weight` is its share of the root's area, the
  /// region what it covers of the root frame.
  virtual void leaf(std::uint32_t root, SampleId sample, double weight,
                    const LeafRegion& region) = 0;
};

}  // namespace asos
