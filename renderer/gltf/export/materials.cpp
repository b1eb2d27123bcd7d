#include "renderer/gltf/export/gltf_writer.h"

#include <algorithm>
#include <cmath>

namespace asos::exporting {

using nlohmann::json;

namespace {

json numbers(const glm::vec3& v) {
  return json::array({v.x, v.y, v.z});
}

json texture_info(const TextureUse& use, GltfDocument& document) {
  json info{{"index", use.texture}};
  if (use.texcoord != 0) info["texCoord"] = use.texcoord;
  if (use.uv_transform == glm::mat3(1.0f)) return info;
  const TextureTransform t = decompose(use.uv_transform).value();
  document.use_extension("KHR_texture_transform");
  info["extensions"]["KHR_texture_transform"] = {{"offset", {t.offset.x, t.offset.y}},
                                                 {"rotation", t.rotation_rad},
                                                 {"scale", {t.scale.x, t.scale.y}}};
  return info;
}

void write_emission(const Material& material, json& out, GltfDocument& document) {
  // glTF's factor is at most 1; the excess is moved into the strength.
  const float brightest =
      std::max({material.emissive.x, material.emissive.y, material.emissive.z, 1.0f});
  const glm::vec3 factor = material.emissive / brightest;
  const float strength = material.emissive_strength * brightest;
  if (factor != glm::vec3(0.0f)) out["emissiveFactor"] = numbers(factor);
  if (strength != 1.0f) {
    document.use_extension("KHR_materials_emissive_strength");
    out["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = strength;
  }
}

/// Returns three numbers, or one if they are equal.
json by_colour(const Dfr& dfr, double DfrCurve::*value) {
  const double r = dfr.rgb[0].*value, g = dfr.rgb[1].*value, b = dfr.rgb[2].*value;
  return r == g && g == b ? json(r) : json{r, g, b};
}

void write_reflection(const Material& material, json& out, GltfDocument& document) {
  if (material.ior != 1.5f) {
    document.use_extension("KHR_materials_ior");
    out["extensions"]["KHR_materials_ior"]["ior"] = material.ior;
  }
  if (material.specular != 1.0f || material.specular_color != glm::vec3(1.0f) ||
      material.specular_texture.used() || material.specular_color_texture.used()) {
    document.use_extension("KHR_materials_specular");
    json& specular = out["extensions"]["KHR_materials_specular"];
    specular = {{"specularFactor", material.specular},
                {"specularColorFactor", numbers(material.specular_color)}};
    if (material.specular_texture.used())
      specular["specularTexture"] = texture_info(material.specular_texture, document);
    if (material.specular_color_texture.used())
      specular["specularColorTexture"] = texture_info(material.specular_color_texture, document);
  }
  if (material.dfr) out["extras"]["asos_dfr"] = dfr_json(*material.dfr);
}

json normal_texture_info(const TextureUse& use, GltfDocument& document) {
  json info = texture_info(use, document);
  info["scale"] = use.scale;
  return info;
}

void write_coat(const Clearcoat& coat, json& out, GltfDocument& document) {
  if (coat.factor == 0.0f) return;
  document.use_extension("KHR_materials_clearcoat");
  json& clearcoat = out["extensions"]["KHR_materials_clearcoat"];
  clearcoat = {{"clearcoatFactor", coat.factor}, {"clearcoatRoughnessFactor", coat.roughness}};
  if (coat.texture.used()) clearcoat["clearcoatTexture"] = texture_info(coat.texture, document);
  if (coat.roughness_texture.used())
    clearcoat["clearcoatRoughnessTexture"] = texture_info(coat.roughness_texture, document);
  if (coat.normal_texture.used())
    clearcoat["clearcoatNormalTexture"] = normal_texture_info(coat.normal_texture, document);
}

void write_sheen(const Sheen& sheen, json& out, GltfDocument& document) {
  if (!sheen.used()) return;
  document.use_extension("KHR_materials_sheen");
  json& written = out["extensions"]["KHR_materials_sheen"];
  written = {{"sheenColorFactor", numbers(sheen.color)}, {"sheenRoughnessFactor", sheen.roughness}};
  if (sheen.color_texture.used())
    written["sheenColorTexture"] = texture_info(sheen.color_texture, document);
  if (sheen.roughness_texture.used())
    written["sheenRoughnessTexture"] = texture_info(sheen.roughness_texture, document);
}

void write_film(const Iridescence& film, json& out, GltfDocument& document) {
  if (!film.used()) return;
  document.use_extension("KHR_materials_iridescence");
  json& written = out["extensions"]["KHR_materials_iridescence"];
  written = {{"iridescenceFactor", film.factor},
             {"iridescenceIor", film.ior},
             {"iridescenceThicknessMinimum", film.thickness_min_nm},
             {"iridescenceThicknessMaximum", film.thickness_max_nm}};
  if (film.texture.used()) written["iridescenceTexture"] = texture_info(film.texture, document);
  if (film.thickness_texture.used())
    written["iridescenceThicknessTexture"] = texture_info(film.thickness_texture, document);
}

void write_anisotropy(const Anisotropy& anisotropy, json& out, GltfDocument& document) {
  if (!anisotropy.used()) return;
  document.use_extension("KHR_materials_anisotropy");
  json& written = out["extensions"]["KHR_materials_anisotropy"];
  written = {{"anisotropyStrength", anisotropy.strength},
             {"anisotropyRotation", anisotropy.rotation_rad}};
  if (anisotropy.texture.used())
    written["anisotropyTexture"] = texture_info(anisotropy.texture, document);
}

void write_volume(const Volume& volume, json& out, GltfDocument& document) {
  if (volume.thickness > 0.0f) {
    document.use_extension("KHR_materials_volume");
    json& written = out["extensions"]["KHR_materials_volume"];
    written = {{"thicknessFactor", volume.thickness},
               {"attenuationColor", numbers(volume.attenuation_color)}};
    // An infinite distance is the default, and JSON has no number for it.
    if (std::isfinite(volume.attenuation_distance))
      written["attenuationDistance"] = volume.attenuation_distance;
    if (volume.thickness_texture.used())
      written["thicknessTexture"] = texture_info(volume.thickness_texture, document);
  }
  if (volume.dispersion > 0.0f) {
    document.use_extension("KHR_materials_dispersion");
    out["extensions"]["KHR_materials_dispersion"]["dispersion"] = volume.dispersion;
  }
}

void write_diffuse_transmission(const DiffuseTransmission& through, json& out,
                                GltfDocument& document) {
  if (!through.used()) return;
  document.use_extension("KHR_materials_diffuse_transmission");
  json& written = out["extensions"]["KHR_materials_diffuse_transmission"];
  written = {{"diffuseTransmissionFactor", through.factor},
             {"diffuseTransmissionColorFactor", numbers(through.color)}};
  if (through.texture.used())
    written["diffuseTransmissionTexture"] = texture_info(through.texture, document);
  if (through.color_texture.used())
    written["diffuseTransmissionColorTexture"] = texture_info(through.color_texture, document);
}

json material_json(const Material& material, GltfDocument& document) {
  json out{{"name", material.name}};
  json& pbr = out["pbrMetallicRoughness"];
  const glm::vec4& c = material.base_color;
  pbr = {{"baseColorFactor", {c.r, c.g, c.b, c.a}},
         {"metallicFactor", material.metallic},
         {"roughnessFactor", material.roughness}};
  if (material.base_color_texture.used()) {
    pbr["baseColorTexture"] = texture_info(material.base_color_texture, document);
  }
  if (material.metallic_roughness_texture.used()) {
    pbr["metallicRoughnessTexture"] = texture_info(material.metallic_roughness_texture, document);
  }
  if (material.normal_texture.used()) {
    out["normalTexture"] = normal_texture_info(material.normal_texture, document);
  }
  if (material.occlusion_texture.used()) {
    out["occlusionTexture"] = texture_info(material.occlusion_texture, document);
    out["occlusionTexture"]["strength"] = material.occlusion_texture.scale;
  }
  if (material.emissive_texture.used()) {
    out["emissiveTexture"] = texture_info(material.emissive_texture, document);
  }
  write_emission(material, out, document);

  if (material.alpha_mode == AlphaMode::mask) {
    out["alphaMode"] = "MASK";
    out["alphaCutoff"] = material.alpha_cutoff;
  } else if (material.alpha_mode == AlphaMode::blend) {
    out["alphaMode"] = "BLEND";
  }
  if (material.double_sided) out["doubleSided"] = true;
  if (material.unlit) {
    document.use_extension("KHR_materials_unlit");
    out["extensions"]["KHR_materials_unlit"] = json::object();
  }
  write_reflection(material, out, document);
  write_coat(material.coat, out, document);
  write_sheen(material.sheen, out, document);
  write_film(material.film, out, document);
  write_anisotropy(material.anisotropy, out, document);
  write_volume(material.volume, out, document);
  write_diffuse_transmission(material.diffuse_transmission, out, document);
  if (material.transmission != 0.0f) {
    document.use_extension("KHR_materials_transmission");
    json& transmission = out["extensions"]["KHR_materials_transmission"];
    transmission["transmissionFactor"] = material.transmission;
    if (material.transmission_texture.used())
      transmission["transmissionTexture"] = texture_info(material.transmission_texture, document);
  }
  return out;
}

}  // namespace

json dfr_json(const Dfr& dfr) {
  return {{"min", by_colour(dfr, &DfrCurve::min)},
          {"max", by_colour(dfr, &DfrCurve::max)},
          {"exponent", by_colour(dfr, &DfrCurve::exponent)},
          {"perturbation", dfr.perturbation}};
}

std::optional<TextureTransform> decompose(const glm::mat3& uv_transform) {
  const glm::dmat3 m(uv_transform);
  if (m[0].z != 0.0 || m[1].z != 0.0 || m[2].z != 1.0) return std::nullopt;
  const glm::dvec2 x(m[0]), y(m[1]);
  const double sx = glm::length(x), sy = glm::length(y);
  // The columns are sx (cos, -sin) and sy (sin, cos): perpendicular up to a float's rounding.
  if (std::abs(glm::dot(x, y)) > 1e-5 * sx * sy) return std::nullopt;
  TextureTransform t;
  t.offset = glm::dvec2(m[2]);
  const bool mirrored = x.x * y.y - x.y * y.x < 0.0;
  t.scale = {sx, mirrored ? -sy : sy};
  if (sx > 0.0) {
    t.rotation_rad = std::atan2(-x.y, x.x);
  } else if (sy > 0.0) {
    t.rotation_rad = std::atan2(y.x, y.y);
  }
  return t;
}

void write_materials(const Scene& scene, GltfDocument& document) {
  for (const Material& material : scene.materials) {
    document.add("materials", material_json(material, document));
  }
}

}  // namespace asos::exporting
