#include "renderer/gltf/load.h"
#include "tests/renderer/gltf/gltf_builder.h"

#include <gtest/gtest.h>

#include <string>

// KHR_materials_variants: LoadOptions::variant.

namespace asos {
namespace {

using nlohmann::json;
using test::GltfBuilder;

/// Two squares of material 0: the first has mappings, the second none.
Result<Scene> import_variant(const std::string& name, json mappings, bool required = false) {
  GltfBuilder b = GltfBuilder::square();
  json& primitives = b.json["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  for (json& primitive : primitives) primitive["material"] = 0;
  primitives[0]["extensions"]["KHR_materials_variants"]["mappings"] = std::move(mappings);
  b.json["materials"] = {{{"name", "red"}}, {{"name", "green"}}, {{"name", "blue"}}};
  b.json["extensionsUsed"] = {"KHR_materials_variants"};
  if (required) b.json["extensionsRequired"] = {"KHR_materials_variants"};
  json variants = json::array();
  for (const char* variant : {"Dawn", "Noon", "Dusk \u2744"})
    variants.push_back({{"name", variant}});
  b.json["extensions"]["KHR_materials_variants"]["variants"] = std::move(variants);
  const test::TemporaryFolder folder;
  return import_gltf(folder.write("shoe.glb", b.glb()), {.variant = name});
}

json two_mappings() {
  json mappings = json::array();
  mappings.push_back({{"material", 1}, {"variants", {0, 2}}});
  mappings.push_back({{"material", 2}, {"variants", {1}}});
  return mappings;
}

std::string material_of(const Scene& scene, std::size_t mesh) {
  return scene.materials.at(static_cast<std::size_t>(scene.meshes.at(mesh).material)).name;
}

TEST(ImportVariants, GiveTheMaterialsOfTheirMappings) {
  const auto shown = [](const std::string& variant) {
    const Result<Scene> scene = import_variant(variant, two_mappings(), true);
    EXPECT_TRUE(scene) << scene.error().message();
    EXPECT_TRUE(scene->notes.warnings.empty());
    EXPECT_EQ(material_of(*scene, 1), "red") << "has no mapping";
    return material_of(*scene, 0);
  };
  EXPECT_EQ(shown(""), "red");
  EXPECT_EQ(shown("Dawn"), "green");
  EXPECT_EQ(shown("Noon"), "blue");
  EXPECT_EQ(shown("Dusk \u2744"), "green");
}

TEST(ImportVariants, UnknownOnesAreRefusedWithThoseThatThereAre) {
  const Result<Scene> scene = import_variant("Night", two_mappings());
  ASSERT_FALSE(scene);
  EXPECT_NE(scene.error().message().find("shoe.glb"), std::string::npos);
  EXPECT_NE(scene.error().message().find("no variant 'Night'; there are 'Dawn', 'Noon', 'Dusk"),
            std::string::npos)
      << scene.error().message();
  GltfBuilder bare = GltfBuilder::square();
  const test::TemporaryFolder folder;
  const auto none = import_gltf(folder.write("bare.glb", bare.glb()), {.variant = "Noon"});
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message().find("no variants"), std::string::npos);
  EXPECT_FALSE(load_scene("builtin:office", {.variant = "Noon"}));
}

TEST(ImportVariants, MappingsThatAreBrokenAreLeftOut) {
  const auto left = [](json mappings) {
    SCOPED_TRACE(mappings.dump());
    const Result<Scene> scene = import_variant("Noon", std::move(mappings));
    EXPECT_TRUE(scene) << scene.error().message();
    EXPECT_EQ(material_of(*scene, 0), "red");
    return scene->notes.warnings.size();
  };
  const auto one = [](json mapping) { return json::array({std::move(mapping)}); };
  EXPECT_EQ(left(one({{"material", 7}, {"variants", {1}}})), 1u);
  EXPECT_EQ(left(one({{"variants", {1}}})), 1u);
  EXPECT_EQ(left(one({{"material", 1}, {"variants", "Noon"}})), 1u) << "of the wrong kind";
  EXPECT_EQ(left(one({{"material", 1}, {"variants", {0.5, -1, 1e300, nullptr}}})), 0u);
  EXPECT_EQ(left(one(3)), 1u);
  EXPECT_EQ(left("none"), 1u);
}

}  // namespace
}  // namespace asos
