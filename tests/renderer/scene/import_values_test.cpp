#include "tests/renderer/scene/gltf_builder.h"
#include "tests/renderer/scene/load_timer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace asos::import_values_test {
namespace {

using nlohmann::json;
using test::GltfBuilder;
using test::load_in_time;

/// How many of the warnings hold `words`; -1 where the file was refused.
int warnings_of(const GltfBuilder& file, const std::string& words) {
  const Result<Scene> scene = load_in_time(file);
  if (!scene) return -1;
  const auto& all = scene->notes.warnings;
  return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const std::string& warning) {
    return warning.find(words) != std::string::npos;
  }));
}

TEST(ImportValues, PlanesOfCamerasThatAreNoneAreSaid) {
  const auto camera = [](const char* type, const json& planes) {
    GltfBuilder b = GltfBuilder::square();
    json projection = {{"yfov", 0.7}, {"xmag", 1}, {"ymag", 1}};
    projection.update(planes);
    b.json["cameras"] = {{{"type", type}, {type, projection}}};
    return b;
  };
  const char* p = "perspective";
  const char* o = "orthographic";
  EXPECT_EQ(warnings_of(camera(p, {{"znear", 0.0}}), "/cameras/0/perspective/znear is 0"), 1);
  EXPECT_EQ(warnings_of(camera(p, {{"znear", -1}}), "/cameras/0/perspective/znear is -1"), 1);
  EXPECT_EQ(warnings_of(camera(p, {{"znear", 2}, {"zfar", 2}}), "zfar is 2, which is not beyond"),
            1);
  EXPECT_EQ(warnings_of(camera(p, {{"znear", 1}, {"zfar", 2}}), "/cameras"), 0);
  EXPECT_EQ(warnings_of(camera(o, {{"znear", -1}, {"zfar", 2}}), "orthographic/znear is -1"), 1);
  EXPECT_EQ(warnings_of(camera(o, {{"znear", 0}, {"zfar", -2}}), "zfar is -2"), 1);
  EXPECT_EQ(warnings_of(camera(o, {{"znear", 0}, {"zfar", 2}}), "/cameras"), 0);
}

TEST(ImportValues, FiltersAndWrapsThatAreNoneAreSaid) {
  for (const char* name : {"magFilter", "minFilter", "wrapS", "wrapT"}) {
    GltfBuilder b = GltfBuilder::square();
    b.json["samplers"] = {{{name, 5}}};
    EXPECT_EQ(warnings_of(b, std::string("/samplers/0/") + name + " is 5, which is none of"), 1);
    b.json["samplers"] = {{{name, std::string(name).starts_with("wrap") ? 33071 : 9728}}};
    EXPECT_EQ(warnings_of(b, "/samplers"), 0) << name;
  }
  // Of the two, only what makes pictures smaller may go between levels.
  GltfBuilder b = GltfBuilder::square();
  b.json["samplers"] = {{{"magFilter", 9987}, {"minFilter", 9987}}};
  EXPECT_EQ(warnings_of(b, "Filter is 9987"), 1);
}

TEST(ImportValues, TexturesWithoutAnIndexAreSaid) {
  const auto of_material = [](const json& material) {
    GltfBuilder b = GltfBuilder::square();
    b.json["extensionsUsed"] = {"KHR_materials_clearcoat", "KHR_materials_sheen"};
    b.json["materials"] = {material};
    b.json["meshes"][0]["primitives"][0]["material"] = 0;
    return b;
  };
  const std::string what = "Texture is not a texture, which has an index";
  for (const json& empty : {json::object(), json{{"texCoord", 0}}}) {
    EXPECT_EQ(warnings_of(of_material({{"emissiveTexture", empty}}), what), 1);
    EXPECT_EQ(
        warnings_of(of_material({{"pbrMetallicRoughness", {{"baseColorTexture", empty}}}}), what),
        1);
    for (const char* name :
         {"clearcoatTexture", "clearcoatRoughnessTexture", "clearcoatNormalTexture"}) {
      const json coat = {{"clearcoatFactor", 1}, {name, empty}};
      EXPECT_EQ(
          warnings_of(of_material({{"extensions", {{"KHR_materials_clearcoat", coat}}}}), what), 1)
          << name;
    }
    const json sheen = {{"sheenColorTexture", empty}, {"sheenRoughnessTexture", empty}};
    EXPECT_EQ(warnings_of(of_material({{"extensions", {{"KHR_materials_sheen", sheen}}}}), what),
              2);
  }
}

TEST(ImportValues, TargetsThatNothingWeighsAreHeldAgainstTheAccessors) {
  GltfBuilder b = GltfBuilder::square();
  b.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}, {{"NORMAL", 999}}};
  EXPECT_EQ(warnings_of(b, "/meshes/0/primitives/0/targets/1/NORMAL is accessor 999"), 1);
  EXPECT_EQ(warnings_of(b, "targets/0"), 0);
}

TEST(ImportValues, VersionsThatAreNoneAreSaid) {
  GltfBuilder b = GltfBuilder::square();
  for (const char* version : {"2.x", "2.", "2.0 beta", "2.0.1"}) {
    b.json["asset"]["version"] = version;
    EXPECT_EQ(warnings_of(b, std::string("/asset/version is '") + version + "'"), 1);
  }
  for (const char* version : {"2.0", "2.1"}) {
    b.json["asset"]["version"] = version;
    EXPECT_EQ(warnings_of(b, "/asset/version"), 0) << version;
  }
}

}  // namespace
}  // namespace asos::import_values_test
