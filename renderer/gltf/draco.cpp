#include "renderer/gltf/accessors.h"
#include "renderer/gltf/compressed.h"
#include "renderer/gltf/draco_header.h"
#include "renderer/gltf/values.h"

#include <fmt/format.h>

#include <array>
#include <draco/compression/decode.h>
#include <utility>

namespace asos::gltf {

namespace {

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
