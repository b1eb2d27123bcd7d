#pragma once

#include <tl/expected.hpp>

#include <cstddef>
#include <string>
#include <unordered_set>
#include <vector>

namespace asos::gltf {

/// A value, or in words why the file does not yield it.
template <typename T>
using Checked = tl::expected<T, std::string>;

/// A remark of at most 500 bytes: a longer one, whose names a file chose, loses its middle.
[[nodiscard]] std::string shortened(const std::string& text);

inline tl::unexpected<std::string> fault(const std::string& reason) {
  return tl::unexpected<std::string>(shortened(reason));
}

/// The faults that the importer repaired or ignored, each said once. A broken file can have a
/// million faults, so the list is bounded and its last line counts the rest. Texts may hold names
/// as the file has them; they are kept as they may be shown.
class Warnings {
 public:
  /// Something is wrong, but nothing is lost by it.
  void add(const std::string& text);
  /// Something that should be drawn is lost. If nothing is left to draw, this becomes the error.
  void add_loss(const std::string& text);

  [[nodiscard]] const std::string& first_loss() const { return first_loss_; }
  /// How many there were beyond the list's bound.
  [[nodiscard]] std::size_t dropped() const { return dropped_; }
  [[nodiscard]] std::vector<std::string> take();

 private:
  std::vector<std::string> texts_;
  std::unordered_set<std::string> seen_;
  std::string last_;
  std::string first_loss_;
  std::size_t dropped_ = 0;
};

}  // namespace asos::gltf
