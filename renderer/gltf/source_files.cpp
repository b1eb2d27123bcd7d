#include "renderer/scene/source_files.h"

#include "renderer/gltf/container.h"
#include "renderer/gltf/files.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <unordered_set>
#include <utility>

namespace asos {

namespace {

/// The files that a glTF document names besides itself, as paths relative to it.
std::vector<std::string> named_files(const nlohmann::json& document) {
  std::vector<std::string> files;
  for (const char* list : {"buffers", "images"}) {
    const auto found = document.find(list);
    if (found == document.end() || !found->is_array()) continue;
    for (const nlohmann::json& entry : *found) {
      if (!entry.is_object() || !entry.contains("uri") || !entry["uri"].is_string()) continue;
      const std::string uri = entry["uri"].get<std::string>();
      // Data URIs and other schemes are no files; nor is what import refuses.
      if (uri.empty() || uri.find(':') != std::string::npos) continue;
      files.push_back(gltf::percent_decoded(uri));
    }
  }
  return files;
}

}  // namespace

std::vector<std::string> source_files(const std::string& source) {
  if (source.starts_with("builtin:")) return {};
  std::vector<std::string> files{source};
  const auto bytes = read_file(source, gltf::scene_file_rules());
  if (!bytes) return files;
  gltf::Warnings ignored;
  const auto container = gltf::open_container(*bytes, ignored);
  if (!container) return files;
  const auto document =
      nlohmann::json::parse(container->json.begin(), container->json.end(), nullptr, false);
  if (!document.is_object()) return files;
  const std::filesystem::path folder = std::filesystem::path(source).parent_path();
  std::unordered_set<std::string> known{source};
  for (const std::string& file : named_files(document)) {
    std::string path = (folder / file).lexically_normal().string();
    if (known.insert(path).second) files.push_back(std::move(path));
  }
  return files;
}

}  // namespace asos
