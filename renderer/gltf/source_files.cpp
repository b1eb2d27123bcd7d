#include "renderer/scene/source_files.h"

#include "renderer/gltf/container.h"
#include "renderer/gltf/converted.h"
#include "renderer/gltf/files.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <unordered_set>
#include <utility>

namespace asos {

namespace {

/// Returns the JSON of a glTF file; discarded if it is not readable.
nlohmann::json document_of(const std::string& source) {
  const nlohmann::json none(nlohmann::json::value_t::discarded);
  const auto bytes = read_file(source, gltf::scene_file_rules());
  if (!bytes) return none;
  gltf::Warnings ignored;
  const auto container = gltf::open_container(*bytes, ignored);
  if (!container) return none;
  return nlohmann::json::parse(container->json.begin(), container->json.end(), nullptr, false);
}

/// Returns the files that a glTF document refers to.
std::vector<gltf::UriFile> named_files(const nlohmann::json& document,
                                       gltf::ModelFiles known_files) {
  std::vector<gltf::UriFile> files;
  for (const char* list : {"buffers", "images"}) {
    const auto found = document.find(list);
    if (found == document.end() || !found->is_array()) continue;
    for (const nlohmann::json& entry : *found) {
      if (!entry.is_object() || !entry.contains("uri") || !entry["uri"].is_string()) continue;
      const std::string uri = entry["uri"].get<std::string>();
      // Faults: data URIs, other schemes, and files that import rejects.
      auto file = known_files.find(uri);
      if (file) files.push_back(*std::move(file));
    }
  }
  return files;
}

/// Reads a file of a model in another format; empty: too large, or not readable.
std::string text_of(const std::filesystem::path& path) {
  constexpr std::uintmax_t most_bytes = std::uintmax_t{64} << 20;
  std::error_code error;
  if (const auto size = std::filesystem::file_size(path, error); error || size > most_bytes)
    return {};
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool is_material_file(const std::filesystem::path& path) {
  return path.extension() == ".mtl" || path.extension() == ".MTL";
}

/// Returns the files beside a model in another format whose names occur in it, or in a material
/// file that it names. Formats are not read for that.
std::vector<std::string> files_named_in(const std::filesystem::path& model) {
  constexpr int most_beside = 10'000;
  std::vector<std::filesystem::path> beside;
  std::error_code error;
  const auto folder = model.has_parent_path() ? model.parent_path() : std::filesystem::path(".");
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.is_regular_file(error) && entry.path().filename() != model.filename() &&
        beside.size() < most_beside)
      beside.push_back(entry.path());
  std::sort(beside.begin(), beside.end());
  std::string text = text_of(model);
  for (const auto& path : beside)
    if (is_material_file(path) && text.find(path.filename().string()) != std::string::npos)
      text += text_of(path);
  std::vector<std::string> files;
  for (const auto& path : beside)
    if (text.find(path.filename().string()) != std::string::npos)
      files.push_back((model.parent_path() / path.filename()).string());
  return files;
}

/// Returns the lowest folder that contains two others.
std::filesystem::path common_folder(const std::filesystem::path& a,
                                    const std::filesystem::path& b) {
  std::filesystem::path common;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end() && *i == *j; ++i, ++j)
    common /= *i;
  return common;
}

}  // namespace

std::vector<std::string> source_files(const std::string& source, const std::string& asset_root) {
  if (source.starts_with("builtin:")) return {};
  std::vector<std::string> files{source};
  if (gltf::is_convertible(source)) {
    for (std::string& file : files_named_in(source)) files.push_back(std::move(file));
    return files;
  }
  const nlohmann::json document = document_of(source);
  if (!document.is_object()) return files;
  const std::filesystem::path folder = std::filesystem::path(source).parent_path();
  auto folders = gltf::asset_folders(folder, asset_root);
  if (!folders) return files;
  gltf::ModelFiles model_files(std::move(*folders));
  std::unordered_set<std::string> known{source};
  for (const gltf::UriFile& file : named_files(document, std::move(model_files))) {
    std::string path = (folder / file.relative).lexically_normal().string();
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

std::string outer_asset_root(const std::string& source, const std::string& asset_root) {
  if (source.starts_with("builtin:")) return {};
  const nlohmann::json document = document_of(source);
  if (!document.is_object()) return {};
  const auto allowed = gltf::asset_folders(std::filesystem::path(source).parent_path(), asset_root);
  if (!allowed) return {};
  const gltf::AssetFolders own{allowed->model, allowed->model};
  gltf::ModelFiles everywhere({allowed->model, allowed->model.root_path()});
  std::filesystem::path root;
  bool refused = false;
  for (const gltf::UriFile& file : named_files(document, std::move(everywhere))) {
    std::error_code error;
    if (own.contain(file.path) || !std::filesystem::is_regular_file(file.path, error)) continue;
    refused |= !allowed->contain(file.path);
    const std::filesystem::path folder = file.path.parent_path();
    root = root.empty() ? folder : common_folder(root, folder);
  }
  return refused && root != root.root_path() ? root.string() : std::string();
}

}  // namespace asos
