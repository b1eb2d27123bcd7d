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
std::vector<std::filesystem::path> named_files(const nlohmann::json& document,
                                               gltf::ModelFiles known_files) {
  std::vector<std::filesystem::path> files;
  for (const char* list : {"buffers", "images"}) {
    const auto found = document.find(list);
    if (found == document.end() || !found->is_array()) continue;
    for (const nlohmann::json& entry : *found) {
      if (!entry.is_object() || !entry.contains("uri") || !entry["uri"].is_string()) continue;
      const std::string uri = entry["uri"].get<std::string>();
      // Faults: data URIs, other schemes, and what import refuses.
      auto file = known_files.find(uri);
      if (file) files.push_back(std::move(file->relative));
    }
  }
  return files;
}

}  // namespace

std::vector<std::string> source_files(const std::string& source, const std::string& asset_root) {
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
  auto folders = gltf::asset_folders(folder, asset_root);
  if (!folders) return files;
  gltf::ModelFiles model_files(std::move(*folders));
  std::unordered_set<std::string> known{source};
  for (const std::filesystem::path& file : named_files(document, std::move(model_files))) {
    std::string path = (folder / file).lexically_normal().string();
    if (known.insert(path).second) files.push_back(std::move(path));
  }
  return files;
}

bool may_be_source_file(const std::string& path, const std::string& source,
                        const std::string& asset_root) {
  if (source.starts_with("builtin:")) return false;
  const auto folders = gltf::asset_folders(std::filesystem::path(source).parent_path(), asset_root);
  if (!folders) return false;
  std::error_code error;
  return folders->contain(
      std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error));
}

}  // namespace asos
