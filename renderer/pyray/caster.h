#pragma once

#include "renderer/pyray/estimate.h"
#include "renderer/pyray/occluder_plane.h"
#include "renderer/pyray/square.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>

namespace asos {

/// A point sample of a caster, by number.
using SampleId = std::uint32_t;
inline constexpr SampleId no_sample = 0xffffffffu;

/// The property that varies over a leaf, so that its centre differs from its mean.
enum class LeafVariation : std::uint8_t { none, shading, shadow, layers };

/// A caster's choice for a leaf. The engine passes it on with the leaf; `record` identifies the
/// data that the caster collected for it.
struct LeafDecision {
  Estimator estimator = Estimator::centre;
  LeafVariation cause = LeafVariation::none;
  std::uint32_t record = 0;  ///< number of the caster's data; 0: none
  float error = 0.0f;        ///< of the centre, in display intensity, if it is bounded

  [[nodiscard]] bool sampled() const { return estimator == Estimator::samples; }
  [[nodiscard]] bool splits() const { return estimator == Estimator::split; }
};

/// A finished part of a root, represented by one sample.
struct PyrayLeaf {
  std::uint32_t root = 0;  ///< number of the root
  SampleId sample = no_sample;
  double weight = 1.0;  ///< fraction of the root's area
  LeafRegion region;    ///< in the root frame
  LeafDecision decision = {};
  bool defocused = false;  ///< the region is as wide as the blur of the root
};

class LensCaster;

/// The caller of the engine: casts rays through points of the root frame's square and uses the
/// leaves. Each kind of pyray (from the eye, to a light, by reflection) is the same engine with
/// another caster. A caster stores its samples and numbers them.
class Caster {
 public:
  virtual ~Caster() = default;

  /// Casts a ray through each of the points (u, v). They are coherent, so the rays can go in
  /// packets. The samples get consecutive numbers; returns the first.
  virtual SampleId probe(std::span<const glm::vec2> points) = 0;

  /// Returns the handling of defocused roots (lens_caster.h); null: a pinhole camera.
  [[nodiscard]] virtual LensCaster* lens() { return nullptr; }

  /// Called after the roots' centres were sampled: side x side roots, row by row. Their samples are
  /// the first ones.
  virtual void middles_known(int /*side*/) {}

  /// Returns the plane of a sample's surface, which hides boundaries behind it.
  [[nodiscard]] virtual OccluderPlane cover(SampleId sample) const = 0;

  /// Returns the surface of a sample. Equal numbers are one smooth, connected surface.
  [[nodiscard]] virtual std::uint32_t surface(SampleId sample) const = 0;

  /// Returns whether the surface of a sample is opaque.
  [[nodiscard]] virtual bool opaque(SampleId /*sample*/) const { return true; }

  /// Returns whether a leaf with this sample is sampled in any case, so that splitting is useless.
  [[nodiscard]] virtual bool samples_leaf(SampleId /*sample*/) const { return false; }

  /// Returns how to determine a part of a root. The engine then follows the decision; it may be a
  /// split only if `may_split`.
  [[nodiscard]] virtual LeafDecision decide(const PyrayLeaf& /*leaf*/, bool /*may_split*/) {
    return {};
  }

  /// Returns whether `sample_saturated` of a cell costs less than shading the `parts` parts between
  /// its boundaries. `weight` is its fraction of the root's area.
  [[nodiscard]] virtual bool samples_suffice(double /*weight*/, std::size_t /*parts*/) const {
    return false;
  }

  /// Samples a cell that is saturated with boundaries, now or in `finish`. `weight` is its fraction
  /// of the root's area. Returns the sample that represents it. If there is none, the engine uses
  /// jittered leaves of the finest size (design section 5, "Saturation"), or one leaf at MAX.
  [[nodiscard]] virtual SampleId sample_saturated(std::uint32_t /*root*/, const Square& /*square*/,
                                                  double /*weight*/) {
    return no_sample;
  }

  /// Returns whether the samples so far show that subdividing is useless. Used for single pyrays
  /// only.
  [[nodiscard]] virtual bool gives_up() const { return false; }

  /// Returns whether the result is no longer needed. The engine then returns early with an
  /// incomplete result; later samples and leaves need not be valid.
  [[nodiscard]] virtual bool cancelled() const { return false; }

  /// Takes finished leaves, in an order that does not depend on threads. The borders of their
  /// regions are valid during the call only.
  virtual void take(std::span<const PyrayLeaf> leaves) = 0;

  /// Called after all roots are subdivided. Completes everything that was deferred.
  virtual void finish() {}

  /// Returns the result of a leaf's sample for observers: linear radiance, or a light's visibility.
  [[nodiscard]] virtual glm::vec3 result(SampleId /*sample*/) const { return glm::vec3(0.0f); }
  /// Returns the world's triangle at a sample's hit, for observers; 0xffffffff: none.
  [[nodiscard]] virtual std::uint32_t triangle(SampleId /*sample*/) const { return 0xffffffffu; }
};

}  // namespace asos
