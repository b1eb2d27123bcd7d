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
/// each time. A cubic spline has three times as many: in-tangents, values and out-tangents.
struct Keys {
  Interpolation interpolation = Interpolation::linear;
  bool rotation = false;  ///< quaternions x, y, z, w, interpolated along the shortest arc
  std::size_t width = 0;
  std::shared_ptr<const std::vector<float>> seconds;  ///< not empty; at least 0, not decreasing
  std::shared_ptr<const std::vector<float>> values;   ///< finite

  /// Returns the `width` numbers at a time. Before the first key they are those of the first, and
  /// after the last those of the last. Rotations are unit quaternions.
  [[nodiscard]] std::vector<double> at(double time) const;

 private:
  [[nodiscard]] double number(std::size_t key, std::size_t group, std::size_t i) const;
  [[nodiscard]] std::vector<double> value(std::size_t key) const;
  [[nodiscard]] std::vector<double> between(std::size_t key, double share) const;
  [[nodiscard]] std::vector<double> spline(std::size_t key, double share) const;
};

/// Reads samplers. Data that several of them share is read once. Their total size is limited by the
/// size of the file.
class KeyReader {
 public:
  KeyReader(const Document& document, Accessors& accessors);

  /// Reads a sampler. An element of the output has `components` numbers, and a key's value has
  /// `groups` elements; with `rotation` it is a quaternion. Faults: no such data, times that
  /// decrease or are below 0, numbers that are not finite, not one value for each time, a rotation
  /// of length 0, an unknown interpolation.
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
