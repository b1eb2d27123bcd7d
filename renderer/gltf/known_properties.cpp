#include "renderer/gltf/known_properties.h"

#include <algorithm>
#include <unordered_map>
#include <vector>

namespace asos::gltf {

namespace {

using Names = std::vector<std::string_view>;

/// Returns the properties of glTF 2.0, section 5, by place; "name", "extensions" and "extras" may
/// be anywhere.
const std::unordered_map<std::string_view, Names>& names_by_shape() {
  static const Names texture{"index", "texCoord"};
  static const std::unordered_map<std::string_view, Names> all{
      {"/",
       {"accessors", "animations", "asset", "buffers", "bufferViews", "cameras", "extensionsUsed",
        "extensionsRequired", "images", "materials", "meshes", "nodes", "samplers", "scene",
        "scenes", "skins", "textures"}},
      {"/accessors",
       {"bufferView", "byteOffset", "componentType", "normalized", "count", "type", "max", "min",
        "sparse"}},
      {"/animations", {"channels", "samplers"}},
      {"/animations/channels", {"sampler", "target"}},
      {"/animations/channels/target", {"node", "path"}},
      {"/animations/samplers", {"input", "interpolation", "output"}},
      {"/cameras", {"orthographic", "perspective", "type"}},
      {"/cameras/orthographic", {"xmag", "ymag", "zfar", "znear"}},
      {"/cameras/perspective", {"aspectRatio", "yfov", "zfar", "znear"}},
      {"/images", {"uri", "mimeType", "bufferView"}},
      {"/materials",
       {"pbrMetallicRoughness", "normalTexture", "occlusionTexture", "emissiveTexture",
        "emissiveFactor", "alphaMode", "alphaCutoff", "doubleSided"}},
      {"/materials/pbrMetallicRoughness",
       {"baseColorFactor", "baseColorTexture", "metallicFactor", "roughnessFactor",
        "metallicRoughnessTexture"}},
      {"/materials/pbrMetallicRoughness/baseColorTexture", texture},
      {"/materials/pbrMetallicRoughness/metallicRoughnessTexture", texture},
      {"/materials/emissiveTexture", texture},
      {"/materials/normalTexture", {"index", "texCoord", "scale"}},
      {"/materials/occlusionTexture", {"index", "texCoord", "strength"}},
      {"/meshes", {"primitives", "weights"}},
      {"/meshes/primitives", {"attributes", "indices", "material", "mode", "targets"}},
      {"/nodes",
       {"camera", "children", "skin", "matrix", "mesh", "rotation", "scale", "translation",
        "weights"}},
      {"/samplers", {"magFilter", "minFilter", "wrapS", "wrapT"}},
      {"/scenes", {"nodes"}},
      {"/skins", {"inverseBindMatrices", "skeleton", "joints"}},
      {"/textures", {"sampler", "source"}},
  };
  return all;
}

}  // namespace

bool is_known_property(std::string_view name, std::string_view shape) {
  if (name == "name" || name == "extensions" || name == "extras") return true;
  const auto names = names_by_shape().find(shape);
  if (names == names_by_shape().end()) return true;
  return std::find(names->second.begin(), names->second.end(), name) != names->second.end();
}

}  // namespace asos::gltf
