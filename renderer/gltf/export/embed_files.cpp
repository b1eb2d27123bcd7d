#include "renderer/gltf/export/embed_files.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace asos::exporting {

using nlohmann::json;

namespace {

/// The new place of a buffer.
struct MovedBuffer {
  std::size_t index = 0;     // among the document's buffers
  std::uint64_t offset = 0;  // of its bytes there
  std::uint64_t bytes = 0;
  bool embedded = false;
};

// Offset of views that reached past the end of their own buffer.
constexpr std::uint64_t past_any_end = std::uint64_t{1} << 40;

json* list_of(json& root, const char* name) {
  const auto found = root.find(name);
  return found != root.end() && found->is_array() ? &*found : nullptr;
}

std::uint64_t whole_number(const json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_number_unsigned() ? found->get<std::uint64_t>() : 0;
}

std::string uri_of(const json& object) {
  if (!object.is_object()) return {};
  const auto found = object.find("uri");
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// The bytes of a buffer; none: it is missing or a placeholder.
std::optional<FileBytes> bytes_of(const json& buffer, bool is_bin, const gltf::Container& container,
                                  gltf::ModelFiles& files) {
  if (!buffer.is_object()) return std::nullopt;
  if (const std::string uri = uri_of(buffer); !uri.empty()) {
    auto read = files.read(uri);
    if (!read) return std::nullopt;
    return std::move(read->bytes);
  }
  if (!is_bin || buffer.contains("uri")) return std::nullopt;
  return FileBytes(container.bin.begin(), container.bin.end());
}

std::vector<MovedBuffer> move_buffers(const gltf::Container& container, gltf::ModelFiles& files,
                                      GltfDocument& document) {
  std::vector<MovedBuffer> moved;
  json kept = json::array({json::object()});  // the first is the document's own
  if (const json* buffers = list_of(document.root, "buffers")) {
    for (std::size_t i = 0; i < buffers->size(); ++i) {
      const json& buffer = (*buffers)[i];
      std::optional<FileBytes> bytes =
          bytes_of(buffer, i == 0 && container.has_bin, container, files);
      if (!bytes) {
        moved.push_back({kept.size(), 0, 0, false});
        kept.push_back(buffer);
        continue;
      }
      if (const std::uint64_t length = whole_number(buffer, "byteLength");
          length > 0 && length < bytes->size())
        bytes->resize(static_cast<std::size_t>(length));
      moved.push_back({0, document.append(*bytes), bytes->size(), true});
    }
  }
  document.root["buffers"] = std::move(kept);
  return moved;
}

// `view`: a buffer view, or the compressed data that an extension gives in its place.
void move_view(json& view, const std::vector<MovedBuffer>& moved) {
  if (!view.is_object() || !view.contains("buffer")) return;
  const std::uint64_t index = whole_number(view, "buffer");
  if (index >= moved.size()) return;
  const MovedBuffer& buffer = moved[static_cast<std::size_t>(index)];
  view["buffer"] = buffer.index;
  if (!buffer.embedded) return;
  const std::uint64_t offset = whole_number(view, "byteOffset");
  const std::uint64_t length = whole_number(view, "byteLength");
  const bool broken = offset > buffer.bytes || length > buffer.bytes - offset;
  view["byteOffset"] = broken ? past_any_end : buffer.offset + offset;
}

const char* type_of(std::span<const std::uint8_t> bytes) {
  if (begins_with(bytes, "\x89PNG")) return "image/png";
  if (begins_with(bytes, "\xff\xd8")) return "image/jpeg";
  if (begins_with(bytes, "RIFF")) return "image/webp";
  if (begins_with(bytes, "\xabKTX 20")) return "image/ktx2";
  return nullptr;
}

void embed_image(json& image, gltf::ModelFiles& files, GltfDocument& document) {
  const std::string uri = uri_of(image);
  if (uri.empty() || gltf::is_data_uri(uri)) return;
  const auto read = files.read(uri);
  if (!read) return;
  image.erase("uri");
  image["bufferView"] = document.add_view(read->bytes, 0);
  if (const char* type = type_of(read->bytes)) image["mimeType"] = type;
}

}  // namespace

void embed_files(const gltf::Container& container, gltf::ModelFiles& files,
                 GltfDocument& document) {
  const std::vector<MovedBuffer> moved = move_buffers(container, files, document);
  if (json* views = list_of(document.root, "bufferViews")) {
    for (json& view : *views) {
      move_view(view, moved);
      if (!view.is_object() || !view.contains("extensions")) continue;
      for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
        if (view["extensions"].contains(name)) move_view(view["extensions"][name], moved);
    }
  }
  json* images = list_of(document.root, "images");
  if (!images) return;
  for (json& image : *images) embed_image(image, files, document);
}

}  // namespace asos::exporting
