#include "renderer/files/base64.h"
#include "renderer/gltf/export/gltf_writer.h"
#include "renderer/gltf/files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <utility>

namespace asos::exporting {

using nlohmann::json;

namespace {

/// Converts to text. Names may contain bytes that are not UTF-8; they are replaced, so that the
/// scene can be saved.
std::string dump(const json& root) {
  return root.dump(-1, ' ', false, json::error_handler_t::replace);
}

void append_u32(std::string& out, std::uint64_t value) {
  for (int shift = 0; shift < 32; shift += 8) {
    out += static_cast<char>(static_cast<unsigned char>((value >> shift) & 0xffu));
  }
}

}  // namespace

GltfDocument::GltfDocument() {
  root["asset"] = {{"version", "2.0"}, {"generator", "ASOS"}};
  root["scene"] = 0;
  root["scenes"] = json::array({json::object()});
}

GltfDocument::GltfDocument(json of_file) : root(std::move(of_file)) {}

std::size_t GltfDocument::append(std::span<const std::uint8_t> bytes) {
  binary_.resize((binary_.size() + 3) / 4 * 4, 0);
  const std::size_t offset = binary_.size();
  binary_.insert(binary_.end(), bytes.begin(), bytes.end());
  return offset;
}

int GltfDocument::add_view(std::span<const std::uint8_t> bytes, int target) {
  json view{{"buffer", 0}, {"byteOffset", append(bytes)}, {"byteLength", bytes.size()}};
  if (target != 0) view["target"] = target;
  return add("bufferViews", std::move(view));
}

int GltfDocument::add(const char* list, json value) {
  root[list].push_back(std::move(value));
  return static_cast<int>(root[list].size()) - 1;
}

json& GltfDocument::default_scene() {
  if (!root.contains("scenes")) return root;
  return root["scenes"].at(root.value("scene", std::size_t{0}));
}

void GltfDocument::add_root_node(json node) {
  const int index = add("nodes", std::move(node));
  if (root.contains("scenes")) default_scene()["nodes"].push_back(index);
}

void GltfDocument::finish() {
  binary_.resize((binary_.size() + 3) / 4 * 4, 0);
  json& used = root["extensionsUsed"];
  for (const std::string& name : extensions_) {
    if (std::find(used.begin(), used.end(), json(name)) == used.end()) used.push_back(name);
  }
  if (used.empty()) root.erase("extensionsUsed");
  if (binary_.empty() && root.contains("buffers")) binary_.resize(4, 0);
  if (!binary_.empty()) root["buffers"][0] = {{"byteLength", binary_.size()}};
}

Result<std::string> GltfDocument::as_glb(const std::string& path) {
  finish();
  std::string text = dump(root);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::uint64_t binary_chunk = binary_.empty() ? 0 : 8 + binary_.size();
  const std::uint64_t total = 12 + 8 + text.size() + binary_chunk;
  if (total > std::numeric_limits<std::uint32_t>::max()) {
    return unexpected(Error{path, "the scene is too large for a .glb file, which ends at 4 GiB"});
  }
  std::string out = "glTF";
  out.reserve(total);
  append_u32(out, 2);
  append_u32(out, total);
  append_u32(out, text.size());
  out += "JSON";
  out += text;
  if (!binary_.empty()) {
    append_u32(out, binary_.size());
    out.append("BIN\0", 4);
    out.append(binary_.begin(), binary_.end());
  }
  return out;
}

Result<void> GltfDocument::write(const std::string& path) {
  const std::string ending = gltf::lower_case(std::filesystem::path(path).extension().string());
  if (ending == ".gltf") return write_atomically(path, as_gltf());
  if (ending != ".glb") return unexpected(Error{path, "a scene is written as .glb or .gltf"});
  const Result<std::string> bytes = as_glb(path);
  if (!bytes) return unexpected(bytes.error());
  return write_atomically(path, *bytes);
}

std::string GltfDocument::as_gltf() {
  finish();
  if (!binary_.empty()) {
    root["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(binary_);
  }
  return dump(root);
}

}  // namespace asos::exporting
