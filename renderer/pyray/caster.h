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

/// Why one sample cannot stand for what a patch of a surface looks like.
enum class Unevenness : std::uint8_t { none, shading, shadow };

/// Whether many samples of a leaf take the place of its one.
enum class BySamples : std::uint8_t {
  no,
  cheaper,  ///< it is uneven, and they cost less than its parts
  only,     ///< nothing but samples tells what it shows
};

/// A caster's word on whether one sample can stand for a leaf. The engine hands it on with the
/// leaf: a caster finds in `note` what it learned on the way (0: nothing).
struct LeafVerdict {
  Unevenness uneven = Unevenness::none;
  std::uint32_t note = 0;
  BySamples by_samples = BySamples::no;
  bool given = true;  ///< false: nobody was asked, for the leaf could not be split

  [[nodiscard]] bool sampled() const { return by_samples != BySamples::no; }
  [[nodiscard]] bool splits() const { return uneven != Unevenness::none && !sampled(); }

  [[nodiscard]] static LeafVerdict none() { return {Unevenness::none, 0, BySamples::no, false}; }
};

/// A finished part of a root, for which one sample stands.
struct PyrayLeaf {
  std::uint32_t root = 0;  ///< number of the root
  SampleId sample = no_sample;
  double weight = 1.0;  ///< share of the root's area
  LeafRegion region;    ///< in the root frame
  LeafVerdict verdict = LeafVerdict::none();
};

/// The side that asks the engine: knows how to look along points of the root frame's square, and
/// what to make of the leaves. Each kind of pyray (from the eye, to a light, by way of a mirror) is
/// the same engine behind another caster. A caster keeps its samples and numbers them.
class Caster {
 public:
  virtual ~Caster() = default;

  /// Looks along each of the points (u, v): coherent, so they can go in packets. The samples get
  /// consecutive numbers; returns the first.
  virtual SampleId probe(std::span<const glm::vec2> points) = 0;

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

  /// Whether one sample can stand for a part of a root, which is `share` of its area, or shading or
  /// shadows vary over it by more than the tolerance. The engine then splits it, down to MAX.
  [[nodiscard]] virtual LeafVerdict judge(SampleId /*sample*/, double /*share*/,
                                          const LeafRegion& /*region*/) {
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
