#include "tests/ui/panels_fixture.h"
#include "ui/hidden_objects.h"
#include "ui/panels/outline_panel.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace asos::test::outline_test {
using namespace ui;
namespace {

TEST(HiddenObjects, ArePlacesAmongThoseThatShowSomething) {
  const auto left = [](const std::vector<int>& places) {
    std::vector<ObjectId> hidden;
    for (const int place : places) hidden.push_back({-1, -1, place});
    Scene scene = two_triangles({1, 0, 0});
    for (std::size_t i = 0; i < scene.instances.size(); ++i)
      scene.instances[i].name = std::string(1, static_cast<char>('a' + static_cast<char>(i)));
    // A mesh without surfaces between the triangles.
    scene.meshes.emplace_back();
    Instance nothing{.name = "-", .mesh = static_cast<int>(scene.meshes.size()) - 1};
    scene.instances.insert(scene.instances.begin() + 1, nothing);
    leave_out(scene, hidden);
    std::string names;
    for (const Instance& instance : scene.instances) names += instance.name;
    return names;
  };
  EXPECT_EQ(left({}), "a-b");
  EXPECT_EQ(left({0}), "-b");
  EXPECT_EQ(left({1}), "a-");
  EXPECT_EQ(left({0, 1}), "-");
  EXPECT_EQ(left({7}), "a-b");
  EXPECT_EQ(place_among_all(0, {}), 0);
  EXPECT_EQ(place_among_all(0, {0, 1}), 2);
  EXPECT_EQ(place_among_all(1, {1}), 2);
  EXPECT_EQ(place_among_all(2, {0, 3}), 4);
}

// The names are those of Khronos' registry.
TEST(Extensions, AreThoseThatAMaterialAsksFor) {
  Material m;
  EXPECT_TRUE(extensions_of(m).empty());
  m.transmission = 0.5f;
  m.volume.thickness = 1.0f;
  m.volume.dispersion = 0.1f;
  m.ior = 1.4f;
  EXPECT_EQ(extensions_of(m),
            (std::vector<std::string>{"KHR_materials_dispersion", "KHR_materials_ior",
                                      "KHR_materials_transmission", "KHR_materials_volume"}));
  Material other{.emissive_strength = 5.0f,
                 .unlit = true,
                 .specular_color = {1.0f, 0.5f, 0.5f},
                 .coat = {.factor = 1.0f},
                 .sheen = {.color = glm::vec3(0.1f)},
                 .film = {.factor = 0.2f},
                 .anisotropy = {.strength = 0.5f},
                 .diffuse_transmission = {.factor = 0.3f}};
  EXPECT_EQ(extensions_of(other),
            (std::vector<std::string>{"KHR_materials_anisotropy", "KHR_materials_clearcoat",
                                      "KHR_materials_diffuse_transmission",
                                      "KHR_materials_emissive_strength",
                                      "KHR_materials_iridescence", "KHR_materials_sheen",
                                      "KHR_materials_specular", "KHR_materials_unlit"}));
}

class OutlineTest : public PanelsTest {
 protected:
  OutlineTest() { rig.click_each({"section/Objects"}); }
  [[nodiscard]] std::size_t parts() { return rig.scene()->world().parts.size(); }
  [[nodiscard]] bool becomes(std::size_t count) {
    return rig.frames_until([&] { return parts() == count && !rig.scene().loading(); });
  }
  [[nodiscard]] glm::vec3 middle() {
    const Film& film = rig.film();
    return film.radiance[film.index(film.width / 2, film.height / 2)];
  }
  /// The list is laid out only if it is visible.
  void choose(const std::string& object) {
    (void)rig.control("section/Scene");
    rig.frame();
    rig.click(object);
  }
  /// The eye, in the author's coordinates.
  [[nodiscard]] glm::dvec3 eye() { return rig.camera().eye() + rig.scene()->world().origin; }
};

TEST_F(OutlineTest, WhatWasClickedIsHiddenAndIsolatedAndTheViewStays) {
  ASSERT_EQ(parts(), 2u);
  const glm::vec3 both = middle();
  const glm::dvec3 eye_before = eye();
  // A click on the red triangle, which is in front.
  const Film& film = rig.film();
  rig.state().picked = glm::ivec2(film.width, film.height) / 2;
  rig.frame();
  EXPECT_EQ(rig.state().outline.selected, 0);
  rig.click("Hide");
  ASSERT_TRUE(becomes(1));
  ASSERT_TRUE(rig.settle());
  EXPECT_NE(middle(), both);
  EXPECT_NEAR(glm::distance(eye(), eye_before), 0.0, 1e-9);
  rig.click_each({"Hide"});
  EXPECT_EQ(parts(), 1u) << "none is chosen";

  rig.click("Show all");
  ASSERT_TRUE(becomes(2));
  ASSERT_TRUE(rig.settle());
  EXPECT_EQ(middle(), both);
  EXPECT_NEAR(glm::distance(eye(), eye_before), 0.0, 1e-9);

  choose("Object/2");
  EXPECT_EQ(rig.state().outline.selected, 1);
  rig.click("Isolate");
  ASSERT_TRUE(becomes(1));
  EXPECT_EQ(rig.scene().hidden(), std::vector<int>{0});
  // After a reload the object stays hidden; another scene has nothing hidden.
  const std::uint64_t opened = rig.scene().times_opened();
  rig.scene().reload();
  ASSERT_TRUE(rig.frames_until([&] { return rig.scene().times_opened() > opened; }));
  EXPECT_EQ(parts(), 1u);
  rig.scene().open("scene");
  ASSERT_TRUE(becomes(2));
  EXPECT_TRUE(rig.scene().hidden().empty());
}

// The list shows a few of hundreds of objects, including the clicked one.
TEST_F(OutlineTest, TheListShowsWhatWasClicked) {
  rig.set_pixel_size(1);
  rig.scene().open("grating");
  ASSERT_TRUE(rig.frames_until([&] { return parts() > 200; }));
  ASSERT_TRUE(rig.settle());
  (void)rig.control("section/Scene");  // the list is laid out only if it is visible
  rig.frame();
  const auto& controls = rig.controls();
  const auto pick = [&](float across) {
    const Film& film = rig.film();
    rig.state().picked = glm::ivec2(glm::vec2(film.width, film.height) * glm::vec2(across, 0.6f));
    for (int i = 0; i < 4; ++i) rig.frame();
    const int selected = rig.state().outline.selected;
    EXPECT_GE(selected, 0);
    const Controls::Placed row = controls.at("Object/" + std::to_string(selected + 1));
    const Controls::Placed above = controls.at("Find object");
    EXPECT_GT(row.lo.y, above.hi.y);
    EXPECT_LT(row.hi.y, above.hi.y + 400.0f);
    return selected;
  };
  EXPECT_NE(pick(0.3f), pick(0.6f));
}

TEST_F(OutlineTest, TheLastObjectStays) {
  choose("Object/1");
  rig.click("Isolate");
  ASSERT_TRUE(becomes(1));
  ASSERT_TRUE(rig.settle());
  ASSERT_EQ(rig.state().outline.selected, -1);
  choose("Object/1");
  ASSERT_EQ(rig.state().outline.selected, 0);
  rig.click_each({"Hide"});
  EXPECT_EQ(parts(), 1u);
  EXPECT_EQ(rig.state().message, "No other object");
}

}  // namespace
}  // namespace asos::test::outline_test
