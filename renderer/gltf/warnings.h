#pragma once

#include <tl/expected.hpp>

#include <cstddef>
#include <string>
#include <unordered_set>
#include <vector>

namespace asos::gltf {

/// A value, or a description of why the file does not have it.
template <typename T>
using Checked = tl::expected<T, std::string>;

/// Shortens a text to at most 500 bytes. A longer one, with names from a file, loses its middle.
[[nodiscard]] std::string shortened(const std::string& text);

inline tl::unexpected<std::string> fault(const std::string& reason) {
  return tl::unexpected<std::string>(shortened(reason));
}

/// The faults that the importer repaired or ignored, each listed once. A broken file can have a
/// million faults, so the list is bounded and its last line counts the rest. Texts may contain
/// names from the file; they are stored in a form that is safe to display.
class Warnings {
 public:
  /// Adds a fault that loses nothing.
  void add(const std::string& text);
  /// Adds a fault that loses something to draw. If nothing is left to draw, this becomes the error.
  void add_loss(const std::string& text);

  [[nodiscard]] const std::string& first_loss() const { return first_loss_; }
  /// Returns the number of faults beyond the list's limit.
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
