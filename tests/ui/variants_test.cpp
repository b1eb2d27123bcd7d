#include "renderer/gltf/load.h"
#include "renderer/picture/picture_text.h"
#include "tests/ui/choice_fixture.h"
#include "tests/ui/test_scenes.h"

#include <gtest/gtest.h>

#include <string>

namespace asos::test::variants_test {
using namespace ui;
namespace {

using nlohmann::json;

/// A square that is red, or green in a variant.
GltfBuilder two_looks() {
  GltfBuilder b = GltfBuilder::square();
  json& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["material"] = 0;
  primitive["extensions"]["KHR_materials_variants"]["mappings"] = {
      {{"material", 1}, {"variants", {1}}}};
  for (const char* name : {"red", "green"}) b.json["materials"].push_back({{"name", name}});
  b.json["extensionsUsed"] = {"KHR_materials_variants"};
  b.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "Noon"}},
                                                                {{"name", "Dusk\n"}}};
  return b;
}

class Variants : public ChoiceTest {
 protected:
  Variants() : ChoiceTest("Variant", two_looks()) {}
  std::string material() {
    return scene()->world().materials.at(scene()->world().parts.at(0).material).name;
  }
};

TEST_F(Variants, AreChosenFromAList) {
  EXPECT_EQ(material(), "red");
  choose("Dusk\\n");
  EXPECT_EQ(material(), "green");
  choose("Noon");
  EXPECT_EQ(material(), "red") << "which has no mapping in that one";
  EXPECT_EQ(scene()->geometry->contents.variant, "Noon");
  choose("None");
  EXPECT_EQ(scene()->geometry->contents.variant, "");
}

TEST_F(Variants, StayWhereTheFileIsLoadedAgain) {
  choose("Dusk\\n");
  const std::uint64_t opened = scene().times_opened();
  scene().reload();
  arrive(opened);
  EXPECT_EQ(material(), "green");
}

TEST_F(Variants, ComeBackWithSavedPictures) {
  choose("Dusk\\n");
  const PictureDescription said = rig.render().description({});
  EXPECT_EQ(said.variant, "Dusk\n");
  const std::string picture = folder_.file("dusk.png");
  ASSERT_TRUE(write_png(picture, rig.film(), {}, picture_text(said)));
  open("builtin:boxes");
  EXPECT_FALSE(rig.controls().contains("Variant"));
  open(picture);
  EXPECT_EQ(material(), "green");
}

}  // namespace
}  // namespace asos::test::variants_test
