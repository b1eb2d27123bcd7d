#include "renderer/gltf/accessors.h"
#include "renderer/gltf/compressed.h"
#include "renderer/gltf/document.h"
#include "renderer/gltf/values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <draco/compression/decode.h>
#include <optional>
#include <string_view>
#include <utility>
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

// Returns the number of faces that a Draco stream claims to contain. The decoder allocates memory
// for the claim before it finds out that data is missing, so the claim is read first. Faults: not
// a mesh of bitstream version 2, or cut off.
Checked<std::uint64_t> claimed_draco_faces(Bytes stream) {
  constexpr std::string_view draco_magic = "DRACO";
  if (stream.size() < 11 || !std::equal(draco_magic.begin(), draco_magic.end(), stream.begin())) {
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

// Regular meshes compress to less than one bit per face, but not without limit.
constexpr std::uint64_t most_faces_per_byte = 1024;
constexpr std::uint64_t free_faces = 1024;

float largest_value(draco::DataType type) {
  switch (type) {
    case draco::DT_INT8:
      return 127.0f;
    case draco::DT_UINT8:
      return 255.0f;
    case draco::DT_INT16:
      return 32767.0f;
    case draco::DT_UINT16:
      return 65535.0f;
    default:
      return 1.0f;
  }
}

template <typename T>
Checked<std::vector<T>> values_of(const draco::PointAttribute& attribute, std::size_t points,
                                  int components) {
  std::vector<T> out(points * static_cast<std::size_t>(components));
  std::array<T, 16> value{};
  for (std::size_t i = 0; i < points; ++i) {
    const draco::AttributeValueIndex at =
        attribute.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(i)));
    if (at.value() >= attribute.size() ||
        !attribute.ConvertValue<T>(at, static_cast<std::int8_t>(components), value.data())) {
      return fault("a Draco attribute cannot be converted");
    }
    std::copy_n(value.begin(), components,
                out.begin() + static_cast<std::ptrdiff_t>(i) * components);
  }
  return out;
}

}  // namespace

Checked<DracoPrimitive> DracoPrimitive::decode(const tinygltf::Value& extension,
                                               Accessors& accessors, std::uint64_t index_count) {
  const Checked<Bytes> stream = accessors.view(whole(extension, "bufferView").value_or(-1));
  if (!stream) return fault(stream.error());
  const Checked<std::uint64_t> faces = claimed_draco_faces(*stream);
  if (!faces) return fault("the Draco data " + faces.error());
  if (*faces > index_count / 3 || *faces > stream->size() * most_faces_per_byte + free_faces) {
    return fault(fmt::format("the Draco data claims {} faces where {} are declared", *faces,
                             index_count / 3));
  }

  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(stream->data()), stream->size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) {
    return fault(
        fmt::format("the Draco data cannot be decoded ({})", decoded.status().error_msg_string()));
  }
  DracoPrimitive primitive;
  primitive.mesh_ = std::move(decoded).value();
  if (!extension.Has("attributes")) return fault("the Draco extension names no attributes");
  const tinygltf::Value& names = extension.Get("attributes");
  for (const std::string& name : names.Keys()) {
    const int id = whole(names, name).value_or(-1);
    if (id < 0) continue;
    const auto* attribute = primitive.mesh_->GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
    if (attribute) primitive.attributes_[name] = attribute;
  }
  return primitive;
}

bool DracoPrimitive::has(const std::string& attribute) const {
  return attributes_.contains(attribute);
}

std::size_t DracoPrimitive::vertex_count() const {
  return mesh_->num_points();
}

std::vector<std::uint32_t> DracoPrimitive::indices() const {
  std::vector<std::uint32_t> out;
  out.reserve(static_cast<std::size_t>(mesh_->num_faces()) * 3);
  for (std::uint32_t f = 0; f < mesh_->num_faces(); ++f) {
    for (const draco::PointIndex& point : mesh_->face(draco::FaceIndex(f))) {
      out.push_back(point.value());
    }
  }
  return out;
}

int DracoPrimitive::components(const std::string& attribute) const {
  return attributes_.at(attribute)->num_components();
}

Checked<std::vector<float>> DracoPrimitive::floats(const std::string& name, int components,
                                                   bool normalized) const {
  const draco::PointAttribute& attribute = *attributes_.at(name);
  Checked<std::vector<float>> values = values_of<float>(attribute, vertex_count(), components);
  if (!values || !normalized || attribute.normalized()) return values;
  // Draco normalizes only if its own stream requires it.
  const float scale = 1.0f / largest_value(attribute.data_type());
  for (float& value : *values) value *= scale;
  return values;
}

Checked<std::vector<std::uint32_t>> DracoPrimitive::integers(const std::string& name,
                                                             int components) const {
  return values_of<std::uint32_t>(*attributes_.at(name), vertex_count(), components);
}

}  // namespace asos::gltf
