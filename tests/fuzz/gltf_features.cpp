#include "tests/fuzz/gltf_features.h"

#include <array>
#include <cstddef>
#include <string>

namespace asos::fuzz {
namespace {

enum class Kind { share, number, color, texture };

struct Member {
  const char* extension;
  const char* name;
  Kind kind;
};

constexpr auto of_materials = std::to_array<Member>({
    {"KHR_materials_ior", "ior", Kind::number},
    {"KHR_materials_specular", "specularFactor", Kind::share},
    {"KHR_materials_specular", "specularTexture", Kind::texture},
    {"KHR_materials_specular", "specularColorFactor", Kind::color},
    {"KHR_materials_specular", "specularColorTexture", Kind::texture},
    {"KHR_materials_transmission", "transmissionFactor", Kind::share},
    {"KHR_materials_transmission", "transmissionTexture", Kind::texture},
    {"KHR_materials_volume", "thicknessFactor", Kind::number},
    {"KHR_materials_volume", "thicknessTexture", Kind::texture},
    {"KHR_materials_volume", "attenuationDistance", Kind::number},
    {"KHR_materials_volume", "attenuationColor", Kind::color},
    {"KHR_materials_dispersion", "dispersion", Kind::number},
    {"KHR_materials_diffuse_transmission", "diffuseTransmissionFactor", Kind::share},
    {"KHR_materials_diffuse_transmission", "diffuseTransmissionTexture", Kind::texture},
    {"KHR_materials_diffuse_transmission", "diffuseTransmissionColorFactor", Kind::color},
    {"KHR_materials_diffuse_transmission", "diffuseTransmissionColorTexture", Kind::texture},
    {"KHR_materials_clearcoat", "clearcoatFactor", Kind::share},
    {"KHR_materials_clearcoat", "clearcoatTexture", Kind::texture},
    {"KHR_materials_clearcoat", "clearcoatRoughnessFactor", Kind::share},
    {"KHR_materials_clearcoat", "clearcoatRoughnessTexture", Kind::texture},
    {"KHR_materials_clearcoat", "clearcoatNormalTexture", Kind::texture},
    {"KHR_materials_sheen", "sheenColorFactor", Kind::color},
    {"KHR_materials_sheen", "sheenColorTexture", Kind::texture},
    {"KHR_materials_sheen", "sheenRoughnessFactor", Kind::share},
    {"KHR_materials_sheen", "sheenRoughnessTexture", Kind::texture},
    {"KHR_materials_iridescence", "iridescenceFactor", Kind::share},
    {"KHR_materials_iridescence", "iridescenceTexture", Kind::texture},
    {"KHR_materials_iridescence", "iridescenceIor", Kind::number},
    {"KHR_materials_iridescence", "iridescenceThicknessMinimum", Kind::number},
    {"KHR_materials_iridescence", "iridescenceThicknessMaximum", Kind::number},
    {"KHR_materials_iridescence", "iridescenceThicknessTexture", Kind::texture},
    {"KHR_materials_anisotropy", "anisotropyStrength", Kind::share},
    {"KHR_materials_anisotropy", "anisotropyRotation", Kind::number},
    {"KHR_materials_anisotropy", "anisotropyTexture", Kind::texture},
    {"KHR_materials_pbrSpecularGlossiness", "diffuseFactor", Kind::color},
    {"KHR_materials_pbrSpecularGlossiness", "diffuseTexture", Kind::texture},
    {"KHR_materials_pbrSpecularGlossiness", "specularFactor", Kind::color},
    {"KHR_materials_pbrSpecularGlossiness", "glossinessFactor", Kind::share},
    {"KHR_materials_pbrSpecularGlossiness", "specularGlossinessTexture", Kind::texture},
    {"KHR_materials_emissive_strength", "emissiveStrength", Kind::number},
    {"KHR_materials_unlit", "unlit", Kind::share},
});

std::size_t size_of(const Json& document, const char* list) {
  const auto found = document.find(list);
  return found != document.end() && found->is_array() ? found->size() : 0;
}

/// A random index into a list, rarely one past its end; 0 if there is no list.
std::size_t any_index(const Json& document, const char* list, std::mt19937& random) {
  const std::size_t size = size_of(document, list);
  return size == 0 ? 0 : random() % (random() % 16 == 0 ? size + 1 : size);
}

/// A random object of a list; null if there is none.
Json* any_object(Json& owner, const char* list, std::mt19937& random) {
  const std::size_t size = size_of(owner, list);
  if (size == 0) return nullptr;
  Json& object = owner[list][random() % size];
  return object.is_object() ? &object : nullptr;
}

/// An object's member that is an object; created if missing.
Json& object_in(Json& object, const char* name) {
  Json& member = object[name];
  if (!member.is_object()) member = Json::object();
  return member;
}

void use(Json& document, const char* extension) {
  document["extensionsUsed"].push_back(extension);
}

double share(std::mt19937& random) {
  if (random() % 16 == 0) return unlikely_number(random);
  return static_cast<double>(random() % 5) / 4.0;
}

double number(std::mt19937& random) {
  constexpr std::array usual{0.0, 0.01, 0.3, 1.0, 1.33, 1.5, 2.4, 10.0, 400.0};
  return random() % 4 == 0 ? unlikely_number(random) : usual[random() % usual.size()];
}

Json value_of(Kind kind, const Json& document, std::mt19937& random) {
  switch (kind) {
    case Kind::share:
      return share(random);
    case Kind::number:
      return number(random);
    case Kind::color:
      return {share(random), share(random), random() % 8 == 0 ? number(random) : share(random)};
    case Kind::texture:
      break;
  }
  Json texture{{"index", any_index(document, "textures", random)}};
  if (random() % 4 == 0) texture["texCoord"] = random() % 2;
  if (random() % 4 == 0)
    texture["extensions"]["KHR_texture_transform"] = {{"scale", {number(random), number(random)}}};
  return texture;
}

/// Adds an extension with some of its members.
void extend_material(Json& document, Json& material, std::mt19937& random) {
  const std::string extension = of_materials[random() % of_materials.size()].extension;
  Json& extended = object_in(object_in(material, "extensions"), extension.c_str());
  for (const Member& member : of_materials)
    if (extension == member.extension && random() % 2 == 0)
      extended[member.name] = value_of(member.kind, document, random);
  use(document, extension.c_str());
}

/// Gives a material an alpha cut-out, blending, or a blur of its reflection.
void change_material(const Json& document, Json& material, std::mt19937& random) {
  if (random() % 3 == 0) {
    object_in(material, "extras")["asos_dfr"] = {{"min", share(random)},
                                                 {"max", share(random)},
                                                 {"exponent", number(random)},
                                                 {"perturbation", share(random)}};
    return;
  }
  material["alphaMode"] = random() % 2 == 0 ? "MASK" : "BLEND";
  if (random() % 2 == 0) material["alphaCutoff"] = share(random);
  object_in(material, "pbrMetallicRoughness")["baseColorTexture"] =
      value_of(Kind::texture, document, random);
}

/// Adds a morph target to a mesh, with its weight.
void morph(const Json& document, Json& mesh, Json& primitive, std::mt19937& random) {
  Json target = Json::object();
  for (const char* name : {"POSITION", "NORMAL", "TANGENT"})
    if (random() % 2 == 0) target[name] = any_index(document, "accessors", random);
  if (!primitive["targets"].is_array()) primitive["targets"] = Json::array();
  primitive["targets"].push_back(std::move(target));
  if (!mesh["weights"].is_array()) mesh["weights"] = Json::array();
  mesh["weights"].push_back(number(random));
}

void extend_primitive(Json& document, Json& mesh, std::mt19937& random) {
  // Must come first: adding a member invalidates pointers to the others.
  if (!mesh["weights"].is_array()) mesh["weights"] = Json::array();
  Json* primitive = any_object(mesh, "primitives", random);
  if (!primitive) return;
  if (random() % 3 == 0) return morph(document, mesh, *primitive, random);
  if (random() % 2 == 0) {
    (*primitive)["mode"] = random() % 8;
    return;
  }
  constexpr const char* variants = "KHR_materials_variants";
  object_in(document["extensions"], variants)["variants"] = {{{"name", "a"}}, {{"name", "b"}}};
  object_in(object_in(*primitive, "extensions"), variants)["mappings"] =
      Json::array({{{"material", any_index(document, "materials", random)},
                    {"variants", Json::array({random() % 3})}}});
  use(document, variants);
}

/// Adds instances of a node's mesh; their accessors often have the wrong contents.
void copy_node(Json& document, Json& node, std::mt19937& random) {
  constexpr const char* extension = "EXT_mesh_gpu_instancing";
  Json& extended = object_in(object_in(node, "extensions"), extension);
  for (const char* name : {"TRANSLATION", "ROTATION", "SCALE"})
    if (random() % 2 == 0)
      object_in(extended, "attributes")[name] = any_index(document, "accessors", random);
  use(document, extension);
}

/// Adds an image-based light to the file and assigns it to a scene.
void surround(Json& document, std::mt19937& random) {
  constexpr const char* extension = "EXT_lights_image_based";
  Json sides = Json::array(), coefficients = Json::array();
  const std::size_t image = any_index(document, "images", random);
  for (int i = 0; i < 6; ++i)
    sides.push_back(random() % 8 == 0 ? any_index(document, "images", random) : image);
  for (int i = 0; i < 9; ++i)
    coefficients.push_back({number(random), number(random), number(random)});
  Json light{{"specularImages", Json::array({sides})},
             {"irradianceCoefficients", coefficients},
             {"specularImageSize", 1},
             {"intensity", number(random)}};
  if (random() % 2 == 0)
    light["rotation"] = {share(random), share(random), share(random), number(random)};
  object_in(document["extensions"], extension)["lights"] = Json::array({std::move(light)});
  if (Json* scene = any_object(document, "scenes", random))
    object_in(object_in(*scene, "extensions"), extension)["light"] = 0;
  use(document, extension);
}

void extend_node(Json& document, Json& node, std::mt19937& random) {
  if (random() % 3 == 0) return copy_node(document, node, random);
  const bool hides = random() % 2 == 0;
  const char* extension = hides ? "KHR_node_visibility" : "MSFT_lod";
  Json& extended = object_in(object_in(node, "extensions"), extension);
  if (hides)
    extended["visible"] = random() % 2 == 0;
  else
    extended["ids"] = Json::array({any_index(document, "nodes", random)});
  use(document, extension);
}

/// Adds an animation channel; its accessors often have the wrong contents.
void move_node(Json& document, std::mt19937& random) {
  constexpr std::array paths{"translation", "rotation", "scale", "weights", "pointer"};
  constexpr std::array ways{"LINEAR", "STEP", "CUBICSPLINE"};
  if (size_of(document, "animations") == 0)
    document["animations"] =
        Json::array({{{"channels", Json::array()}, {"samplers", Json::array()}}});
  Json* animation = any_object(document, "animations", random);
  if (!animation) return;
  const std::size_t node = any_index(document, "nodes", random);
  const std::string path = paths[random() % paths.size()];
  Json target{{"node", node}, {"path", path}};
  if (path == "pointer") {
    constexpr std::array ends{"/translation", "/rotation", "/scale", "/weights", "/weights/0", ""};
    target.erase("node");
    target["extensions"]["KHR_animation_pointer"]["pointer"] =
        "/nodes/" + std::to_string(node) + ends[random() % ends.size()];
    use(document, "KHR_animation_pointer");
  }
  Json sampler{{"input", any_index(document, "accessors", random)},
               {"output", any_index(document, "accessors", random)},
               {"interpolation", ways[random() % ways.size()]}};
  if (const Json* usual = any_object(*animation, "samplers", random); usual && random() % 2 == 0)
    sampler["input"] = usual->value("input", Json(0));
  for (const char* list : {"channels", "samplers"})
    if (!(*animation)[list].is_array()) (*animation)[list] = Json::array();
  (*animation)["channels"].push_back(
      {{"sampler", size_of(*animation, "samplers")}, {"target", std::move(target)}});
  (*animation)["samplers"].push_back(std::move(sampler));
}

}  // namespace

void add_feature(Json& document, std::mt19937& random) {
  // Must come first: adding a member invalidates pointers to the others.
  object_in(document, "extensions");
  Json& used = document["extensionsUsed"];
  if (!used.is_array()) used = Json::array();

  const auto choice = random() % 14;
  if (choice >= 13) {
    surround(document, random);
  } else if (choice >= 12) {
    if (Json* material = any_object(document, "materials", random))
      change_material(document, *material, random);
  } else if (choice < 7) {
    if (Json* material = any_object(document, "materials", random))
      extend_material(document, *material, random);
  } else if (choice < 9) {
    if (Json* mesh = any_object(document, "meshes", random))
      extend_primitive(document, *mesh, random);
  } else if (choice < 10) {
    if (Json* node = any_object(document, "nodes", random)) extend_node(document, *node, random);
  } else if (choice < 11) {
    move_node(document, random);
  } else if (size_of(document, "scenes") > 0) {
    document["scenes"].push_back({{"nodes", Json::array({any_index(document, "nodes", random)})}});
    document["scene"] = any_index(document, "scenes", random);
  }
}

}  // namespace asos::fuzz
