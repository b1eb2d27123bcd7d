#pragma once

#include "renderer/pyray/cover.h"
#include "renderer/pyray/square.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>

namespace asos {

/// A point sample of a caster, by number.
using SampleId = std::uint32_t;
inline constexpr SampleId no_sample = 0xffffffffu;

/// The property that varies over a leaf, so that its centre differs from its mean.
enum class Unevenness : std::uint8_t { none, shading, shadow, layers };

/// The way a leaf is determined (design section 14).
enum class Estimator : std::uint8_t {
  centre,   ///< one sample stands for it
  samples,  ///< the mean of samples all over it
  split,    ///< by its four quarters
};

/// A caster's choice for a leaf. The engine hands it on with the leaf: the caster finds in `record`
/// what it learned on the way.
struct LeafDecision {
  Estimator estimator = Estimator::centre;
  Unevenness cause = Unevenness::none;
  std::uint32_t record = 0;  ///< the caster's number; 0: nothing
  float error = 0.0f;        ///< of the centre, in display intensity, as far as it has a bound

  [[nodiscard]] bool sampled() const { return estimator == Estimator::samples; }
  [[nodiscard]] bool splits() const { return estimator == Estimator::split; }
};

/// A finished part of a root, for which one sample stands.
struct PyrayLeaf {
  std::uint32_t root = 0;  ///< number of the root
  SampleId sample = no_sample;
  double weight = 1.0;  ///< share of the root's area
  LeafRegion region;    ///< in the root frame
  LeafDecision decision = {};
  bool defocused = false;  ///< its region is as wide as a lens blurs its root
};

class LensCaster;

/// The side that asks the engine: knows how to look along points of the root frame's square, and
/// what to make of the leaves. Each kind of pyray (from the eye, to a light, by way of a mirror) is
/// the same engine behind another caster. A caster keeps its samples and numbers them.
class Caster {
 public:
  virtual ~Caster() = default;

  /// Looks along each of the points (u, v): coherent, so they can go in packets. The samples get
  /// consecutive numbers; returns the first.
  virtual SampleId probe(std::span<const glm::vec2> points) = 0;

  /// Roots that a lens blurs (lens_caster.h); null: a pinhole's.
  [[nodiscard]] virtual LensCaster* lens() { return nullptr; }

  /// The roots' middles were looked through: side x side roots in rows, whose samples are the
  /// first.
  virtual void middles_known(int /*side*/) {}

  /// The plane of the surface that a sample met, which hides boundaries behind it.
  [[nodiscard]] virtual Cover cover(SampleId sample) const = 0;

  /// The surface that a sample met: equal numbers for one smooth, connected piece.
  [[nodiscard]] virtual std::uint32_t surface(SampleId sample) const = 0;

  /// Whether nothing is seen through the surface that a sample met.
  [[nodiscard]] virtual bool opaque(SampleId /*sample*/) const { return true; }

  /// Whether a leaf of this sample is sampled all over whatever bounds it: splitting is no use.
  [[nodiscard]] virtual bool samples_leaf(SampleId /*sample*/) const { return false; }

  /// How to determine a part of a root, of that weight, whose sample is known. The engine splits it
  /// if that is the decision, which it may be only where `may_split`.
  [[nodiscard]] virtual LeafDecision decide(SampleId /*sample*/, double /*weight*/,
                                            const LeafRegion& /*region*/, bool /*may_split*/) {
    return {};
  }

  /// Whether `sample_saturated` of a cell costs less than to shade the so many parts that
  /// boundaries cut it into; `weight` is its share of the root's area.
  [[nodiscard]] virtual bool samples_suffice(double /*weight*/, std::size_t /*parts*/) const {
    return false;
  }

  /// Asks for samples of a cell that is saturated with boundaries, now or until `finish`; `weight`
  /// is its share of the root's area. The sample that stands for them; none: the engine takes
  /// jittered leaves of the finest size (design section 5, "Saturation"), or at MAX one leaf.
  [[nodiscard]] virtual SampleId sample_saturated(std::uint32_t /*root*/, const Square& /*square*/,
                                                  double /*weight*/) {
    return no_sample;
  }

  /// Whether the samples so far show that subdividing is hopeless. Asked of single pyrays only.
  [[nodiscard]] virtual bool gives_up() const { return false; }

  /// True once nobody wants the result any more. The engine then returns early, with whatever it
  /// has; samples and leaves need not be meant from then on.
  [[nodiscard]] virtual bool cancelled() const { return false; }

  /// Finished leaves, in an order that does not depend on threads. Their regions' borders live for
  /// the call.
  virtual void take(std::span<const PyrayLeaf> leaves) = 0;

  /// All roots are subdivided: whatever was put off has to be done now.
  virtual void finish() {}

  /// The result of a sample that stood for a leaf, for observers: linear radiance, or a light's
  /// visibility.
  [[nodiscard]] virtual glm::vec3 result(SampleId /*sample*/) const { return glm::vec3(0.0f); }
  /// The world's triangle that a sample met, for observers; 0xffffffff: none.
  [[nodiscard]] virtual std::uint32_t triangle(SampleId /*sample*/) const { return 0xffffffffu; }
};

}  // namespace asos
