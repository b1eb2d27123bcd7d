#include "renderer/gltf/accessors.h"
#include "renderer/gltf/compressed.h"
#include "renderer/gltf/values.h"

#include <fmt/format.h>

#include <meshoptimizer.h>

namespace asos::gltf {

namespace {

// The vertex codec spends two bits on sixteen equal bytes and the index codecs a byte on three
// indices, so no valid data expands further than this.
constexpr std::uint64_t largest_expansion = 80;
constexpr std::uint64_t free_bytes = 4096;

struct Packed {
  std::string mode, filter;
  std::uint64_t count = 0;
  std::uint64_t stride = 0;
  Bytes bytes;
};

Checked<Packed> unpack(const tinygltf::Value& extension, const Accessors& accessors) {
  Packed packed;
  const int buffer = whole(extension, "buffer").value_or(-1);
  const int offset = whole(extension, "byteOffset").value_or(0);
  const int length = whole(extension, "byteLength").value_or(-1);
  const int stride = whole(extension, "byteStride").value_or(-1);
  const int count = whole(extension, "count").value_or(-1);
  packed.mode = text(extension, "mode");
  packed.filter = text(extension, "filter", "NONE");
  if (offset < 0 || length < 0 || stride < 1 || stride > 256 || count < 1) {
    return fault("its meshopt compression is not described validly");
  }
  const Checked<Bytes> bytes = accessors.slice(buffer, static_cast<std::uint64_t>(offset),
                                               static_cast<std::uint64_t>(length));
  if (!bytes) return fault(bytes.error());
  packed.bytes = *bytes;
  packed.count = static_cast<std::uint64_t>(count);
  packed.stride = static_cast<std::uint64_t>(stride);
  if (packed.count * packed.stride > packed.bytes.size() * largest_expansion + free_bytes) {
    return fault(fmt::format("{} compressed bytes cannot hold {} elements of {} bytes",
                             packed.bytes.size(), packed.count, packed.stride));
  }
  return packed;
}

bool valid_layout(const Packed& packed) {
  if (packed.mode == "ATTRIBUTES") {
    if (packed.filter == "OCTAHEDRAL") return packed.stride == 4 || packed.stride == 8;
    if (packed.filter == "QUATERNION") return packed.stride == 8;
    return packed.stride % 4 == 0;
  }
  if (packed.filter != "NONE" || (packed.stride != 2 && packed.stride != 4)) return false;
  return packed.mode == "INDICES" || (packed.mode == "TRIANGLES" && packed.count % 3 == 0);
}

}  // namespace

const tinygltf::Value* meshopt_extension(const tinygltf::BufferView& view) {
  if (const auto* ext = extension(view.extensions, "EXT_meshopt_compression")) return ext;
  return extension(view.extensions, "KHR_meshopt_compression");
}

Checked<FileBytes> decode_meshopt(const tinygltf::Value& extension, const Accessors& accessors) {
  const Checked<Packed> found = unpack(extension, accessors);
  if (!found) return fault(found.error());
  const Packed& packed = *found;
  if (packed.filter != "NONE" && packed.filter != "OCTAHEDRAL" && packed.filter != "QUATERNION" &&
      packed.filter != "EXPONENTIAL") {
    return fault(fmt::format("the meshopt filter '{}' is not supported", packed.filter));
  }
  if (!valid_layout(packed)) return fault("its meshopt compression is not described validly");

  FileBytes out(packed.count * packed.stride);
  int failed = 0;
  if (packed.mode == "ATTRIBUTES") {
    failed = meshopt_decodeVertexBuffer(out.data(), packed.count, packed.stride,
                                        packed.bytes.data(), packed.bytes.size());
  } else if (packed.mode == "TRIANGLES") {
    failed = meshopt_decodeIndexBuffer(out.data(), packed.count, packed.stride, packed.bytes.data(),
                                       packed.bytes.size());
  } else {
    failed = meshopt_decodeIndexSequence(out.data(), packed.count, packed.stride,
                                         packed.bytes.data(), packed.bytes.size());
  }
  if (failed != 0) return fault("its meshopt data cannot be decoded");
  if (packed.filter == "OCTAHEDRAL") {
    meshopt_decodeFilterOct(out.data(), packed.count, packed.stride);
  } else if (packed.filter == "QUATERNION") {
    meshopt_decodeFilterQuat(out.data(), packed.count, packed.stride);
  } else if (packed.filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(out.data(), packed.count, packed.stride);
  }
  return out;
}

}  // namespace asos::gltf
