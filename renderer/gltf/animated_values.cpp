#include "renderer/gltf/animated_values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace asos::gltf {

using nlohmann::json;

namespace {

constexpr std::string_view lights_place = "/extensions/KHR_lights_punctual/lights/";

/// Properties of the objects at `within`, which follows the index of a material, camera or light.
struct Movable {
  std::string_view root, within;
  int numbers;
  std::vector<std::string_view> names;
};

const std::vector<Movable>& movables() {
  constexpr std::string_view material = "/materials/", camera = "/cameras/";
  static const std::vector<Movable> all{
      {camera, "/perspective", 1, {"yfov", "aspectRatio", "znear", "zfar"}},
      {camera, "/orthographic", 1, {"xmag", "ymag", "znear", "zfar"}},
      {lights_place, "", 1, {"intensity", "range"}},
      {lights_place, "", 3, {"color"}},
      {lights_place, "/spot", 1, {"innerConeAngle", "outerConeAngle"}},
      {material, "", 1, {"alphaCutoff"}},
      {material, "", 3, {"emissiveFactor"}},
      {material, "/normalTexture", 1, {"scale"}},
      {material, "/occlusionTexture", 1, {"strength"}},
      {material, "/pbrMetallicRoughness", 4, {"baseColorFactor"}},
      {material, "/pbrMetallicRoughness", 1, {"metallicFactor", "roughnessFactor"}},
      {material, "/KHR_materials_anisotropy", 1, {"anisotropyStrength", "anisotropyRotation"}},
      {material, "/KHR_materials_clearcoat", 1, {"clearcoatFactor", "clearcoatRoughnessFactor"}},
      {material, "/KHR_materials_clearcoat/clearcoatNormalTexture", 1, {"scale"}},
      {material, "/KHR_materials_diffuse_transmission", 1, {"diffuseTransmissionFactor"}},
      {material, "/KHR_materials_diffuse_transmission", 3, {"diffuseTransmissionColorFactor"}},
      {material, "/KHR_materials_dispersion", 1, {"dispersion"}},
      {material, "/KHR_materials_emissive_strength", 1, {"emissiveStrength"}},
      {material, "/KHR_materials_ior", 1, {"ior"}},
      {material,
       "/KHR_materials_iridescence",
       1,
       {"iridescenceFactor", "iridescenceIor", "iridescenceThicknessMinimum",
        "iridescenceThicknessMaximum"}},
      {material, "/KHR_materials_sheen", 1, {"sheenRoughnessFactor"}},
      {material, "/KHR_materials_sheen", 3, {"sheenColorFactor"}},
      {material, "/KHR_materials_specular", 1, {"specularFactor"}},
      {material, "/KHR_materials_specular", 3, {"specularColorFactor"}},
      {material, "/KHR_materials_transmission", 1, {"transmissionFactor"}},
      {material, "/KHR_materials_volume", 1, {"thicknessFactor", "attenuationDistance"}},
      {material, "/KHR_materials_volume", 3, {"attenuationColor"}},
  };
  return all;
}

/// The parts of a pointer: "/materials/", 3, "/pbrMetallicRoughness", "roughnessFactor".
struct PointedAt {
  std::string_view root;
  std::size_t number = 0;
  std::string within;  ///< without "/extensions" before the names of extensions
  std::string_view name;
};

std::optional<PointedAt> place_of(std::string_view pointer) {
  for (const std::string_view root :
       {std::string_view("/materials/"), std::string_view("/cameras/"), lights_place}) {
    if (!pointer.starts_with(root)) continue;
    PointedAt place{root, 0, {}, {}};
    const std::string_view rest = pointer.substr(root.size());
    const char* const end = rest.data() + rest.size();
    const auto [after, error] = std::from_chars(rest.data(), end, place.number);
    const bool padded = rest.size() > 1 && rest[0] == '0' && after != rest.data() + 1;
    if (error != std::errc() || after == end || *after != '/' || padded) return std::nullopt;
    const std::string_view path(after, static_cast<std::size_t>(end - after));
    const std::size_t last = path.rfind('/');
    place.name = path.substr(last + 1);
    place.within = std::string(path.substr(0, last));
    constexpr std::string_view step = "/extensions";
    for (std::size_t at = place.within.find(step); at != std::string::npos;
         at = place.within.find(step))
      place.within.erase(at, step.size());
    return place;
  }
  return std::nullopt;
}

/// Counts the numbers of a KHR_texture_transform property, in any texture of a material.
std::optional<int> transform_numbers(const PointedAt& place) {
  if (place.root != "/materials/" || !place.within.ends_with("Texture/KHR_texture_transform"))
    return std::nullopt;
  if (place.name == "offset" || place.name == "scale") return 2;
  if (place.name == "rotation") return 1;
  return std::nullopt;
}

/// Returns the object that contains a property; null: it does not exist.
template <typename Json>
Json* object_of(Json& root, std::string_view pointer) {
  Json* at = &root;
  const std::size_t last = pointer.rfind('/');
  for (std::size_t begin = 1; begin <= last;) {
    const std::size_t end = pointer.find('/', begin);
    const std::string step(pointer.substr(begin, end - begin));
    if (at->is_array()) {
      std::size_t number = 0;
      const auto read = std::from_chars(step.data(), step.data() + step.size(), number);
      if (read.ec != std::errc() || number >= at->size()) return nullptr;
      at = &(*at)[number];
    } else {
      const auto found = at->find(step);
      if (!at->is_object() || found == at->end()) return nullptr;
      at = &*found;
    }
    begin = end + 1;
  }
  return at->is_object() ? at : nullptr;
}

}  // namespace

std::optional<int> movable_numbers(std::string_view pointer) {
  const std::optional<PointedAt> place = place_of(pointer);
  if (!place) return std::nullopt;
  for (const Movable& movable : movables()) {
    if (movable.root != place->root || movable.within != place->within) continue;
    if (std::ranges::find(movable.names, place->name) != movable.names.end())
      return movable.numbers;
  }
  return transform_numbers(*place);
}

bool has_object_of(const json& root, std::string_view pointer) {
  return object_of(root, pointer) != nullptr;
}

std::optional<std::size_t> material_of(std::string_view pointer) {
  const std::optional<PointedAt> place = place_of(pointer);
  if (!place || place->root != "/materials/") return std::nullopt;
  return place->number;
}

json movable_parts(const json& root) {
  json parts{{"asset", {{"version", "2.0"}}}};
  for (const char* list : {"materials", "cameras"}) {
    if (root.contains(list)) parts[list] = root[list];
  }
  constexpr const char* lights = "KHR_lights_punctual";
  if (root.contains("extensions") && root["extensions"].contains(lights))
    parts["extensions"][lights] = root["extensions"][lights];
  return parts;
}

Checked<void> set_values(json parts, const std::vector<AnimatedValue>& values,
                         tinygltf::Model& model) {
  for (const AnimatedValue& value : values) {
    json* object = object_of(parts, value.pointer);
    if (!object) continue;
    json& property = (*object)[value.pointer.substr(value.pointer.rfind('/') + 1)];
    if (value.numbers.size() == 1) {
      property = value.numbers.front();
    } else {
      property = value.numbers;
    }
  }
  const std::string text = parts.dump();
  tinygltf::TinyGLTF reader;
  tinygltf::Model moved;
  std::string error, warning;
  if (!reader.LoadASCIIFromString(&moved, &error, &warning, text.data(),
                                  static_cast<unsigned>(text.size()), "", tinygltf::NO_REQUIRE))
    return fault("its moved materials, lights and cameras cannot be read");
  model.materials = std::move(moved.materials);
  model.cameras = std::move(moved.cameras);
  model.lights = std::move(moved.lights);
  return {};
}

}  // namespace asos::gltf
