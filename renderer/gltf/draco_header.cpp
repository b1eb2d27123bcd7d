#include "renderer/gltf/draco_header.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

namespace asos::gltf {

namespace {

/// Reads a stream sequentially; past its end every read fails.
class Reader {
 public:
  explicit Reader(Bytes bytes) : bytes_(bytes) {}

  std::optional<std::uint64_t> byte() {
    if (at_ >= bytes_.size()) return std::nullopt;
    return bytes_[at_++];
  }
  /// Reads a number with seven bits per byte, the lowest first.
  std::optional<std::uint64_t> varint() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 63; shift += 7) {
      const auto b = byte();
      if (!b) return std::nullopt;
      value |= (*b & 0x7f) << shift;
      if (*b < 0x80) return value;
    }
    return std::nullopt;
  }
  bool skip(std::uint64_t count) {
    if (count > bytes_.size() - at_) return false;
    at_ += static_cast<std::size_t>(count);
    return true;
  }

 private:
  Bytes bytes_;
  std::size_t at_ = 0;
};

bool skip_name(Reader& reader) {
  const auto length = reader.byte();
  return length && reader.skip(*length);
}

/// Skips a metadata element: entries of name and value, then named elements of the same kind.
bool skip_metadata(Reader& reader) {
  std::vector<std::uint64_t> left{1};  // elements still to read at each level
  while (!left.empty()) {
    if (left.back() == 0) {
      left.pop_back();
      continue;
    }
    --left.back();
    if (left.size() > 1 && !skip_name(reader)) return false;
    const auto entries = reader.varint();
    if (!entries) return false;
    for (std::uint64_t i = 0; i < *entries; ++i) {
      if (!skip_name(reader)) return false;
      const auto size = reader.varint();
      if (!size || !reader.skip(*size)) return false;
    }
    const auto children = reader.varint();
    if (!children || left.size() > 1000) return false;
    left.push_back(*children);
  }
  return true;
}

bool skip_all_metadata(Reader& reader) {
  const auto attributes = reader.varint();
  if (!attributes) return false;
  for (std::uint64_t i = 0; i < *attributes; ++i) {
    if (!reader.varint() || !skip_metadata(reader)) return false;
  }
  return skip_metadata(reader);
}

}  // namespace

Checked<std::uint64_t> claimed_draco_faces(Bytes stream) {
  constexpr std::string_view magic = "DRACO";
  if (stream.size() < 11 || !std::equal(magic.begin(), magic.end(), stream.begin())) {
    return fault("is not a Draco stream");
  }
  if (stream[5] != 2) return fault("has a Draco version other than 2");
  if (stream[7] != 1) return fault("holds a Draco point cloud, not a mesh");
  const bool edgebreaker = stream[8] == 1;
  const bool has_metadata = (stream[10] & 0x80) != 0;
  Reader reader(stream.subspan(11));
  if (has_metadata && !skip_all_metadata(reader)) return fault("has broken Draco metadata");
  if (edgebreaker) {
    reader.byte();  // kind of traversal
    // Before version 2.2 the number of new vertices came first.
    if (stream[6] < 2) reader.varint();
    reader.varint();  // number of encoded vertices
  }
  const auto faces = reader.varint();
  if (!faces) return fault("is a Draco stream that is cut off");
  return *faces;
}

}  // namespace asos::gltf
