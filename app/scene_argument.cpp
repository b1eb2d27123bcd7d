#include "app/scene_argument.h"

#include "renderer/gltf/load.h"
#include "renderer/scene/builtin.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <string_view>
#include <vector>

namespace asos {
namespace {

constexpr std::string_view builtin_prefix = "builtin:";

// Levenshtein distance between two names.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

// " Did you mean builtin:office? Built-in scenes: builtin:office, ..."
std::string suggestions(std::string_view name) {
  std::vector<std::string> names;
  for (const BuiltinScene& scene : builtin_scenes()) names.push_back(scene.name);
  const auto distance = [&](const std::string& known) {
    return known.find(name) == 0 && name.size() >= 2 ? 1 : edit_distance(name, known);
  };
  std::stable_sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return distance(a) < distance(b);
  });
  std::string text;
  if (!names.empty() && distance(names.front()) <= 2)
    text = fmt::format(" Did you mean {}{}?", builtin_prefix, names.front());
  text += " Built-in scenes:";
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{} {}{}", i ? "," : "", builtin_prefix, names[i]);
  return text;
}

bool is_builtin(std::string_view name) {
  const auto& known = builtin_scenes();
  return std::any_of(known.begin(), known.end(),
                     [&](const BuiltinScene& scene) { return scene.name == name; });
}

tl::unexpected<Error> unknown_builtin(const std::string& text) {
  const std::string name =
      text.starts_with(builtin_prefix) ? text.substr(builtin_prefix.size()) : text;
  return tl::unexpected(
      Error{text, "there is no built-in scene of this name." + suggestions(name)});
}

}  // namespace

Result<void> check_scene_argument(const std::string& text) {
  if (text.starts_with(builtin_prefix)) {
    if (is_builtin(text.substr(builtin_prefix.size()))) return {};
    return unknown_builtin(text);
  }
  std::error_code error;
  const auto status = std::filesystem::status(text, error);
  if (std::filesystem::is_directory(status))
    return tl::unexpected(
        Error{text, "this is a directory; name the .gltf or .glb file inside it."});
  if (status.type() == std::filesystem::file_type::not_found) {
    // Lists the built-in scenes only for words like "office"; for a path the list does not help.
    const bool looks_like_name = text.find_first_of("/.") == std::string::npos;
    return tl::unexpected(
        Error{text, "there is no such file." + (looks_like_name ? suggestions(text) : "")});
  }
  return {};
}

Result<Scene> open_scene_argument(const std::string& text, const LoadOptions& options) {
  return check_scene_argument(text).and_then([&] { return load_scene(text, options); });
}

Result<Scene> make_builtin_scene(const std::string& text) {
  const std::string name =
      text.starts_with(builtin_prefix) ? text.substr(builtin_prefix.size()) : text;
  if (!is_builtin(name)) return unknown_builtin(text);
  return load_scene(std::string(builtin_prefix) + name, {.keep_posable = true});
}

void add_asset_root_option(CLI::App& app, std::string& asset_root) {
  app.add_option("--asset-root", asset_root,
                 "Folder that the scene's textures and buffers may come from, at any depth below "
                 "it [at most three levels above the scene's file, below the home folder]")
      ->type_name("DIR");
}

void add_scene_choices(CLI::App& app, std::string& scene, std::string& variant,
                       std::string& asset_root) {
  app.add_option("--scene", scene,
                 "Scene of the file, by number from 0 or name [the file's default]")
      ->type_name("N|NAME");
  app.add_option("--variant", variant,
                 "Material variant by name (KHR_materials_variants) [default materials]")
      ->type_name("NAME");
  add_asset_root_option(app, asset_root);
}

void add_scene_argument(CLI::App& app, std::string& scene, bool required) {
  auto* option = app.add_option("SCENE", scene, "Path of a .gltf or .glb file, or builtin:NAME")
                     ->type_name("");
  if (required)
    option->required();
  else
    option->default_str(scene);
}

}  // namespace asos
