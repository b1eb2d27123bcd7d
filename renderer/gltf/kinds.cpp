#include "renderer/gltf/kinds.h"

#include "renderer/gltf/known_extensions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <unordered_map>
#include <vector>

namespace asos::gltf {

using nlohmann::json;

namespace {

enum class Kind {
  object,
  texture,
  list,
  objects,
  text,
  truth,
  number,
  above_zero,
  whole,
  index,
  numbers,
  two_numbers,
  three_numbers,
  four_numbers
};

/// A rule for properties of the objects at `within`: the end of their place without the numbers of
/// entries.
struct Rule {
  std::string_view within;
  Kind kind;
  std::vector<std::string_view> names;
};

// The core format's own properties, whose names extensions and animations use for other purposes.
constexpr std::string_view core = "";

const std::vector<Rule>& rules() {
  static const std::vector<Rule> all{
      {core, Kind::object, {"pbrMetallicRoughness", "perspective", "orthographic", "sparse"}},
      {core,
       Kind::texture,
       {"baseColorTexture", "metallicRoughnessTexture", "normalTexture", "occlusionTexture",
        "emissiveTexture"}},
      {core, Kind::numbers, {"matrix", "rotation", "translation", "weights"}},
      {core, Kind::four_numbers, {"baseColorFactor"}},
      {core, Kind::three_numbers, {"emissiveFactor"}},
      {core, Kind::number, {"metallicFactor", "roughnessFactor", "alphaCutoff"}},
      {core, Kind::truth, {"doubleSided"}},
      {core, Kind::text, {"alphaMode", "name"}},
      {"/",
       Kind::list,
       {"accessors", "animations", "bufferViews", "cameras", "materials", "meshes", "nodes",
        "samplers", "scenes", "skins", "textures"}},
      {"/scenes", Kind::list, {"nodes"}},
      {"/nodes", Kind::list, {"children"}},
      {"/nodes", Kind::numbers, {"scale"}},
      {"/nodes/extensions/KHR_node_visibility", Kind::truth, {"visible"}},
      {"/EXT_mesh_gpu_instancing", Kind::object, {"attributes"}},
      {"/EXT_mesh_gpu_instancing/attributes", Kind::index, {"TRANSLATION", "ROTATION", "SCALE"}},
      {"/meshes", Kind::objects, {"primitives"}},
      {"/primitives", Kind::object, {"attributes"}},
      {"/primitives", Kind::objects, {"targets"}},
      {"/primitives", Kind::whole, {"mode"}},
      {"/primitives/targets", Kind::index, {"POSITION", "NORMAL", "TANGENT"}},
      {"/accessors", Kind::truth, {"normalized"}},
      {"/animations", Kind::objects, {"channels", "samplers"}},
      {"/skins", Kind::list, {"joints"}},
      {"/perspective", Kind::above_zero, {"aspectRatio"}},
      {"/samplers", Kind::whole, {"wrapS", "wrapT", "magFilter", "minFilter"}},
      {"/normalTexture", Kind::number, {"scale"}},
      {"/occlusionTexture", Kind::number, {"strength"}},
      {"/KHR_texture_transform", Kind::two_numbers, {"offset", "scale"}},
      {"/KHR_texture_transform", Kind::number, {"rotation"}},
      {"/KHR_lights_punctual/lights", Kind::three_numbers, {"color"}},
      {"/KHR_lights_punctual/lights", Kind::number, {"intensity"}},
      {"/KHR_lights_punctual/lights", Kind::above_zero, {"range"}},
      {"/lights/spot", Kind::number, {"innerConeAngle", "outerConeAngle"}},
      {"/KHR_materials_variants", Kind::objects, {"variants", "mappings"}},
      {"/KHR_materials_variants/mappings", Kind::list, {"variants"}},
      {"/KHR_materials_ior", Kind::number, {"ior"}},
      {"/KHR_materials_transmission", Kind::number, {"transmissionFactor"}},
      {"/KHR_materials_transmission", Kind::texture, {"transmissionTexture"}},
      {"/KHR_materials_emissive_strength", Kind::number, {"emissiveStrength"}},
      {"/KHR_materials_dispersion", Kind::number, {"dispersion"}},
      {"/KHR_materials_volume", Kind::number, {"thicknessFactor", "attenuationDistance"}},
      {"/KHR_materials_volume", Kind::three_numbers, {"attenuationColor"}},
      {"/KHR_materials_volume", Kind::texture, {"thicknessTexture"}},
      {"/KHR_materials_specular", Kind::number, {"specularFactor"}},
      {"/KHR_materials_specular", Kind::three_numbers, {"specularColorFactor"}},
      {"/KHR_materials_specular", Kind::texture, {"specularTexture", "specularColorTexture"}},
      {"/KHR_materials_clearcoat", Kind::number, {"clearcoatFactor", "clearcoatRoughnessFactor"}},
      {"/KHR_materials_clearcoat",
       Kind::texture,
       {"clearcoatTexture", "clearcoatRoughnessTexture", "clearcoatNormalTexture"}},
      {"/clearcoatNormalTexture", Kind::number, {"scale"}},
      {"/KHR_materials_sheen", Kind::three_numbers, {"sheenColorFactor"}},
      {"/KHR_materials_sheen", Kind::number, {"sheenRoughnessFactor"}},
      {"/KHR_materials_sheen", Kind::texture, {"sheenColorTexture", "sheenRoughnessTexture"}},
      {"/KHR_materials_iridescence",
       Kind::number,
       {"iridescenceFactor", "iridescenceIor", "iridescenceThicknessMinimum",
        "iridescenceThicknessMaximum"}},
      {"/KHR_materials_iridescence",
       Kind::texture,
       {"iridescenceTexture", "iridescenceThicknessTexture"}},
      {"/KHR_materials_anisotropy", Kind::number, {"anisotropyStrength", "anisotropyRotation"}},
      {"/KHR_materials_anisotropy", Kind::texture, {"anisotropyTexture"}},
      {"/KHR_materials_diffuse_transmission", Kind::number, {"diffuseTransmissionFactor"}},
      {"/KHR_materials_diffuse_transmission",
       Kind::three_numbers,
       {"diffuseTransmissionColorFactor"}},
      {"/KHR_materials_diffuse_transmission",
       Kind::texture,
       {"diffuseTransmissionTexture", "diffuseTransmissionColorTexture"}},
      {"/KHR_materials_pbrSpecularGlossiness", Kind::four_numbers, {"diffuseFactor"}},
      {"/KHR_materials_pbrSpecularGlossiness", Kind::three_numbers, {"specularFactor"}},
      {"/KHR_materials_pbrSpecularGlossiness", Kind::number, {"glossinessFactor"}},
      {"/KHR_materials_pbrSpecularGlossiness",
       Kind::texture,
       {"diffuseTexture", "specularGlossinessTexture"}},
  };
  return all;
}

using RulesByName = std::unordered_map<std::string_view, std::vector<const Rule*>>;

const RulesByName& rules_by_name() {
  static const RulesByName all = [] {
    RulesByName by_name;
    for (const Rule& rule : rules())
      for (const std::string_view name : rule.names) by_name[name].push_back(&rule);
    return by_name;
  }();
  return all;
}

bool concerns(const Rule& rule, std::string_view place, const std::string& shape) {
  if (rule.within == core) {
    return place.find("/extensions") == std::string_view::npos &&
           (!place.starts_with("/animations") || rule.kind == Kind::text);
  }
  return shape.ends_with(rule.within);
}

/// Returns whether a value lists `count` numbers; 0: one or more.
bool are_numbers(const json& value, std::size_t count) {
  return value.is_array() && !value.empty() && (count == 0 || value.size() == count) &&
         std::all_of(value.begin(), value.end(), [](const json& v) { return v.is_number(); });
}

bool are_objects(const json& value) {
  return value.is_array() &&
         std::all_of(value.begin(), value.end(), [](const json& v) { return v.is_object(); });
}

/// Returns a description of the kind if `value` is not of it; else an empty string.
std::string_view unlike(Kind kind, const json& value) {
  switch (kind) {
    case Kind::object:
      return value.is_object() ? "" : "an object";
    case Kind::texture:
      if (!value.is_object()) return "an object";
      return value.contains("index") ? "" : "a texture, which has an index";
    case Kind::list:
      return value.is_array() ? "" : "a list";
    case Kind::objects:
      if (value.empty()) return "a list with an entry";
      return are_objects(value) ? "" : "a list of objects";
    case Kind::text:
      return value.is_string() ? "" : "a text";
    case Kind::truth:
      return value.is_boolean() ? "" : "true or false";
    case Kind::number:
      return value.is_number() ? "" : "a number";
    case Kind::above_zero:
      return value.is_number() && value.get<double>() > 0.0 ? "" : "a number above 0";
    case Kind::whole:
      return is_whole(value) ? "" : "a whole number";
    case Kind::index:
      return is_whole(value) && value.get<double>() >= 0.0 ? "" : "an index";
    case Kind::numbers:
      return are_numbers(value, 0) ? "" : "a list of numbers";
    case Kind::two_numbers:
      return are_numbers(value, 2) ? "" : "two numbers";
    case Kind::three_numbers:
      return are_numbers(value, 3) ? "" : "three numbers";
    case Kind::four_numbers:
      return are_numbers(value, 4) ? "" : "four numbers";
  }
  return "";
}

}  // namespace

bool is_whole(const json& value) {
  if (value.is_number_integer()) return true;
  if (!value.is_number_float()) return false;
  const double number = value.get<double>();
  return std::abs(number) < 9e15 && number == std::floor(number);
}

std::string_view wrong_kind(std::string_view name, const json& value, std::string_view place) {
  const auto named = rules_by_name().find(name);
  if (named == rules_by_name().end() || value.is_null()) return "";
  const std::string shape = without_numbers(place);
  for (const Rule* rule : named->second) {
    if (!concerns(*rule, place, shape)) continue;
    if (const std::string_view kind = unlike(rule->kind, value); !kind.empty()) return kind;
  }
  return "";
}

}  // namespace asos::gltf
