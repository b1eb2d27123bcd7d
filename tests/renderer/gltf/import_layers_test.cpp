#include "renderer/gltf/load.h"
#include "tests/renderer/gltf/gltf_builder.h"

#include <gtest/gtest.h>

#include <limits>

// KHR_materials_clearcoat and KHR_materials_sheen in files: gltf/MATERIALS.md.

namespace asos {
namespace {

using nlohmann::json;
using test::GltfBuilder;

Scene import_with(const std::string& name, json extension, bool unlit = false) {
  GltfBuilder b = GltfBuilder::square();
  const int uv = b.vec2({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  json& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["attributes"]["TEXCOORD_0"] = uv;
  primitive["material"] = 0;
  b.json["extensionsUsed"] = b.json["extensionsRequired"] = {name};
  b.json["images"] = {{{"uri", test::small_png}}};
  b.json["textures"] = {{{"source", 0}}};
  b.json["materials"] = {{{"name", "car"}, {"extensions", {{name, std::move(extension)}}}}};
  if (unlit) {
    b.json["extensionsUsed"].push_back("KHR_materials_unlit");
    b.json["materials"][0]["extensions"]["KHR_materials_unlit"] = json::object();
  }
  const test::TemporaryFolder folder;
  const Result<Scene> scene = import_gltf(folder.write("test.glb", b.glb()));
  EXPECT_TRUE(scene) << scene.error().message();
  return scene ? *scene : Scene{};
}

Scene coated(json extension) {
  return import_with("KHR_materials_clearcoat", std::move(extension));
}
Scene sheeny(json extension) {
  return import_with("KHR_materials_sheen", std::move(extension));
}

TEST(ImportLayers, ClearcoatsAreRead) {
  const Scene scene = coated({{"clearcoatFactor", 0.75},
                              {"clearcoatTexture", {{"index", 0}}},
                              {"clearcoatRoughnessFactor", 0.25},
                              {"clearcoatRoughnessTexture", {{"index", 0}}},
                              {"clearcoatNormalTexture", {{"index", 0}, {"scale", 0.5}}}});
  const Clearcoat& coat = scene.materials.at(0).coat;
  EXPECT_EQ(coat.factor, 0.75f);
  EXPECT_EQ(coat.roughness, 0.25f);
  EXPECT_TRUE(coat.texture.used());
  EXPECT_TRUE(coat.roughness_texture.used());
  EXPECT_TRUE(coat.normal_texture.used());
  EXPECT_EQ(coat.normal_texture.scale, 0.5f);
  EXPECT_TRUE(scene.notes.unsupported_extensions.empty());
  EXPECT_TRUE(scene.notes.warnings.empty());
  EXPECT_EQ(scene.meshes.at(0).tangents.size(), 4u) << "made for the coat's own normal map";
}

TEST(ImportLayers, SheensAreRead) {
  const Scene scene = sheeny({{"sheenColorFactor", {0.5, 0.25, 1}},
                              {"sheenColorTexture", {{"index", 0}}},
                              {"sheenRoughnessFactor", 0.75},
                              {"sheenRoughnessTexture", {{"index", 0}}}});
  const Sheen& sheen = scene.materials.at(0).sheen;
  EXPECT_EQ(sheen.color, glm::vec3(0.5f, 0.25f, 1.0f));
  EXPECT_EQ(sheen.roughness, 0.75f);
  EXPECT_TRUE(sheen.color_texture.used());
  EXPECT_TRUE(sheen.roughness_texture.used());
  EXPECT_TRUE(scene.notes.unsupported_extensions.empty());
  EXPECT_TRUE(scene.notes.warnings.empty());
}

TEST(ImportLayers, FilmsAreRead) {
  const auto film = [](json extension) {
    const Scene scene = import_with("KHR_materials_iridescence", std::move(extension));
    EXPECT_TRUE(scene.notes.warnings.empty());
    return scene.materials.at(0).film;
  };
  const Iridescence all = film({{"iridescenceFactor", 0.5},
                                {"iridescenceTexture", {{"index", 0}}},
                                {"iridescenceIor", 1.5},
                                {"iridescenceThicknessMinimum", 200},
                                {"iridescenceThicknessMaximum", 800},
                                {"iridescenceThicknessTexture", {{"index", 0}}}});
  EXPECT_EQ(all.factor, 0.5f);
  EXPECT_EQ(all.ior, 1.5f);
  EXPECT_EQ(all.thickness_min_nm, 200.0f);
  EXPECT_EQ(all.thickness_max_nm, 800.0f);
  EXPECT_TRUE(all.texture.used());
  EXPECT_TRUE(all.thickness_texture.used());
  const Iridescence usual = film({{"iridescenceFactor", 1}});
  EXPECT_EQ(usual.ior, 1.3f);
  EXPECT_EQ(usual.thickness_min_nm, 100.0f);
  EXPECT_EQ(usual.thickness_max_nm, 400.0f);
  EXPECT_FALSE(film(json::object()).used());
}

TEST(ImportLayers, AnisotropyIsRead) {
  const Scene scene =
      import_with("KHR_materials_anisotropy", {{"anisotropyStrength", 0.75},
                                               {"anisotropyRotation", -0.5},
                                               {"anisotropyTexture", {{"index", 0}}}});
  const Anisotropy& all = scene.materials.at(0).anisotropy;
  EXPECT_EQ(all.strength, 0.75f);
  EXPECT_EQ(all.rotation_rad, -0.5f);
  EXPECT_TRUE(all.texture.used());
  EXPECT_TRUE(scene.notes.unsupported_extensions.empty());
  EXPECT_TRUE(scene.notes.warnings.empty());
  EXPECT_EQ(scene.meshes.at(0).tangents.size(), 4u) << "made for the lobe's direction";
  const Scene none = import_with("KHR_materials_anisotropy", {{"anisotropyRotation", 1}});
  EXPECT_FALSE(none.materials.at(0).anisotropy.used());
  EXPECT_TRUE(none.meshes.at(0).tangents.empty());
  const Scene broken = import_with(
      "KHR_materials_anisotropy",
      {{"anisotropyStrength", -2}, {"anisotropyRotation", 1e300}, {"anisotropyTexture", "x"}});
  EXPECT_FALSE(broken.materials.at(0).anisotropy.used());
  EXPECT_EQ(broken.materials.at(0).anisotropy.rotation_rad, 0.0f);
  EXPECT_EQ(broken.notes.warnings.size(), 3u);
}

TEST(ImportLayers, VolumesAreRead) {
  const auto volume = [](json extension) {
    return import_with("KHR_materials_volume", std::move(extension)).materials.at(0).volume;
  };
  const Volume all = volume({{"thicknessFactor", 0.5},
                             {"thicknessTexture", {{"index", 0}}},
                             {"attenuationDistance", 2.5},
                             {"attenuationColor", {0.5, 0.25, 1}}});
  EXPECT_EQ(all.thickness, 0.5f);
  EXPECT_TRUE(all.thickness_texture.used());
  EXPECT_EQ(all.attenuation_distance, 2.5f);
  EXPECT_EQ(all.attenuation_color, glm::vec3(0.5f, 0.25f, 1.0f));
  const Volume usual = volume({{"thicknessFactor", 1}});
  EXPECT_EQ(usual.attenuation_distance, std::numeric_limits<float>::infinity());
  EXPECT_EQ(usual.attenuation_color, glm::vec3(1.0f));
  EXPECT_EQ(volume(json::object()).thickness, 0.0f);
  const Scene scene = import_with("KHR_materials_dispersion", {{"dispersion", 0.36}});
  EXPECT_EQ(scene.materials.at(0).volume.dispersion, 0.36f);
}

TEST(ImportLayers, DiffuseTransmissionIsRead) {
  const auto through = [](json extension) {
    const Scene scene = import_with("KHR_materials_diffuse_transmission", std::move(extension));
    EXPECT_TRUE(scene.notes.warnings.empty());
    EXPECT_TRUE(scene.notes.unsupported_extensions.empty());
    return scene.materials.at(0).diffuse_transmission;
  };
  const DiffuseTransmission all = through({{"diffuseTransmissionFactor", 0.5},
                                           {"diffuseTransmissionTexture", {{"index", 0}}},
                                           {"diffuseTransmissionColorFactor", {0.5, 0.25, 1}},
                                           {"diffuseTransmissionColorTexture", {{"index", 0}}}});
  EXPECT_EQ(all.factor, 0.5f);
  EXPECT_EQ(all.color, glm::vec3(0.5f, 0.25f, 1.0f));
  EXPECT_TRUE(all.texture.used());
  EXPECT_TRUE(all.color_texture.used());
  EXPECT_FALSE(through(json::object()).used());
  EXPECT_EQ(through({{"diffuseTransmissionFactor", 1}}).color, glm::vec3(1.0f));
}

TEST(ImportLayers, VolumesOutOfRangeAreRemarkedOn) {
  for (const json& extension :
       {json{{"thicknessFactor", -1}}, json{{"thicknessFactor", 1}, {"attenuationDistance", 0}},
        json{{"thicknessFactor", 1}, {"attenuationDistance", -2}},
        json{{"thicknessFactor", 1}, {"attenuationColor", {1, 2, 1}}}}) {
    SCOPED_TRACE(extension.dump());
    const Scene scene = import_with("KHR_materials_volume", extension);
    EXPECT_EQ(scene.notes.warnings.size(), 1u);
    const Volume& volume = scene.materials.at(0).volume;
    EXPECT_GE(volume.thickness, 0.0f);
    EXPECT_GT(volume.attenuation_distance, 0.0f);
    EXPECT_LE(volume.attenuation_color.y, 1.0f);
  }
}

TEST(ImportLayers, ByDefaultThereAreNone) {
  // A factor of 0 and unlit materials need no textures.
  const Scene bare = coated({{"clearcoatTexture", {{"index", 0}}}});
  EXPECT_EQ(bare.materials.at(0).coat.factor, 0.0f);
  EXPECT_EQ(bare.materials.at(0).coat.roughness, 0.0f);
  EXPECT_FALSE(bare.materials.at(0).coat.texture.used());
  const Scene dull = sheeny({{"sheenRoughnessFactor", 1}, {"sheenColorTexture", {{"index", 0}}}});
  EXPECT_FALSE(dull.materials.at(0).sheen.used());
  EXPECT_FALSE(dull.materials.at(0).sheen.color_texture.used());
  const Scene unlit =
      import_with("KHR_materials_clearcoat",
                  {{"clearcoatFactor", 1}, {"clearcoatTexture", {{"index", 0}}}}, true);
  EXPECT_FALSE(unlit.materials.at(0).coat.texture.used());
}

TEST(ImportLayers, ValuesOutOfRangeAreBroughtIntoItByName) {
  const Scene coat = coated({{"clearcoatFactor", 1.5}, {"clearcoatRoughnessFactor", -1}});
  EXPECT_EQ(coat.materials.at(0).coat.factor, 1.0f);
  EXPECT_EQ(coat.materials.at(0).coat.roughness, 0.0f);
  ASSERT_EQ(coat.notes.warnings.size(), 2u);
  EXPECT_EQ(coat.notes.warnings[0],
            "material 'car': its clearcoat factor of 1.5 is out of range; 1 is used");
  const Scene sheen = sheeny({{"sheenColorFactor", {2, 0, 0.5}}, {"sheenRoughnessFactor", "y"}});
  EXPECT_EQ(sheen.materials.at(0).sheen.color, glm::vec3(1.0f, 0.0f, 0.5f));
  EXPECT_EQ(sheen.notes.warnings.size(), 2u);
  const Scene none = sheeny({{"sheenColorFactor", {2, "x", 0.5}}});
  EXPECT_EQ(none.materials.at(0).sheen.color, glm::vec3(0.0f));
  ASSERT_EQ(none.notes.warnings.size(), 1u);
  EXPECT_EQ(none.notes.warnings[0],
            "/materials/0/extensions/KHR_materials_sheen/sheenColorFactor is not three numbers; "
            "ignored");
}

}  // namespace
}  // namespace asos
