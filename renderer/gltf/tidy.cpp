#include "renderer/gltf/tidy.h"

#include "renderer/gltf/document.h"
#include "renderer/gltf/kinds.h"
#include "renderer/gltf/known_extensions.h"
#include "renderer/gltf/known_properties.h"
#include "renderer/gltf/tidy_animations.h"
#include "renderer/gltf/tidy_lights.h"
#include "renderer/gltf/tidy_values.h"

#include <climits>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace asos::gltf {

using nlohmann::json;

namespace {

// Properties whose values are indices, and those whose values are sizes.
constexpr std::array<std::string_view, 17> reference_names = {
    "bufferView", "buffer", "mesh",    "skin",     "camera",  "material",
    "indices",    "source", "sampler", "index",    "scene",   "input",
    "output",     "node",   "light",   "texCoord", "skeleton"};
constexpr std::array<std::string_view, 5> size_names = {"byteOffset", "byteLength", "byteStride",
                                                        "count", "componentType"};
constexpr std::array<std::string_view, 4> list_names = {"children", "nodes", "joints", "ids"};

// Other properties with whole numbers.
constexpr std::array<std::string_view, 11> whole_names = {
    "mode",   "wrapS",   "wrapT",       "magFilter", "minFilter", "POSITION",
    "NORMAL", "TANGENT", "TRANSLATION", "ROTATION",  "SCALE"};

/// Writes 3.0 as 3, since tinygltf does not accept 3.0 as an index.
void make_whole(json& value) {
  if (!value.is_number_float()) return;
  const double number = value.get<double>();
  if (number >= 0.0 && number < 9e15 && number == std::floor(number)) {
    value = static_cast<std::uint64_t>(number);
  }
}

bool is_index(const json& value) {
  return value.is_number_unsigned() && value.get<std::uint64_t>() <= INT_MAX;
}

std::set<std::string> strings_of(const json& root, const char* name, Warnings& warnings) {
  std::set<std::string> strings;
  const auto found = root.find(name);
  if (found == root.end()) return strings;
  if (!found->is_array()) {
    warnings.add(fmt::format("/{} is not a list", name));
    return strings;
  }
  for (const json& value : *found) {
    if (!value.is_string()) {
      warnings.add(fmt::format("/{} has an entry that is not a name", name));
    } else if (!strings.insert(value.get<std::string>()).second) {
      warnings.add(fmt::format("/{} lists {} twice", name, value.get<std::string>()));
    }
  }
  return strings;
}

class Tidier {
 public:
  Tidier(Warnings& warnings, std::set<std::string> declared, std::size_t json_bytes)
      : warnings_(warnings),
        declared_(std::move(declared)),
        memory_left_(free_memory + memory_per_byte * json_bytes) {}

  Checked<void> visit(json& value, const std::string& place) {
    if (value.is_array()) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        if (!value[i].is_structured()) continue;
        if (auto r = visit(value[i], fmt::format("{}/{}", place, i)); !r) return r;
      }
    }
    if (auto r = take_memory(value, place); !r) return r;
    if (!value.is_object()) return {};
    tidy_extras(value, place);
    tidy_extensions(value, place);
    check_properties(value, place);
    for (auto it = value.begin(); it != value.end();) {
      tidy_kind(it.key(), it.value(), place);
      if (auto r = tidy_number(it.key(), it.value(), place); !r) return r;
      tidy_list(it.key(), it.value(), place);
      it = it.value().is_null() ? value.erase(it) : std::next(it);
    }
    for (auto it = value.begin(); it != value.end(); ++it) {
      if (!it.value().is_structured()) continue;
      if (auto r = visit(it.value(), place + "/" + it.key()); !r) return r;
    }
    return {};
  }

 private:
  /// Counts the memory that tinygltf and the importer need for an object's or a list's own entries.
  Checked<void> take_memory(const json& value, const std::string& place) {
    std::uint64_t taken = value.is_object() ? bytes_of_object : 0;
    if (place.starts_with("/materials/") && std::count(place.begin(), place.end(), '/') == 2)
      taken = bytes_of_material;
    if (place.ends_with("/joints")) taken = bytes_of_joint * value.size();
    // Entries of extensions become generic values.
    if (place.find("/extensions/") != std::string::npos) taken += bytes_of_value * value.size();
    if (taken > memory_left_)
      return fault("its JSON has more entries than files of its size have use for");
    memory_left_ -= taken;
    return {};
  }

  void tidy_extensions(json& object, const std::string& place) {
    const auto found = object.find("extensions");
    if (found == object.end()) return;
    if (!found->is_object()) {
      warnings_.add(fmt::format("{}/extensions is not an object; ignored", place));
      object.erase(found);
      return;
    }
    for (auto it = found->begin(); it != found->end();) {
      const std::string& name = it.key();
      if (!declared_.contains(name)) {
        warnings_.add(fmt::format("{} uses the extension {} without declaring it",
                                  place.empty() ? "the file" : place, name));
      }
      if (!it.value().is_object()) {
        warnings_.add(fmt::format("{}/extensions/{} is not an object; ignored", place, name));
      } else if (supports_extension(name)) {
        if (belongs_at(name, place)) {
          ++it;
          continue;
        }
        warnings_.add(fmt::format("{}/extensions/{} is out of place; ignored", place, name));
      }
      it = found->erase(it);
    }
  }

  /// Reports unknown names, since a misspelt property is otherwise lost silently. Each is reported
  /// once, even if it occurs several times.
  void check_properties(const json& object, const std::string& place) {
    const std::string shape = without_numbers(place);
    for (const auto& [name, value] : object.items()) {
      if (!is_known_property(name, shape))
        warnings_.add(fmt::format("{} has '{}', which glTF does not know; ignored",
                                  shape == "/" ? "the file" : shape, name));
    }
  }

  /// Sets a property of the wrong kind to null, which removes it.
  void tidy_kind(const std::string& name, json& value, const std::string& place) {
    if (is_one_of(name, whole_names)) make_whole(value);
    const std::string_view kind = wrong_kind(name, value, place);
    if (kind.empty()) return;
    warnings_.add(fmt::format("{}/{} is not {}; ignored", place, name, kind));
    value = nullptr;
  }

  /// Sets an invalid reference to null, which removes it.
  Checked<void> tidy_number(const std::string& name, json& value, const std::string& place) {
    const bool size = is_one_of(name, size_names);
    if (!size && !is_one_of(name, reference_names)) return {};
    if (value.is_null() || (name == "indices" && value.is_object())) return {};  // of `sparse`
    make_whole(value);
    if (size && !value.is_number_unsigned()) {
      return fault(fmt::format("{}/{} is not a whole number", place, name));
    }
    if (!size && !is_index(value)) {
      warnings_.add(fmt::format("{}/{} is not an index; ignored", place, name));
      value = nullptr;
    }
    return {};
  }

  void tidy_list(const std::string& name, json& value, const std::string& place) {
    if (!is_one_of(name, list_names) || !value.is_array() || place.empty()) return;
    if (value.empty()) warnings_.add(fmt::format("{}/{} is an empty list", place, name));
    json kept = json::array();
    for (json& entry : value) {
      make_whole(entry);
      if (is_index(entry)) kept.push_back(entry);
    }
    if (kept.size() < value.size()) {
      warnings_.add(fmt::format("{}/{} has entries that are not indices; ignored", place, name));
    }
    value = std::move(kept);
  }

  // Measured for lists of a million small entries, and for the densest of real files.
  static constexpr std::uint64_t bytes_of_object = 1000, bytes_of_material = 4500;
  static constexpr std::uint64_t bytes_of_value = 200, bytes_of_joint = 150;
  static constexpr std::uint64_t free_memory = std::uint64_t{200} << 20, memory_per_byte = 40;

  Warnings& warnings_;
  std::set<std::string> declared_;
  std::uint64_t memory_left_;
};

void tidy_primitive(json& primitive, const std::string& place, Warnings& warnings) {
  json attributes = json::object();
  if (const auto found = primitive.find("attributes");
      found != primitive.end() && found->is_object()) {
    for (auto it = found->begin(); it != found->end(); ++it) {
      make_whole(it.value());
      if (is_index(it.value())) {
        attributes[it.key()] = it.value();
      } else {
        warnings.add(fmt::format("{}: attribute {} is not an index; ignored", place, it.key()));
      }
      // Application-specific attributes begin with an underscore.
      constexpr std::array<std::string_view, 7> known = {
          "POSITION", "NORMAL", "TANGENT", "TEXCOORD_", "COLOR_", "JOINTS_", "WEIGHTS_"};
      if (!it.key().starts_with('_') &&
          std::none_of(known.begin(), known.end(),
                       [&](std::string_view k) { return it.key().starts_with(k); })) {
        warnings.add(fmt::format("{}: attribute {} is unknown; ignored", place, it.key()));
      }
    }
  }
  if (const auto found = primitive.find("indices"); found != primitive.end()) {
    attributes[Document::indices_attribute] = *found;
    primitive.erase(found);
  }
  if (attributes.empty()) warnings.add_loss(place + " has no attributes");
  primitive["attributes"] = std::move(attributes);
}

void tidy_meshes(json& root, Warnings& warnings) {
  const auto meshes = root.find("meshes");
  if (meshes == root.end() || !meshes->is_array()) return;
  for (std::size_t m = 0; m < meshes->size(); ++m) {
    if (!(*meshes)[m].is_object()) continue;
    const auto primitives = (*meshes)[m].find("primitives");
    if (primitives == (*meshes)[m].end() || !primitives->is_array()) continue;
    for (std::size_t p = 0; p < primitives->size(); ++p) {
      if (!(*primitives)[p].is_object()) continue;
      tidy_primitive((*primitives)[p], fmt::format("mesh {} primitive {}", m, p), warnings);
    }
  }
}

bool is_minor_version(std::string_view text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

Checked<std::vector<std::string>> check_header(const json& root, Warnings& warnings) {
  const auto asset = root.find("asset");
  if (asset == root.end() || !asset->is_object() || !asset->contains("version") ||
      !(*asset)["version"].is_string()) {
    return fault("has no asset version, so it is not a glTF 2.0 file");
  }
  const std::string version = (*asset)["version"].get<std::string>();
  if (!version.starts_with("2.")) {
    return fault(
        fmt::format("glTF version '{}' is not supported, only 2.0", version.substr(0, 20)));
  }
  if (!is_minor_version(std::string_view(version).substr(2)))
    warnings.add(
        fmt::format("/asset/version is '{}', which is none; read as 2.0", version.substr(0, 20)));
  if (const auto least = asset->find("minVersion"); least != asset->end()) {
    if (!least->is_string() || least->get<std::string>() != "2.0") {
      return fault("needs a newer glTF version than 2.0 (asset.minVersion)");
    }
  }
  std::string refused;
  const std::set<std::string> used = strings_of(root, "extensionsUsed", warnings);
  for (const std::string& name : strings_of(root, "extensionsRequired", warnings)) {
    if (!used.contains(name)) warnings.add(name + " is required but not listed as used");
    if (supports_extension(name)) continue;
    refused += (refused.empty() ? "" : ", ") + name;
  }
  if (!refused.empty()) {
    const bool several = refused.find(',') != std::string::npos;
    const bool basisu = refused.find("KHR_texture_basisu") != std::string::npos;
    return fault(fmt::format("requires the extension{} {}, which {} not supported{}",
                             several ? "s" : "", refused, several ? "are" : "is",
                             basisu ? "; convert its KTX2 textures to PNG or WebP" : ""));
  }
  std::vector<std::string> optional;
  for (const std::string& name : used) {
    if (!supports_extension(name)) optional.push_back(name);
  }
  return optional;
}

Checked<void> tidy(json& root, std::size_t json_bytes, Warnings& warnings) {
  for (auto it = root.begin(); it != root.end(); ++it) {
    if (it.value().is_array() && it.value().empty()) {
      warnings.add(fmt::format("/{} is an empty list", it.key()));
    }
  }
  Tidier tidier(warnings, strings_of(root, "extensionsUsed", warnings), json_bytes);
  if (auto done = tidier.visit(root, ""); !done) return done;
  tidy_values(root, warnings);
  tidy_meshes(root, warnings);
  tidy_animations(root, warnings);
  tidy_area_lights(root);
  return {};
}

}  // namespace asos::gltf
