#include "renderer/scene/gltf/container.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace asos::gltf {

namespace {

constexpr std::uint32_t json_chunk = 0x4e4f534a;
constexpr std::uint32_t bin_chunk = 0x004e4942;

std::uint32_t little_endian(Bytes bytes, std::size_t at) {
  return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8 |
         static_cast<std::uint32_t>(bytes[at + 2]) << 16 |
         static_cast<std::uint32_t>(bytes[at + 3]) << 24;
}

struct Chunk {
  std::uint32_t type = 0;
  Bytes bytes;
};

/// The chunk at `at`, which moves on behind it.
Checked<Chunk> next_chunk(Bytes glb, std::size_t& at) {
  if (glb.size() - at < 8) return fault(fmt::format("the GLB file ends inside a chunk header"));
  const std::uint64_t length = little_endian(glb, at);
  const std::uint32_t type = little_endian(glb, at + 4);
  at += 8;
  if (length > glb.size() - at) {
    return fault(fmt::format("a GLB chunk of {} bytes reaches beyond the file's end", length));
  }
  Chunk chunk{type, glb.subspan(at, static_cast<std::size_t>(length))};
  at += static_cast<std::size_t>(length);
  return chunk;
}

Checked<Container> open_binary(Bytes file, Warnings& warnings) {
  if (file.size() < 12) return fault("the GLB header is cut off");
  const std::uint32_t version = little_endian(file, 4);
  if (version != 2) return fault(fmt::format("GLB version {} is not supported, only 2", version));
  const std::uint64_t declared = little_endian(file, 8);
  if (declared > file.size()) {
    return fault(fmt::format("the file is cut off: its header declares {} bytes, it has {}",
                             declared, file.size()));
  }
  if (declared < 20) return fault(fmt::format("the GLB header declares a length of {}", declared));
  if (declared < file.size()) warnings.add("bytes after the GLB's end are ignored");
  const Bytes glb = file.first(static_cast<std::size_t>(declared));

  std::size_t at = 12;
  const Checked<Chunk> first = next_chunk(glb, at);
  if (!first) return fault(first.error());
  if (first->type != json_chunk) return fault("the GLB's first chunk is not JSON");
  if (first->bytes.empty()) return fault("the GLB's JSON chunk is empty");
  if (first->bytes.size() % 4 != 0) warnings.add("the GLB's JSON chunk is not padded to 4 bytes");
  Container container{first->bytes, {}, true, false};
  for (int index = 1; at < glb.size(); ++index) {
    const Checked<Chunk> chunk = next_chunk(glb, at);
    if (!chunk && index == 1) return fault(chunk.error());
    if (!chunk) {
      warnings.add(chunk.error());
      break;
    }
    if (chunk->type == bin_chunk && index == 1) {
      container.bin = chunk->bytes;
      container.has_bin = true;
    } else {
      warnings.add(fmt::format("GLB chunk {} of type {:#x} is ignored", index, chunk->type));
    }
  }
  return container;
}

}  // namespace

Checked<Container> open_container(Bytes file, Warnings& warnings) {
  if (file.empty()) return fault("the file is empty");
  constexpr std::string_view magic = "glTF";
  if (file.size() >= 4 && std::equal(magic.begin(), magic.end(), file.begin())) {
    return open_binary(file, warnings);
  }
  constexpr std::string_view lfs = "version https://git-lfs";
  if (file.size() >= lfs.size() && std::equal(lfs.begin(), lfs.end(), file.begin())) {
    return fault("is a Git LFS pointer, not the model itself; fetch it with git lfs pull");
  }
  return Container{file, {}, false, false};
}

std::size_t nesting_depth(Bytes json) {
  std::size_t depth = 0, deepest = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const auto c = static_cast<char>(json[i]);
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      deepest = std::max(deepest, ++depth);
    } else if ((c == '}' || c == ']') && depth > 0) {
      --depth;
    }
  }
  return deepest;
}

}  // namespace asos::gltf
