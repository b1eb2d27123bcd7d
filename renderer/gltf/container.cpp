#include "renderer/gltf/container.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace asos::gltf {

namespace {

constexpr std::uint64_t most_file_bytes = std::uint64_t{8} << 30;
constexpr std::uint64_t most_json_bytes = std::uint64_t{1} << 30;
constexpr std::string_view magic = "glTF";
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

/// Returns the chunk at `at`, and moves `at` behind it.
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

/// Returns why a file of `file_size` bytes that begins with `head` is no GLB; empty: it may be one.
std::string header_fault(Bytes head, std::uint64_t file_size) {
  if (head.size() < 12) return "the GLB header is cut off";
  const std::uint32_t version = little_endian(head, 4);
  if (version != 2) return fmt::format("GLB version {} is not supported, only 2", version);
  const std::uint64_t declared = little_endian(head, 8);
  if (declared > file_size) {
    return fmt::format("the file is cut off: its header declares {} bytes, it has {}", declared,
                       file_size);
  }
  if (declared < 20) return fmt::format("the GLB header declares a length of {}", declared);
  return "";
}

Checked<Container> open_binary(Bytes file, Warnings& warnings) {
  if (std::string why = header_fault(file, file.size()); !why.empty()) return fault(why);
  const std::uint64_t declared = little_endian(file, 8);
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

struct ForeignKind {
  std::string_view magic;
  const char* name;
};
constexpr ForeignKind foreign_kinds[] = {
    {"\x89PNG", "a PNG picture"},
    {"\xff\xd8\xff", "a JPEG picture"},
    {"RIFF", "a RIFF file, such as a WebP picture"},
    {"\xabKTX ", "a KTX picture"},
    {"v/1\x01", "an OpenEXR picture"},
    {"#?", "a Radiance HDR picture"},
    {"PK\x03\x04", "a ZIP archive"},
    {"\x1f\x8b", "a gzip archive"},
    {"%PDF", "a PDF document"},
    {"Kaydara FBX", "an FBX scene"},
    {"; FBX", "an FBX scene"},
    {"BLENDER", "a Blender scene"},
    {"ply\n", "a PLY mesh"},
    {"ply\r", "a PLY mesh"},
    {"solid ", "an STL mesh"},
    {"<", "an XML or HTML text"},
};

/// Returns why a file that begins with `head` is no scene; empty: it may be JSON.
std::string foreign_fault(Bytes head) {
  for (const ForeignKind& kind : foreign_kinds)
    if (begins_with(head, kind.magic)) return fmt::format("is {}, not a glTF scene", kind.name);
  const auto shown = [&](std::size_t at) {
    const auto c = static_cast<char>(head[at]);
    return c > ' ' && c <= '~' && c != '\'' ? std::string(1, c)
                                            : fmt::format("\\x{:02x}", head[at]);
  };
  if (head.size() >= 20 && little_endian(head, 16) == json_chunk)
    return fmt::format("is a GLB file with the magic '{}{}{}{}' instead of 'glTF'", shown(0),
                       shown(1), shown(2), shown(3));
  // Text cannot begin with a control character, except a tab, a line feed or a carriage return.
  if (!head.empty() && (head[0] < 9 || (head[0] > 13 && head[0] < 32)))
    return fmt::format("is neither GLB nor JSON: it begins with the byte {:#04x}", head[0]);
  return "";
}

}  // namespace

FileRules scene_file_rules() {
  return {most_file_bytes, [](const FileHead& head) -> std::string {
            if (begins_with(head.bytes, magic)) return header_fault(head.bytes, head.file_size);
            if (std::string why = foreign_fault(head.bytes); !why.empty()) return why;
            return head.file_size > most_json_bytes ? "the JSON is larger than 1 GiB" : "";
          }};
}

Checked<Container> open_container(Bytes file, Warnings& warnings) {
  if (file.empty()) return fault("the file is empty");
  if (begins_with(file, magic)) return open_binary(file, warnings);
  if (begins_with(file, "version https://git-lfs")) {
    return fault("is a Git LFS pointer, not the model itself; fetch it with git lfs pull");
  }
  if (std::string why = foreign_fault(file.first(std::min(file.size(), FileHead::length)));
      !why.empty())
    return fault(why);
  return Container{file, {}, false, false};
}

std::size_t nesting_depth(Bytes text) {
  std::size_t depth = 0, deepest = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<char>(text[i]);
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
