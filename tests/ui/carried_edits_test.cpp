#include "ui/carried_edits.h"

#include "tests/ui/choice_fixture.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

// Edits of lights and materials when a scene is loaded again.

namespace asos::test::carried_edits_test {
using namespace ui;
namespace {

using nlohmann::json;

Light lamp(const std::string& name, glm::dvec3 position) {
  return {.name = name, .position = position};
}

std::vector<EditedLight> opened_with(const std::vector<Light>& lights) {
  std::vector<EditedLight> edited;
  for (const Light& light : lights) {
    edited.push_back(EditedLight::of(light));
    edited.back().source = static_cast<int>(edited.size()) - 1;
  }
  return edited;
}

TEST(CarriedEdits, KeepsEditsOfLightsThatStillExist) {
  const auto first =
      opened_with({lamp("a", {0, 1, 0}), lamp("b", {0, 2, 0}), lamp("c", {0, 3, 0})});
  std::vector<EditedLight> before = first;
  before[0].light.intensity = 7.0f;
  before[1].on = false;
  before.erase(before.begin() + 2);  // c
  before.push_back(EditedLight::of(lamp("added", {5, 5, 5})));
  // The origin moved by (0, 1, 0), and the file has one more light in front.
  const auto opened = opened_with(
      {lamp("new", {9, 9, 9}), lamp("a", {0, 2, 0}), lamp("b", {0, 3, 0}), lamp("c", {0, 4, 0})});
  CarriedEdits carried;
  const auto lights = carried_lights(before, first, opened, {0, 1, 0}, carried);
  ASSERT_EQ(lights.size(), 4u);
  EXPECT_EQ(lights[0].light.intensity, 7.0f);
  EXPECT_EQ(lights[0].original.intensity, 1.0f);
  EXPECT_EQ(lights[0].light.position, glm::dvec3(0, 2, 0));
  EXPECT_EQ(lights[0].source, 1);
  EXPECT_FALSE(lights[1].on);
  EXPECT_EQ(lights[2].light.position, glm::dvec3(5, 6, 5));
  EXPECT_EQ(lights[2].source, -1);
  EXPECT_EQ(lights[3].light.name, "new");
  EXPECT_EQ(carried.lights, 4u) << "two edited, one added, one removed";
  EXPECT_TRUE(carried.lost.empty());
  EXPECT_EQ(carried_words(carried), "Kept 4 light edits");
}

TEST(CarriedEdits, TakesUneditedLightsFromTheFileAndNamesLostOnes) {
  const auto first = opened_with({lamp("a", {0, 1, 0}), lamp("gone\n", {0, 2, 0})});
  std::vector<EditedLight> before = first;
  before[1].light.intensity = 3.0f;
  std::vector<Light> file{lamp("a", {4, 4, 4})};
  file[0].intensity = 20.0f;
  CarriedEdits carried;
  const auto lights = carried_lights(before, first, opened_with(file), {}, carried);
  ASSERT_EQ(lights.size(), 1u);
  EXPECT_EQ(lights[0].light, file[0]) << "edited in the file alone";
  EXPECT_EQ(carried.lights, 0u);
  EXPECT_EQ(carried_words(carried), "Lost, no longer in the scene: light 'gone\\n'");
}

TEST(CarriedEdits, FindsMaterialsByNameAndOrder) {
  Dfr soft{.perturbation = 0.5};
  const NamedDfrs before{{"x", "y", "x", "z"}, {std::nullopt, soft, soft, soft}};
  const MaterialDfrs first(4);
  const NamedDfrs opened{{"y", "x", "x"}, MaterialDfrs(3)};
  CarriedEdits carried;
  const MaterialDfrs dfrs = carried_dfrs(before, first, opened, carried);
  EXPECT_EQ(dfrs, (MaterialDfrs{soft, std::nullopt, soft}));
  EXPECT_EQ(carried_words(carried), "Kept 2 DFR edits. Lost, no longer in the scene: material 'z'");
}

TEST(CarriedEdits, SaysNothingWithoutEdits) {
  const auto first = opened_with({lamp("a", {0, 1, 0})});
  CarriedEdits carried;
  EXPECT_EQ(carried_lights(first, first, first, {}, carried).size(), 1u);
  EXPECT_EQ(carried_words(carried), "");
}

/// Two squares under two lamps.
GltfBuilder lit_squares() {
  GltfBuilder b = GltfBuilder::square();
  b.json["materials"] = {
      {{"name", "mirror"}, {"pbrMetallicRoughness", {{"roughnessFactor", 0.0}}}}};
  b.json["meshes"][0]["primitives"][0]["material"] = 0;
  b.json["extensionsUsed"] = {"KHR_lights_punctual"};
  json& lights = b.json["extensions"]["KHR_lights_punctual"]["lights"];
  lights = {{{"type", "point"}, {"name", "left"}, {"intensity", 50.0}},
            {{"type", "point"}, {"name", "right"}, {"intensity", 50.0}}};
  b.json["nodes"].push_back({{"mesh", 0}, {"translation", {8.0, 0.0, 0.0}}});
  for (int i = 0; i < 2; ++i)
    b.json["nodes"].push_back({{"translation", {3.0 * i, 0.0, 3.0}},
                               {"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
  json& roots = b.json["scenes"][0]["nodes"];
  roots = json::array();
  for (std::size_t i = 0; i < b.json["nodes"].size(); ++i) roots.push_back(i);
  return b;
}

class ReloadTest : public ChoiceTest {
 protected:
  ReloadTest() : ChoiceTest("", lit_squares()) {
    edits().edit_lights()[0].light.intensity = 80.0f;
    edits().edit_dfrs()[0] = Dfr{};
    EXPECT_TRUE(rig.settle());
  }
  SceneEdits& edits() { return rig.edits(); }
  [[nodiscard]] const std::string& message() { return rig.state().message; }
  /// The lights that the render has, after all edits are applied to it.
  [[nodiscard]] float rendered_intensity(std::size_t light) {
    EXPECT_TRUE(rig.frames_until([&] { return !edits().relighting(); }));
    return scene()->lights().at(light).intensity;
  }
};

// They were lost without a question.
TEST_F(ReloadTest, KeepsEditsWhenAnObjectIsHidden) {
  const glm::dvec3 place = edits().lights()[0].light.position + scene()->world().origin;
  const std::uint64_t opened = scene().times_opened();
  scene().hide(1);
  arrive(opened);
  EXPECT_EQ(edits().lights().at(0).light.intensity, 80.0f);
  EXPECT_LT(glm::distance(edits().lights()[0].light.position + scene()->world().origin, place),
            1e-6);
  EXPECT_EQ(edits().lights().at(1).light.intensity, 50.0f);
  EXPECT_EQ(edits().dfrs().at(0), Dfr{});
  EXPECT_EQ(rendered_intensity(0), 80.0f);
  EXPECT_EQ(message(), "Kept 1 light edit, 1 DFR edit");
}

TEST_F(ReloadTest, KeepsEditsWhenTheFileChanges) {
  GltfBuilder changed = lit_squares();
  changed.json["extensions"]["KHR_lights_punctual"]["lights"][1]["intensity"] = 60.0;
  changed.json["materials"][0]["name"] = "chrome";
  folder_.write("file.glb", changed.glb());
  const std::uint64_t opened = scene().times_opened();
  rig.key(Key::r);
  arrive(opened);
  EXPECT_EQ(rendered_intensity(0), 80.0f);
  EXPECT_EQ(rendered_intensity(1), 60.0f);
  EXPECT_EQ(edits().dfrs().at(0), std::nullopt);
  EXPECT_EQ(message(), "Kept 1 light edit. Lost, no longer in the scene: material 'mirror'");
}

TEST_F(ReloadTest, KeptEditsAreStillUnsaved) {
  const std::uint64_t opened = scene().times_opened();
  scene().reload();
  arrive(opened);
  rig.state().opening = {"builtin:boxes"};
  for (int i = 0; i < 3; ++i) rig.frame();
  EXPECT_FALSE(scene().loading().has_value());
  EXPECT_TRUE(rig.controls().contains("Open"));
}

}  // namespace
}  // namespace asos::test::carried_edits_test
