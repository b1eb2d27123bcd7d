#include "renderer/gltf/materials.h"

#include "renderer/gltf/material_dfr.h"
#include "renderer/gltf/material_values.h"
#include "renderer/gltf/values.h"

#include <fmt/format.h>

#include <array>

namespace asos::gltf {

namespace {

class MaterialReader : MaterialValues {
 public:
  MaterialReader(const tinygltf::Material& source, std::string place, Textures& textures,
                 Warnings& warnings, bool moves)
      : MaterialValues(std::move(place), textures, warnings), source_(source), moves_(moves) {}

  Material read() {
    Material m;
    m.name = source_.name;
    read_surface(m);
    read_emission(m);
    read_alpha(m);
    read_extensions(m);
    // KHR_materials_pbrSpecularGlossiness replaces the whole reflection; unlit materials have none.
    const auto* glossy = extension(source_.extensions, "KHR_materials_pbrSpecularGlossiness");
    if (m.unlit) {
      glossy = nullptr;
      m.transmission = 0.0f;
      tell_ignored();
    }
    if (glossy) {
      read_specular_glossiness(*glossy, m);
    } else {
      read_specular(m);
    }
    if (auto dfr = read_dfr(source_.extras)) {
      m.dfr = *dfr;
    } else {
      warnings_.add(fmt::format("{}: its asos_dfr is left out: {}", place_, dfr.error()));
    }
    read_coat(m);
    read_sheen(m);
    read_film(m);
    read_anisotropy(m);
    read_volume(m);
    read_diffuse_transmission(m);
    // Textures last: an unlit material needs only its base colour texture.
    const tinygltf::PbrMetallicRoughness& pbr = source_.pbrMetallicRoughness;
    m.base_color_texture = glossy ? use_in(*glossy, "diffuseTexture", "diffuse")
                                  : use(pbr.baseColorTexture, "base colour");
    if (m.unlit) return m;
    if (const auto* e = extension(source_.extensions, "KHR_materials_transmission"))
      m.transmission_texture = use_in(*e, "transmissionTexture", "transmission");
    if (!glossy)
      m.metallic_roughness_texture = use(pbr.metallicRoughnessTexture, "metallic-roughness");
    m.normal_texture = use(source_.normalTexture, "normal");
    m.normal_texture.scale = finite(source_.normalTexture.scale, 1.0, "normal scale");
    m.occlusion_texture = use(source_.occlusionTexture, "occlusion");
    m.occlusion_texture.scale =
        within(source_.occlusionTexture.strength, 0.0, 1.0, 1.0, "occlusion strength");
    m.emissive_texture = use(source_.emissiveTexture, "emissive");
    use_coat(m);
    use_sheen(m);
    use_film(m);
    use_anisotropy(m);
    use_volume(m);
    use_diffuse_transmission(m);
    if (glossy) {
      use_specular_glossiness(*glossy, m);
    } else if (const auto* e = extension(source_.extensions, "KHR_materials_specular")) {
      m.specular_texture = use_in(*e, "specularTexture", "specular");
      m.specular_color_texture = use_in(*e, "specularColorTexture", "specular colour");
    }
    return m;
  }

 private:
  /// Reports an unlit material's shading extensions, which KHR_materials_unlit overrides.
  void tell_ignored() {
    constexpr std::array<const char*, 9> shading = {"KHR_materials_transmission",
                                                    "KHR_materials_diffuse_transmission",
                                                    "KHR_materials_volume",
                                                    "KHR_materials_clearcoat",
                                                    "KHR_materials_sheen",
                                                    "KHR_materials_iridescence",
                                                    "KHR_materials_anisotropy",
                                                    "KHR_materials_specular",
                                                    "KHR_materials_pbrSpecularGlossiness"};
    std::string ignored;
    for (const char* name : shading)
      if (source_.extensions.contains(name))
        ignored += (ignored.empty() ? "" : ", ") + std::string(name);
    if (!ignored.empty())
      warnings_.add(fmt::format("{}: it is unlit, so it shows its base colour alone; ignored: {}",
                                place_, ignored));
  }

  /// Returns whether to read a property whose factor makes it visible now. For moving materials,
  /// returns true.
  [[nodiscard]] bool shows(bool now) const { return now || moves_; }

  void read_surface(Material& m) {
    const tinygltf::PbrMetallicRoughness& pbr = source_.pbrMetallicRoughness;
    if (pbr.baseColorFactor.size() == 4) {
      for (int c = 0; c < 4; ++c) {
        m.base_color[c] = within(pbr.baseColorFactor[static_cast<std::size_t>(c)], 0.0, 1.0, 1.0,
                                 "base colour factor");
      }
    } else {
      warnings_.add(place_ + ": its base colour factor is not four numbers; white is used");
    }
    m.metallic = within(pbr.metallicFactor, 0.0, 1.0, 1.0, "metallic factor");
    m.roughness = within(pbr.roughnessFactor, 0.0, 1.0, 1.0, "roughness factor");
    m.double_sided = source_.doubleSided;
  }

  void read_emission(Material& m) {
    if (source_.emissiveFactor.empty()) return;
    if (source_.emissiveFactor.size() != 3) {
      warnings_.add(place_ + ": its emissive factor is not three numbers; ignored");
      return;
    }
    for (int c = 0; c < 3; ++c) {
      const double value = source_.emissiveFactor[static_cast<std::size_t>(c)];
      // Exporters write more than 1 for bright lamps, so the value is kept.
      if (value > 1.0) warnings_.add(place_ + ": its emissive factor is above 1; used as it is");
      m.emissive[c] = within(value, 0.0, 1e30, 0.0, "emissive factor");
    }
  }

  void read_alpha(Material& m) {
    if (source_.alphaMode == "MASK") {
      m.alpha_mode = AlphaMode::mask;
    } else if (source_.alphaMode == "BLEND") {
      m.alpha_mode = AlphaMode::blend;
    } else if (source_.alphaMode != "OPAQUE") {
      warnings_.add(fmt::format("{}: its alpha mode '{}' is unknown; drawn opaque", place_,
                                source_.alphaMode));
    }
    m.alpha_cutoff = within(source_.alphaCutoff, 0.0, 1e30, 0.5, "alpha cut-off");
  }

  void read_extensions(Material& m) {
    m.unlit = source_.extensions.contains("KHR_materials_unlit");
    if (const auto* e = extension(source_.extensions, "KHR_materials_emissive_strength")) {
      m.emissive_strength =
          within(number(*e, "emissiveStrength").value_or(1.0), 0.0, 1e30, 1.0, "emissive strength");
    }
    if (const auto* e = extension(source_.extensions, "KHR_materials_ior")) {
      const double ior = number(*e, "ior").value_or(1.5);
      // 0 means an infinite index: everything is reflected.
      m.ior = ior == 0.0 ? 0.0f : within(ior, 1.0, 1e6, 1.5, "index of refraction");
    }
    if (const auto* e = extension(source_.extensions, "KHR_materials_transmission")) {
      m.transmission = within(number(*e, "transmissionFactor").value_or(0.0), 0.0, 1.0, 0.0,
                              "transmission factor");
    }
  }

  void read_specular(Material& m) {
    const auto* e = extension(source_.extensions, "KHR_materials_specular");
    if (!e) return;
    m.specular =
        within(number(*e, "specularFactor").value_or(1.0), 0.0, 1.0, 1.0, "specular factor");
    for (int c = 0; c < 3; ++c) {
      m.specular_color[c] = within(number_at(*e, "specularColorFactor", c).value_or(1.0), 0.0, 1e30,
                                   1.0, "specular colour factor");
    }
  }

  void read_coat(Material& m) {
    const auto* e = extension(source_.extensions, "KHR_materials_clearcoat");
    if (!e) return;
    m.coat.factor =
        within(number(*e, "clearcoatFactor").value_or(0.0), 0.0, 1.0, 0.0, "clearcoat factor");
    m.coat.roughness = within(number(*e, "clearcoatRoughnessFactor").value_or(0.0), 0.0, 1.0, 0.0,
                              "clearcoat roughness factor");
  }

  void read_sheen(Material& m) {
    const auto* e = extension(source_.extensions, "KHR_materials_sheen");
    if (!e) return;
    for (int c = 0; c < 3; ++c) {
      m.sheen.color[c] = within(number_at(*e, "sheenColorFactor", c).value_or(0.0), 0.0, 1.0, 0.0,
                                "sheen colour factor");
    }
    m.sheen.roughness = within(number(*e, "sheenRoughnessFactor").value_or(0.0), 0.0, 1.0, 0.0,
                               "sheen roughness factor");
  }

  void use_sheen(Material& m) {
    const auto* e = extension(source_.extensions, "KHR_materials_sheen");
    if (!e || !shows(m.sheen.used())) return;
    m.sheen.color_texture = use_in(*e, "sheenColorTexture", "sheen colour");
    m.sheen.roughness_texture = use_in(*e, "sheenRoughnessTexture", "sheen roughness");
  }

  void read_film(Material& m) {
    const auto* e = extension(source_.extensions, "KHR_materials_iridescence");
    if (!e) return;
    const auto read = [&](const char* name, double low, double high, float otherwise,
                          const char* what) {
      const auto usual = static_cast<double>(otherwise);
      return within(number(*e, name).value_or(usual), low, high, usual, what);
    };
    Iridescence& film = m.film;
    film.factor = read("iridescenceFactor", 0.0, 1.0, film.factor, "iridescence factor");
    film.ior = read("iridescenceIor", 1.0, 1e3, film.ior, "iridescence index");
    film.thickness_min_nm = read("iridescenceThicknessMinimum", 0.0, 1e6, film.thickness_min_nm,
                                 "least iridescence thickness");
    film.thickness_max_nm = read("iridescenceThicknessMaximum", 0.0, 1e6, film.thickness_max_nm,
                                 "largest iridescence thickness");
  }

  void use_film(Material& m) {
    const auto* e = extension(source_.extensions, "KHR_materials_iridescence");
    if (!e || !shows(m.film.used())) return;
    m.film.texture = use_in(*e, "iridescenceTexture", "iridescence");
    m.film.thickness_texture = use_in(*e, "iridescenceThicknessTexture", "iridescence thickness");
  }

  void read_anisotropy(Material& m) {
    const auto* e = extension(source_.extensions, "KHR_materials_anisotropy");
    if (!e) return;
    m.anisotropy.strength = within(number(*e, "anisotropyStrength").value_or(0.0), 0.0, 1.0, 0.0,
                                   "anisotropy strength");
    m.anisotropy.rotation_rad =
        finite(number(*e, "anisotropyRotation").value_or(0.0), 0.0, "anisotropy rotation");
  }

  void use_anisotropy(Material& m) {
    const auto* e = extension(source_.extensions, "KHR_materials_anisotropy");
    if (!e || !shows(m.anisotropy.used())) return;
    m.anisotropy.texture = use_in(*e, "anisotropyTexture", "anisotropy");
  }

  void read_volume(Material& m) {
    if (const auto* e = extension(source_.extensions, "KHR_materials_volume")) {
      Volume& volume = m.volume;
      volume.thickness =
          within(number(*e, "thicknessFactor").value_or(0.0), 0.0, 1e30, 0.0, "thickness factor");
      read_attenuation_distance(*e, volume);
      for (int c = 0; c < 3; ++c) {
        volume.attenuation_color[c] = within(number_at(*e, "attenuationColor", c).value_or(1.0),
                                             0.0, 1.0, 1.0, "attenuation colour");
      }
    }
    if (const auto* e = extension(source_.extensions, "KHR_materials_dispersion")) {
      m.volume.dispersion =
          within(number(*e, "dispersion").value_or(0.0), 0.0, 1e6, 0.0, "dispersion");
    }
  }

  void read_diffuse_transmission(Material& m) {
    const auto* e = extension(source_.extensions, "KHR_materials_diffuse_transmission");
    if (!e) return;
    DiffuseTransmission& through = m.diffuse_transmission;
    through.factor = within(number(*e, "diffuseTransmissionFactor").value_or(0.0), 0.0, 1.0, 0.0,
                            "diffuse transmission factor");
    for (int c = 0; c < 3; ++c) {
      through.color[c] = within(number_at(*e, "diffuseTransmissionColorFactor", c).value_or(1.0),
                                0.0, 1.0, 1.0, "diffuse transmission colour");
    }
  }

  void use_diffuse_transmission(Material& m) {
    const auto* e = extension(source_.extensions, "KHR_materials_diffuse_transmission");
    DiffuseTransmission& through = m.diffuse_transmission;
    if (!e || !shows(through.used())) return;
    through.texture = use_in(*e, "diffuseTransmissionTexture", "diffuse transmission");
    through.color_texture =
        use_in(*e, "diffuseTransmissionColorTexture", "diffuse transmission colour");
  }

  void read_attenuation_distance(const tinygltf::Value& e, Volume& volume) {
    const auto distance = number(e, "attenuationDistance");
    if (!distance) return;
    const auto single = static_cast<float>(*distance);
    if (single > 0.0f) {
      volume.attenuation_distance = single;
    } else {
      warnings_.add(place_ + ": its attenuation distance is not above 0; ignored");
    }
  }

  void use_volume(Material& m) {
    const auto* e = extension(source_.extensions, "KHR_materials_volume");
    if (!e || !shows(m.volume.thickness > 0.0f)) return;
    m.volume.thickness_texture = use_in(*e, "thicknessTexture", "thickness");
  }

  void use_coat(Material& m) {
    const auto* e = extension(source_.extensions, "KHR_materials_clearcoat");
    if (!e || !shows(m.coat.factor > 0.0f)) return;
    m.coat.texture = use_in(*e, "clearcoatTexture", "clearcoat");
    m.coat.roughness_texture = use_in(*e, "clearcoatRoughnessTexture", "clearcoat roughness");
    m.coat.normal_texture = use_in(*e, "clearcoatNormalTexture", "clearcoat normal");
    if (!m.coat.normal_texture.used()) return;
    const double scale = number(e->Get("clearcoatNormalTexture"), "scale").value_or(1.0);
    m.coat.normal_texture.scale = finite(scale, 1.0, "clearcoat normal scale");
  }

  /// Reads a dielectric of infinite index, which reflects its specular colour at normal incidence.
  /// The diffuse part is weighted by one minus that colour's largest channel, as the extension
  /// requires.
  void read_specular_glossiness(const tinygltf::Value& e, Material& m) {
    for (int c = 0; c < 4; ++c) {
      m.base_color[c] =
          within(number_at(e, "diffuseFactor", c).value_or(1.0), 0.0, 1.0, 1.0, "diffuse factor");
    }
    for (int c = 0; c < 3; ++c) {
      m.specular_color[c] =
          within(number_at(e, "specularFactor", c).value_or(1.0), 0.0, 1.0, 1.0, "specular factor");
    }
    m.metallic = 0.0f;
    m.roughness = 1.0f - glossiness(e);
    m.ior = 0.0f;
  }

  float glossiness(const tinygltf::Value& e) {
    return within(number(e, "glossinessFactor").value_or(1.0), 0.0, 1.0, 1.0, "glossiness factor");
  }

  /// Uses a texture with the specular colour. Its alpha is glossiness, which becomes a texture of
  /// roughness.
  void use_specular_glossiness(const tinygltf::Value& e, Material& m) {
    m.specular_color_texture = use_in(e, "specularGlossinessTexture", "specular-glossiness");
    if (!m.specular_color_texture.used()) return;
    const int rough = textures_.roughness_of(m.specular_color_texture.texture, glossiness(e));
    if (rough < 0) return;
    m.metallic_roughness_texture = m.specular_color_texture;
    m.metallic_roughness_texture.texture = rough;
    m.roughness = 1.0f;
  }

  const tinygltf::Material& source_;
  bool moves_;
};

std::vector<Material> read_materials(const tinygltf::Model& model, Textures& textures,
                                     const std::set<std::size_t>& moving, Warnings& warnings) {
  std::vector<Material> materials;
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    const tinygltf::Material& source = model.materials[i];
    const std::string place = source.name.empty() ? fmt::format("material {}", i)
                                                  : fmt::format("material '{}'", source.name);
    MaterialReader reader(source, place, textures, warnings, moving.contains(i));
    materials.push_back(reader.read());
  }
  return materials;
}

}  // namespace

std::vector<Material> import_materials(Document& document, Textures& textures,
                                       const std::set<std::size_t>& moving) {
  textures.decode_ahead([&] {
    Warnings come_later;
    (void)read_materials(document.model, textures, moving, come_later);
  });
  return read_materials(document.model, textures, moving, document.warnings);
}

}  // namespace asos::gltf
