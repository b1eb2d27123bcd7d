#include "renderer/gltf/load.h"
#include "tests/renderer/gltf/gltf_builder.h"

#include <gtest/gtest.h>

// Reflection properties of materials in files: gltf/MATERIALS.md.

namespace asos {
namespace {

using nlohmann::json;
using test::GltfBuilder;

/// A file with one material, and the imported material.
struct Imported {
  Material material;
  std::vector<std::string> warnings;
  std::vector<std::string> unsupported;
};

Imported import_material(json material) {
  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsUsed"] = {"KHR_materials_ior", "KHR_materials_specular"};
  b.json["images"] = {{{"uri", test::small_png}}};
  b.json["textures"] = {{{"source", 0}}};
  material["name"] = "desk";
  b.json["materials"] = {std::move(material)};
  const test::TemporaryFolder folder;
  const Result<Scene> scene = import_gltf(folder.write("test.glb", b.glb()));
  EXPECT_TRUE(scene) << scene.error().message();
  if (!scene) return {};
  return {scene->materials.at(0), scene->notes.warnings, scene->notes.unsupported_extensions};
}

json with_specular(json specular) {
  return {{"extensions", {{"KHR_materials_specular", std::move(specular)}}}};
}

json with_dfr(json dfr) {
  return {{"extras", {{"asos_dfr", std::move(dfr)}, {"other", 3}}}};
}

TEST(ImportMaterials, SpecularFactorsAreRead) {
  const Imported all = import_material(
      with_specular({{"specularFactor", 0.25}, {"specularColorFactor", {1, 0.5, 4}}}));
  EXPECT_EQ(all.material.specular, 0.25f);
  EXPECT_EQ(all.material.specular_color, glm::vec3(1, 0.5f, 4));
  EXPECT_TRUE(all.warnings.empty());
  EXPECT_TRUE(all.unsupported.empty());
  const Imported none = import_material(with_specular(json::object()));
  EXPECT_EQ(none.material.specular, 1.0f);
  EXPECT_EQ(none.material.specular_color, glm::vec3(1.0f));
}

TEST(ImportMaterials, BadSpecularFactorsAreBroughtIntoRangeByName) {
  const Imported high = import_material(with_specular({{"specularFactor", 2}}));
  EXPECT_EQ(high.material.specular, 1.0f);
  ASSERT_EQ(high.warnings.size(), 1u);
  EXPECT_EQ(high.warnings[0],
            "material 'desk': its specular factor of 2 is out of range; 1 is used");
  const Imported negative =
      import_material(with_specular({{"specularColorFactor", {-1, 1, 1e300}}}));
  EXPECT_EQ(negative.material.specular_color, glm::vec3(0, 1, 1));
  EXPECT_EQ(negative.warnings.size(), 2u);
}

TEST(ImportMaterials, OcclusionIsReadWithItsStrength) {
  const Imported half = import_material({{"occlusionTexture", {{"index", 0}, {"strength", 0.5}}}});
  EXPECT_TRUE(half.material.occlusion_texture.used());
  EXPECT_EQ(half.material.occlusion_texture.scale, 0.5f);
  EXPECT_TRUE(half.warnings.empty());
  const Imported all = import_material({{"occlusionTexture", {{"index", 0}}}});
  EXPECT_EQ(all.material.occlusion_texture.scale, 1.0f);
  const Imported more = import_material({{"occlusionTexture", {{"index", 0}, {"strength", 3}}}});
  EXPECT_EQ(more.material.occlusion_texture.scale, 1.0f);
  EXPECT_EQ(more.warnings.size(), 1u);
}

TEST(ImportMaterials, TexturesOfExtensionsAreRead) {
  const Imported specular = import_material(with_specular(
      {{"specularTexture", {{"index", 0}}},
       {"specularColorTexture",
        {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"offset", {0.25, 0.5}}}}}}}}}));
  EXPECT_TRUE(specular.material.specular_texture.used());
  EXPECT_TRUE(specular.material.specular_color_texture.used());
  EXPECT_EQ(specular.material.specular_color_texture.uv_transform[2], glm::vec3(0.25f, 0.5f, 1.0f));
  EXPECT_FALSE(specular.material.transmission_texture.used());
  const Imported glass = import_material(
      {{"extensions",
        {{"KHR_materials_transmission",
          {{"transmissionFactor", 0.5}, {"transmissionTexture", {{"index", 0}}}}}}}});
  EXPECT_TRUE(glass.material.transmission_texture.used());
  EXPECT_EQ(glass.material.transmission, 0.5f);
  // A second set of coordinates that does not exist.
  const Imported third =
      import_material(with_specular({{"specularTexture", {{"index", 0}, {"texCoord", 2}}}}));
  EXPECT_FALSE(third.material.specular_texture.used());
  EXPECT_FALSE(third.warnings.empty());
}

TEST(ImportMaterials, AnIndexOfZeroIsInfinite) {
  const auto ior = [](double value) {
    return import_material({{"extensions", {{"KHR_materials_ior", {{"ior", value}}}}}});
  };
  EXPECT_EQ(ior(0).material.ior, 0.0f);
  EXPECT_TRUE(ior(0).warnings.empty());
  EXPECT_EQ(ior(0.5).material.ior, 1.0f);
  EXPECT_EQ(ior(0.5).warnings.size(), 1u);
}

TEST(ImportMaterials, DefocusingRatiosAreRead) {
  const Imported one = import_material(with_dfr({{"min", 0.05}, {"max", 1}, {"exponent", 32}}));
  const DfrCurve curve{0.05, 1.0, 32.0};
  EXPECT_EQ(one.material.dfr, (Dfr{{curve, curve, curve}, 0.0}));
  EXPECT_TRUE(one.warnings.empty());
  const Imported three = import_material(with_dfr({{"min", {0.25, 0, 1}},
                                                   {"max", {0.5, 1, 0}},
                                                   {"exponent", {0, 2.5, 1e4}},
                                                   {"perturbation", 0.5}}));
  EXPECT_EQ(three.material.dfr, (Dfr{{{{0.25, 0.5, 0.0}, {0.0, 1.0, 2.5}, {1.0, 0.0, 1e4}}}, 0.5}));
  EXPECT_EQ(import_material(with_dfr({{"perturbation", 0}})).material.dfr, Dfr{}) << "a mirror";
  EXPECT_FALSE(import_material(with_dfr(json::object())).material.dfr);
  EXPECT_FALSE(import_material({{"extras", {{"other", 1}}}}).material.dfr);
}

TEST(ImportMaterials, BadDefocusingRatiosAreLeftOutByName) {
  const auto left_out = [](json dfr, const std::string& words) {
    SCOPED_TRACE(dfr.dump());
    const Imported imported = import_material(with_dfr(std::move(dfr)));
    EXPECT_FALSE(imported.material.dfr);
    ASSERT_EQ(imported.warnings.size(), 1u);
    EXPECT_EQ(imported.warnings[0], "material 'desk': its asos_dfr is left out: " + words);
  };
  left_out(3, "it is not an object");
  left_out({{"min", 1.5}}, "min of 1.5 is not from 0 to 1");
  left_out({{"max", -0.25}}, "max of -0.25 is not from 0 to 1");
  left_out({{"min", {0.5, 2, 0.5}}}, "min of 2 is not from 0 to 1");
  left_out({{"min", {0.5, 0.5}}}, "min is neither a number nor three");
  left_out({{"min", "0.5"}}, "min is neither a number nor three");
  left_out({{"max", {0.5, nullptr, 0.5}}}, "max is neither a number nor three");
  left_out({{"exponent", -1}}, "exponent of -1 is below 0");
  left_out({{"perturbation", 1.25}}, "perturbation of 1.25 is not from 0 to 1");
  left_out({{"perturbation", {0.5}}}, "perturbation is not a number");
}

TEST(ImportMaterials, UnlitOnesIgnoreWhatShadesAndSaySo) {
  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsUsed"] = {"KHR_materials_unlit", "KHR_materials_transmission",
                              "KHR_materials_clearcoat"};
  const json unlit = json::object();
  b.json["materials"] = {{{"name", "pane"},
                          {"extensions",
                           {{"KHR_materials_unlit", unlit},
                            {"KHR_materials_transmission", {{"transmissionFactor", 0.75}}},
                            {"KHR_materials_clearcoat", {{"clearcoatFactor", 1}}}}}},
                         {{"extensions", {{"KHR_materials_unlit", unlit}}}}};
  b.json["meshes"][0]["primitives"][0]["material"] = 0;
  const test::TemporaryFolder folder;
  const Result<Scene> scene = import_gltf(folder.write("test.glb", b.glb()));
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_TRUE(scene->materials[0].unlit);
  EXPECT_EQ(scene->materials[0].transmission, 0.0f);
  const std::vector<std::string>& remarks = scene->notes.warnings;
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find("pane"), std::string::npos) << remarks[0];
  EXPECT_NE(remarks[0].find("it is unlit, so it shows its base colour alone; ignored: "
                            "KHR_materials_transmission, KHR_materials_clearcoat"),
            std::string::npos)
      << remarks[0];
}

}  // namespace
}  // namespace asos
