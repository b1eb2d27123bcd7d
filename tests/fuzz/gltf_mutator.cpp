#include "tests/fuzz/gltf_mutator.h"

#include "tests/fuzz/gltf_features.h"
#include "tests/fuzz/json_mutator.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

namespace asos::fuzz {
namespace {

constexpr auto words = std::to_array<const char*>({"POSITION",
                                                   "NORMAL",
                                                   "TANGENT",
                                                   "TEXCOORD_0",
                                                   "TEXCOORD_1",
                                                   "COLOR_0",
                                                   "JOINTS_0",
                                                   "WEIGHTS_0",
                                                   "TRANSLATION",
                                                   "ROTATION",
                                                   "SCALE",
                                                   "SCALAR",
                                                   "VEC2",
                                                   "VEC3",
                                                   "VEC4",
                                                   "MAT4",
                                                   "OPAQUE",
                                                   "MASK",
                                                   "BLEND",
                                                   "perspective",
                                                   "orthographic",
                                                   "KHR_lights_punctual",
                                                   "EXT_lights_area",
                                                   "EXT_mesh_gpu_instancing",
                                                   "KHR_implicit_shapes",
                                                   "ASOS_implicit_shape",
                                                   "asos_shape",
                                                   "asos_light",
                                                   "asos_dfr",
                                                   "asos_fuzz",
                                                   "KHR_texture_transform",
                                                   "KHR_materials_unlit",
                                                   "KHR_materials_ior",
                                                   "KHR_materials_pbrSpecularGlossiness",
                                                   "EXT_texture_webp",
                                                   "KHR_materials_clearcoat",
                                                   "KHR_materials_sheen",
                                                   "KHR_materials_iridescence",
                                                   "KHR_materials_anisotropy",
                                                   "EXT_lights_image_based",
                                                   "KHR_materials_specular",
                                                   "KHR_materials_transmission",
                                                   "KHR_materials_volume",
                                                   "KHR_materials_dispersion",
                                                   "KHR_materials_diffuse_transmission",
                                                   "KHR_materials_emissive_strength",
                                                   "KHR_draco_mesh_compression",
                                                   "EXT_meshopt_compression",
                                                   "KHR_mesh_quantization",
                                                   "extensions",
                                                   "extras",
                                                   "matrix",
                                                   "translation",
                                                   "rotation",
                                                   "scale",
                                                   "children",
                                                   "mesh",
                                                   "camera",
                                                   "skin",
                                                   "weights",
                                                   "nodes",
                                                   "meshes",
                                                   "materials",
                                                   "accessors",
                                                   "bufferViews",
                                                   "buffers",
                                                   "byteOffset",
                                                   "byteLength",
                                                   "byteStride",
                                                   "bufferView",
                                                   "componentType",
                                                   "count",
                                                   "type",
                                                   "sparse",
                                                   "indices",
                                                   "values",
                                                   "mode",
                                                   "targets",
                                                   "doubleSided",
                                                   "alphaMode",
                                                   "alphaCutoff",
                                                   "baseColorFactor",
                                                   "metallicFactor",
                                                   "roughnessFactor",
                                                   "emissiveFactor",
                                                   "emissiveStrength",
                                                   "normalTexture",
                                                   "yfov",
                                                   "xmag",
                                                   "ymag",
                                                   "znear",
                                                   "zfar",
                                                   "aspectRatio",
                                                   "intensity",
                                                   "range",
                                                   "radius",
                                                   "spot",
                                                   "innerConeAngle",
                                                   "outerConeAngle",
                                                   "point",
                                                   "directional",
                                                   "rect",
                                                   "disk",
                                                   "sphere",
                                                   "cylinder",
                                                   "radiusTop",
                                                   "height",
                                                   "size",
                                                   "animations",
                                                   "channels",
                                                   "samplers",
                                                   "sampler",
                                                   "input",
                                                   "output",
                                                   "interpolation",
                                                   "STEP",
                                                   "LINEAR",
                                                   "CUBICSPLINE",
                                                   "target",
                                                   "path",
                                                   "node",
                                                   "pointer",
                                                   "KHR_animation_pointer",
                                                   "/nodes/0/rotation",
                                                   "joints",
                                                   "skins",
                                                   "inverseBindMatrices",
                                                   "KHR_materials_variants",
                                                   "KHR_node_visibility",
                                                   "MSFT_lod",
                                                   "variants",
                                                   "mappings",
                                                   "visible",
                                                   "ids",
                                                   "ior",
                                                   "dispersion",
                                                   "thicknessFactor",
                                                   "attenuationDistance",
                                                   "attenuationColor",
                                                   "transmissionFactor",
                                                   "clearcoatFactor",
                                                   "clearcoatNormalTexture",
                                                   "sheenColorFactor",
                                                   "sheenRoughnessFactor",
                                                   "iridescenceFactor",
                                                   "iridescenceIor",
                                                   "iridescenceThicknessMaximum",
                                                   "diffuseFactor",
                                                   "glossinessFactor",
                                                   "specularGlossinessTexture",
                                                   "diffuseTransmissionFactor",
                                                   "KHR_meshopt_compression",
                                                   "KHR_texture_basisu",
                                                   "polygon",
                                                   "linear",
                                                   "corners",
                                                   "from",
                                                   "to",
                                                   "min",
                                                   "max",
                                                   "exponent",
                                                   "perturbation",
                                                   "source",
                                                   "mimeType",
                                                   "image/webp",
                                                   "texCoord",
                                                   "index",
                                                   "scene",
                                                   "scenes"});

struct Parts {
  Json json;
  std::string bin;
  bool binary = false;
};

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

std::optional<Parts> split(std::string_view file) {
  Parts parts;
  std::string_view json = file;
  parts.binary = file.starts_with("glTF");
  if (parts.binary) {
    constexpr std::size_t head = 20;
    if (file.size() < head || word_at(file, 12) > file.size() - head) return std::nullopt;
    json = file.substr(head, word_at(file, 12));
    const std::string_view rest = file.substr(head + json.size());
    if (rest.size() > 8) parts.bin = rest.substr(8);
  }
  parts.json = Json::parse(json, nullptr, false);
  if (!parts.json.is_object()) return std::nullopt;
  return parts;
}

void put(std::string& bytes, std::size_t value) {
  const auto word = static_cast<std::uint32_t>(value);
  bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
}

std::string joined(const Parts& parts) {
  std::string json = parts.json.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (!parts.binary) return json;
  std::string bin = parts.bin;
  while (json.size() % 4 != 0) json.push_back(' ');
  while (bin.size() % 4 != 0) bin.push_back('\0');
  std::string file = "glTF";
  put(file, 2);
  put(file, 12 + 8 + json.size() + (bin.empty() ? 0 : 8 + bin.size()));
  put(file, json.size());
  file += "JSON" + json;
  if (bin.empty()) return file;
  put(file, bin.size());
  return file + std::string("BIN\0", 4) + bin;
}

float unlikely_float(std::mt19937& random) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  switch (random() % 8) {
    case 0:
      return std::numeric_limits<float>::quiet_NaN();
    case 1:
      return random() % 2 == 0 ? infinity : -infinity;
    default: {
      const double number = unlikely_number(random);
      constexpr double largest = std::numeric_limits<float>::max();
      return static_cast<float>(std::min(std::max(number, -largest), largest));
    }
  }
}

// Makes geometry difficult: points that coincide, are collinear or coplanar, differ by one bit, are
// not numbers, or are far away.
void change_numbers(std::string& bin, std::mt19937& random) {
  constexpr std::size_t word = sizeof(float), point = 3 * word;
  if (bin.size() < 2 * point) return;
  const auto any_word = [&](std::size_t length) {
    return word * (random() % ((bin.size() - length) / word + 1));
  };
  const std::size_t at = any_word(point);
  float number = 0.0f;
  std::memcpy(&number, bin.data() + at, word);
  const auto set = [&](std::size_t place, float value) {
    std::memcpy(bin.data() + place, &value, word);
  };
  switch (random() % 8) {
    case 0:
      return set(at, unlikely_float(random));
    case 1:
      return set(at, number * (random() % 2 == 0 ? 1e18f : 1e-18f));
    case 2:
      return set(at, std::bit_cast<float>(std::bit_cast<std::uint32_t>(number) + 1u));
    case 3:  // a point onto another
      return std::string(bin, any_word(point), point).copy(bin.data() + at, point), void();
    case 4: {  // one coordinate of several points
      const std::size_t stride = word * (2 + random() % 7), count = 2 + random() % 32;
      for (std::size_t i = 0; i < count && at + i * stride + word <= bin.size(); ++i)
        set(at + i * stride, number);
      return;
    }
    case 5: {  // a run of numbers
      const std::size_t length = word * (1 + random() % 64);
      for (std::size_t i = at; i < at + length && i + word <= bin.size(); i += word) set(i, number);
      return;
    }
    case 6:
      bin[at] = static_cast<char>(random());
      return;
    default:
      return set(at, -number);
  }
}

}  // namespace

std::string mutated_gltf(std::string_view file, unsigned seed) {
  std::optional<Parts> parts = split(file);
  if (!parts) return "";
  std::mt19937 random(seed);
  const unsigned choice = random() % 4;
  if (random() % 2 == 0) add_feature(parts->json, random);
  if (choice != 0) mutate(parts->json, words, random);
  if (choice != 1) {
    for (unsigned i = random() % 4 + 1; i > 0; --i) change_numbers(parts->bin, random);
  }
  return joined(*parts);
}

}  // namespace asos::fuzz
