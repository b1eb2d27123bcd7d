#include "renderer/gltf/accessors.h"

#include "renderer/gltf/compressed.h"
#include "renderer/load_progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace asos::gltf {

namespace {

/// Returns the bytes of a component, or 0 for types that glTF does not have.
std::size_t component_size(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

int component_count(int type) {
  switch (type) {
    case TINYGLTF_TYPE_SCALAR:
      return 1;
    case TINYGLTF_TYPE_VEC2:
      return 2;
    case TINYGLTF_TYPE_VEC3:
      return 3;
    case TINYGLTF_TYPE_VEC4:
    case TINYGLTF_TYPE_MAT2:
      return 4;
    case TINYGLTF_TYPE_MAT3:
      return 9;
    case TINYGLTF_TYPE_MAT4:
      return 16;
    default:
      return 0;
  }
}

// Bytes of zeros without data that a file of any size may declare.
constexpr std::uint64_t free_zeros = std::uint64_t{1} << 20;

// Largest expansion by meshopt's codecs. Views that share their bytes would exceed it.
constexpr std::uint64_t most_decompressed_per_byte = 80;

template <typename T>
T load(const std::uint8_t* at) {
  T value;
  std::memcpy(&value, at, sizeof(T));  // offsets need not be aligned
  return value;
}

struct ToFloat {
  bool normalized;
  [[nodiscard]] static bool accepts(int) { return true; }
  [[nodiscard]] float operator()(const std::uint8_t* at, int type) const {
    switch (type) {
      case TINYGLTF_COMPONENT_TYPE_BYTE:
        return scaled(load<std::int8_t>(at), 127.0f);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return scaled(load<std::uint8_t>(at), 255.0f);
      case TINYGLTF_COMPONENT_TYPE_SHORT:
        return scaled(load<std::int16_t>(at), 32767.0f);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return scaled(load<std::uint16_t>(at), 65535.0f);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return static_cast<float>(load<std::uint32_t>(at));
      default:
        return load<float>(at);
    }
  }
  template <typename T>
  [[nodiscard]] float scaled(T value, float largest) const {
    const auto number = static_cast<float>(value);
    return normalized ? std::max(number / largest, -1.0f) : number;
  }
};

struct ToInteger {
  [[nodiscard]] static bool accepts(int type) {
    return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  }
  [[nodiscard]] std::uint32_t operator()(const std::uint8_t* at, int type) const {
    if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return load<std::uint8_t>(at);
    if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return load<std::uint16_t>(at);
    return load<std::uint32_t>(at);
  }
};

}  // namespace

/// The location of an accessor's elements; `bytes` is empty if they are all zero.
struct Accessors::Elements {
  const tinygltf::Accessor* accessor = nullptr;
  Bytes bytes;
  std::size_t stride = 0;
};

Checked<Bytes> Accessors::slice(std::int64_t buffer, std::uint64_t offset,
                                std::uint64_t length) const {
  if (buffer < 0 || static_cast<std::uint64_t>(buffer) >= doc_.buffers.size()) {
    return fault(fmt::format("buffer {} does not exist", buffer));
  }
  const Buffer& source = doc_.buffers[static_cast<std::size_t>(buffer)];
  if (!source.missing_because.empty()) {
    return fault(fmt::format("buffer {}: {}", buffer, source.missing_because));
  }
  const std::uint64_t size = source.bytes.size();
  if (offset > size || length > size - offset) {
    return fault(fmt::format("{} bytes at {} reach outside buffer {} of {} bytes", length, offset,
                             buffer, size));
  }
  return source.bytes.subspan(offset, length);
}

Checked<Bytes> Accessors::view(int index) {
  if (index < 0 || static_cast<std::size_t>(index) >= doc_.model.bufferViews.size()) {
    return fault(fmt::format("buffer view {} does not exist", index));
  }
  const tinygltf::BufferView& view = doc_.model.bufferViews[static_cast<std::size_t>(index)];
  if (const tinygltf::Value* compressed = meshopt_extension(view)) {
    auto found = decompressed_.find(index);
    if (found == decompressed_.end()) {
      Checked<FileBytes> bytes = decode_meshopt(*compressed, *this);
      if (!bytes) return fault(fmt::format("buffer view {}: {}", index, bytes.error()));
      decompressed_bytes_ += bytes->size();
      if (decompressed_bytes_ > most_decompressed_per_byte * doc_.honest_bytes + free_zeros)
        return fault(
            fmt::format("buffer view {}: the views decompressed are more than the file can "
                        "hold",
                        index));
      found = decompressed_.emplace(index, std::move(*bytes)).first;
    }
    return Bytes(found->second);
  }
  Checked<Bytes> bytes = slice(view.buffer, view.byteOffset, view.byteLength);
  if (!bytes) return fault(fmt::format("buffer view {}: {}", index, bytes.error()));
  return bytes;
}

Checked<const tinygltf::Accessor*> Accessors::find(int index) const {
  if (index < 0 || static_cast<std::size_t>(index) >= doc_.model.accessors.size()) {
    return fault(fmt::format("accessor {} does not exist", index));
  }
  return &doc_.model.accessors[static_cast<std::size_t>(index)];
}

Checked<Accessors::Elements> Accessors::locate(int index) {
  const Checked<const tinygltf::Accessor*> found = find(index);
  if (!found) return fault(found.error());
  const tinygltf::Accessor& accessor = **found;
  const std::size_t component = component_size(accessor.componentType);
  const auto components = static_cast<std::size_t>(component_count(accessor.type));
  const std::size_t element = component * components;
  if (element == 0) return fault(fmt::format("accessor {} has an unknown type", index));
  if (accessor.count == 0) return fault(fmt::format("accessor {} has no elements", index));

  Elements elements{&accessor, {}, element};
  if (accessor.bufferView < 0) {
    if (accessor.count > (doc_.honest_bytes + free_zeros) / element) {
      return fault(fmt::format("accessor {} declares {} elements without data for them", index,
                               accessor.count));
    }
    return elements;
  }
  const Checked<Bytes> view = this->view(accessor.bufferView);
  if (!view) return fault(fmt::format("accessor {}: {}", index, view.error()));
  const std::uint64_t declared = doc_.strides[static_cast<std::size_t>(accessor.bufferView)];
  if (declared != 0) elements.stride = declared;
  if (elements.stride < element || elements.stride > 65536) {
    return fault(fmt::format("accessor {} has elements of {} bytes every {} bytes", index, element,
                             elements.stride));
  }
  const std::uint64_t size = view->size();
  const std::uint64_t offset = accessor.byteOffset;
  if (offset > size || size - offset < element ||
      accessor.count - 1 > (size - offset - element) / elements.stride) {
    return fault(
        fmt::format("accessor {} reaches outside its buffer view: {} elements at {} of {} "
                    "bytes",
                    index, accessor.count, offset, size));
  }
  elements.bytes = view->subspan(offset);
  return elements;
}

Checked<std::size_t> Accessors::count(int accessor) {
  const Checked<Elements> elements = locate(accessor);
  if (!elements) return fault(elements.error());
  return elements->accessor->count;
}

Checked<int> Accessors::components(int accessor) const {
  const Checked<const tinygltf::Accessor*> found = find(accessor);
  if (!found) return fault(found.error());
  return component_count((*found)->type);
}

Checked<std::uint64_t> Accessors::declared_count(int accessor) const {
  const Checked<const tinygltf::Accessor*> found = find(accessor);
  if (!found) return fault(found.error());
  return (*found)->count;
}

bool Accessors::has_data(int accessor) const {
  const Checked<const tinygltf::Accessor*> found = find(accessor);
  return found && (*found)->bufferView >= 0;
}

std::uint32_t Accessors::largest_integer(int accessor) const {
  const Checked<const tinygltf::Accessor*> found = find(accessor);
  const int type = found ? (*found)->componentType : 0;
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return 0xffu;
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return 0xffffu;
  return 0xffffffffu;
}

bool Accessors::normalized(int accessor) const {
  const Checked<const tinygltf::Accessor*> found = find(accessor);
  return found && (*found)->normalized;
}

template <typename Out, typename Convert>
Checked<void> Accessors::apply_sparse(const tinygltf::Accessor& accessor, int components,
                                      std::vector<Out>& values, Convert convert) {
  const auto& sparse = accessor.sparse;
  const std::size_t size = component_size(sparse.indices.componentType);
  if (sparse.count < 1 || static_cast<std::size_t>(sparse.count) > accessor.count ||
      sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0 ||
      !ToInteger::accepts(sparse.indices.componentType)) {
    return fault("its sparse part is not valid");
  }
  const auto count = static_cast<std::size_t>(sparse.count);
  const std::size_t component = component_size(accessor.componentType);
  const std::size_t element = component * static_cast<std::size_t>(components);
  const auto part = [&](int buffer_view, int offset, std::size_t bytes) -> Checked<Bytes> {
    const Checked<Bytes> whole = view(buffer_view);
    if (!whole) return whole;
    const auto at = static_cast<std::size_t>(offset);
    if (at > whole->size() || count > (whole->size() - at) / bytes) {
      return fault("its sparse part reaches outside its buffer view");
    }
    return whole->subspan(at);
  };
  const Checked<Bytes> where = part(sparse.indices.bufferView, sparse.indices.byteOffset, size);
  if (!where) return fault(where.error());
  const Checked<Bytes> what = part(sparse.values.bufferView, sparse.values.byteOffset, element);
  if (!what) return fault(what.error());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t target = ToInteger{}(where->data() + i * size, sparse.indices.componentType);
    if (target >= accessor.count) return fault("a sparse index is out of range");
    for (int c = 0; c < components; ++c) {
      const auto offset = static_cast<std::size_t>(c) * component;
      values[target * static_cast<std::size_t>(components) + static_cast<std::size_t>(c)] =
          convert(what->data() + i * element + offset, accessor.componentType);
    }
  }
  return {};
}

template <typename Out, typename Convert>
Checked<std::vector<Out>> Accessors::read(int index, int components, const Selection& selection,
                                          Convert convert) {
  const Checked<Elements> elements = locate(index);
  if (!elements) return fault(elements.error());
  const tinygltf::Accessor& accessor = *elements->accessor;
  const auto n = static_cast<std::size_t>(components);
  if (component_count(accessor.type) != components || !Convert::accepts(accessor.componentType)) {
    return fault(fmt::format("accessor {} has the wrong type for its use", index));
  }
  const std::size_t component = component_size(accessor.componentType);
  const auto element_at = [&](std::size_t i, Out* out) {
    for (std::size_t c = 0; c < n && !elements->bytes.empty(); ++c) {
      out[c] = convert(elements->bytes.data() + i * elements->stride + c * component,
                       accessor.componentType);
    }
  };
  if (selection && !selection->empty() && selection->back() >= accessor.count) {
    return fault(fmt::format("accessor {} has only {} elements", index, accessor.count));
  }
  // Sparse data may replace any element, so all of them are read first.
  const bool all = !selection || accessor.sparse.isSparse;
  // Sparse accessors do not count: their data, and the vertices they belong to, are in the file.
  if (elements->bytes.empty() && !accessor.sparse.isSparse) {
    zeros_ += (all ? accessor.count : selection->size()) * n * sizeof(Out);
    if (zeros_ > doc_.honest_bytes + free_zeros)
      return fault(
          fmt::format("accessor {} has no data, and there are more such than the file is "
                      "large",
                      index));
  }
  std::vector<Out> values((all ? accessor.count : selection->size()) * n);
  constexpr std::size_t between_stops = std::size_t{1} << 16;
  for (std::size_t i = 0; i * n < values.size(); ++i) {
    if (i % between_stops == 0) stop_point();
    element_at(all ? i : (*selection)[i], values.data() + i * n);
  }
  if (!accessor.sparse.isSparse) return values;

  if (auto done = apply_sparse(accessor, components, values, convert); !done) {
    return fault(fmt::format("accessor {}: {}", index, done.error()));
  }
  if (!selection) return values;
  std::vector<Out> chosen(selection->size() * n);
  for (std::size_t i = 0; i < selection->size(); ++i) {
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>((*selection)[i] * n), n,
                chosen.begin() + static_cast<std::ptrdiff_t>(i * n));
  }
  return chosen;
}

Checked<std::vector<float>> Accessors::floats(int accessor, int components,
                                              const Selection& selection) {
  const Checked<const tinygltf::Accessor*> found = find(accessor);
  if (!found) return fault(found.error());
  return read<float>(accessor, components, selection, ToFloat{(*found)->normalized});
}

Checked<std::vector<std::uint32_t>> Accessors::integers(int accessor, int components,
                                                        const Selection& selection) {
  return read<std::uint32_t>(accessor, components, selection, ToInteger{});
}

}  // namespace asos::gltf
