#pragma once

#include "renderer/gltf/document.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace asos::gltf {

/// The selected elements of an attribute, ascending; nullopt: all of them.
using Selection = std::optional<std::vector<std::uint32_t>>;

/// Reads typed data from a document's buffers. Everything is range-checked with 64 bits before it
/// is read or allocated, whatever the file declares. One thread.
class Accessors {
 public:
  explicit Accessors(Document& document) : doc_(document) {}

  /// Returns the number of elements that the accessor declares and that exist. Faults: it reaches
  /// outside its buffer, or it has no data and declares more bytes than the file has.
  [[nodiscard]] Checked<std::size_t> count(int accessor);

  /// Returns the elements as floats, `components` each. Normalised integers become [0, 1] or [-1,
  /// 1]; other integers keep their value.
  [[nodiscard]] Checked<std::vector<float>> floats(int accessor, int components,
                                                   const Selection& selection = std::nullopt);
  /// Returns the number of components of an element.
  [[nodiscard]] Checked<int> components(int accessor) const;

  [[nodiscard]] bool normalized(int accessor) const;
  /// Returns the count that the accessor declares, even if there is no data.
  [[nodiscard]] Checked<std::uint64_t> declared_count(int accessor) const;
  [[nodiscard]] bool has_data(int accessor) const;
  /// Returns the largest value of the accessor's (unsigned) type.
  [[nodiscard]] std::uint32_t largest_integer(int accessor) const;

  /// Returns unsigned integers (indices: 1 component, joints: 4).
  [[nodiscard]] Checked<std::vector<std::uint32_t>> integers(
      int accessor, int components, const Selection& selection = std::nullopt);

  /// Resets the count of bytes read from accessors without data, for example to read the whole file
  /// again.
  void forget_zeros() { zeros_ = 0; }

  /// Returns a buffer view's bytes, decompressed if it has EXT_meshopt_compression.
  [[nodiscard]] Checked<Bytes> view(int buffer_view);
  /// Returns bytes of a buffer. Faults: out of range, or the buffer is missing.
  [[nodiscard]] Checked<Bytes> slice(std::int64_t buffer, std::uint64_t offset,
                                     std::uint64_t length) const;

 private:
  struct Elements;
  [[nodiscard]] Checked<const tinygltf::Accessor*> find(int accessor) const;
  [[nodiscard]] Checked<Elements> locate(int accessor);
  template <typename Out, typename Convert>
  Checked<std::vector<Out>> read(int accessor, int components, const Selection& selection,
                                 Convert convert);
  template <typename Out, typename Convert>
  Checked<void> apply_sparse(const tinygltf::Accessor& accessor, int components,
                             std::vector<Out>& values, Convert convert);

  Document& doc_;
  std::uint64_t zeros_ = 0;                          // bytes read from accessors without data
  std::unordered_map<int, FileBytes> decompressed_;  // by buffer view
  std::uint64_t decompressed_bytes_ = 0;             // total size of `decompressed_`
};

template <typename Vector>
std::vector<Vector> as_vectors(const std::vector<float>& floats) {
  constexpr int n = Vector::length();
  std::vector<Vector> vectors(floats.size() / n);
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    for (int c = 0; c < n; ++c) vectors[i][c] = floats[i * n + static_cast<std::size_t>(c)];
  }
  return vectors;
}

}  // namespace asos::gltf
