#pragma once

#include "renderer/gltf/accessors.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace asos::gltf {

enum class Interpolation { step, linear, cubic_spline };

/// The keys of an animation's sampler (glTF 2.0, section 3.11 and appendix C): `width` numbers at
/// each time; those of a cubic spline are its in-tangents, its values and its out-tangents.
struct Keys {
  Interpolation interpolation = Interpolation::linear;
  bool rotation = false;  ///< quaternions x, y, z, w, whose shortest arcs are followed
  std::size_t width = 0;
  std::shared_ptr<const std::vector<float>> seconds;  ///< not empty; at least 0, never falling
  std::shared_ptr<const std::vector<float>> values;   ///< finite

  /// The `width` numbers at a time: of the first key before it, of the last one after it. Rotations
  /// come out as unit quaternions.
  [[nodiscard]] std::vector<double> at(double time) const;

 private:
  [[nodiscard]] double number(std::size_t key, std::size_t group, std::size_t i) const;
  [[nodiscard]] std::vector<double> value(std::size_t key) const;
  [[nodiscard]] std::vector<double> between(std::size_t key, double share) const;
  [[nodiscard]] std::vector<double> spline(std::size_t key, double share) const;
};

/// Reads samplers. Data that several of them share is read once; what all of them hold together is
/// bounded by the size of the file.
class KeyReader {
 public:
  KeyReader(const Document& document, Accessors& accessors);

  /// `components`: of one of an output's elements, `groups` of which are a key's value; four of a
  /// `rotation` are a quaternion.
  /// Faults: no such data, times that fall or are below 0, numbers that are not finite, not one
  /// value for each time, a rotation of no length, an unknown interpolation.
  [[nodiscard]] Checked<Keys> read(const tinygltf::AnimationSampler& sampler, int components,
                                   std::size_t groups, bool rotation);

 private:
  using Numbers = std::shared_ptr<const std::vector<float>>;
  [[nodiscard]] Checked<Numbers> numbers(int accessor, int components);

  Accessors& accessors_;
  std::uint64_t budget_bytes_ = 0;
  std::map<std::pair<int, int>, Numbers> known_;  // by accessor and components
};

}  // namespace asos::gltf
