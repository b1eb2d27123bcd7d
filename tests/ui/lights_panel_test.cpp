#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>

// The lights panel, and the lights' marks in the picture.

namespace asos {
using namespace ui;
namespace {

using test::PanelsTest;

class LightsPanelTest : public PanelsTest {
 protected:
  LightsPanelTest() {
    open("point light");
    rig.click_each({"Light/1"});
  }

  void open(const std::string& source) {
    EXPECT_TRUE(rig.opens(source) && rig.settle());
    (void)restarted();
  }
  [[nodiscard]] const Light& light(std::size_t i = 0) { return rig.edits().lights()[i].light; }
  [[nodiscard]] const World& world() { return rig.scene()->world(); }
  [[nodiscard]] const std::vector<Light>& lights() { return rig.scene()->lights(); }
  void drag_number(const std::string& name, float pixels) {
    const glm::vec2 from = rig.control(name).centre();
    rig.drag(from, from + glm::vec2(pixels, 0.0f));
  }
  void type_into(const std::string& name, const std::string& text) {
    (void)rig.control(name);  // scrolls there: with Ctrl the wheel has another function
    rig.input().add(KeyChanged{Key::ctrl, true});
    rig.click(name);
    rig.input().add(KeyChanged{Key::ctrl, false});
    rig.frame();
    rig.chord(Key::ctrl, Key::a);
    rig.type(text);
    rig.key(Key::enter);
  }
};

TEST_F(LightsPanelTest, TheTypeIsSwitchedAmongAllKinds) {
  const char* names[] = {"Sphere",    "Spot", "Directional", "Line",
                         "Rectangle", "Disk", "Polygon",     "Point"};
  const LightKind kinds[] = {LightKind::sphere,  LightKind::spot,      LightKind::directional,
                             LightKind::linear,  LightKind::rectangle, LightKind::disk,
                             LightKind::polygon, LightKind::point};
  const FeatureSet* features = &rig.scene()->features();
  for (int i = 0; i < 8; ++i) {
    rig.click(std::string("Type/") + names[i]);
    EXPECT_EQ(kind_of(light()), kinds[i]) << names[i];
    EXPECT_TRUE(restarted()) << names[i];
    ASSERT_EQ(lights().size(), 1u);
    EXPECT_EQ(kind_of(lights()[0]), kinds[i]) << "in the scene that is rendered";
  }
  EXPECT_EQ(features, &rig.scene()->features()) << "nothing was rebuilt";
}

// A lamp with many faces is one row with one switch. Many lights can be filtered by name.
TEST_F(LightsPanelTest, TheLightsOfASurfaceAreOneRow) {
  std::vector<EditedLight>& all = rig.edits().edit_lights();
  EditedLight face = all[0];
  face.light.own_part = 0;
  face.light.name = "lamp";
  all.assign(20, face);
  all.push_back(face);
  all.back().light.own_part = -1;
  all.back().light.name = "Window";
  rig.state().lights.selected = -1;
  // Shows these lights instead of the scene's own.
  rig.frame();
  ASSERT_TRUE(rig.settle());
  const auto shown = [&](const char* name) { return rig.controls().contains(name); };
  EXPECT_TRUE(shown("Surface/1"));
  EXPECT_FALSE(shown("Light/2"));
  EXPECT_TRUE(shown("Light/21"));
  rig.click("Surface on/1");
  for (std::size_t i = 0; i < 20; ++i) EXPECT_FALSE(rig.edits().lights()[i].on) << i;
  EXPECT_TRUE(rig.edits().lights()[20].on);
  rig.click_each({"Surface/1"});
  EXPECT_TRUE(shown("Light/2"));
  rig.state().lights.find = "wIn";
  rig.frame();
  EXPECT_FALSE(shown("Surface/1"));
  EXPECT_TRUE(shown("Light/21"));
}

// The control under the pointer stays there, whatever a click adds.
TEST_F(LightsPanelTest, ButtonsStayWhereTheyAre) {
  // A new kind of light adds rows to other tabs.
  rig.state().tab = PanelTab::scene;
  rig.frame();
  rig.state().lights.selected = -1;
  rig.frame();
  const glm::vec2 before = rig.control("Add light").lo;
  rig.click_each({"Light from face"});
  EXPECT_EQ(rig.control("Add light").lo, before);
  rig.click_each({"Add light"});
  EXPECT_EQ(rig.control("Add light").lo, before);
}

TEST_F(LightsPanelTest, NumbersAreDraggedAndTyped) {
  const float before = light().intensity;
  drag_number("Intensity", 40.0f);
  EXPECT_GT(light().intensity, 1.2f * before);
  EXPECT_TRUE(restarted());
  type_into("Intensity", "12.5");
  EXPECT_EQ(light().intensity, 12.5f);
  type_into("Intensity", "-3");
  EXPECT_EQ(light().intensity, 0.0f) << "no negative light";
  type_into("Position/y", "1.75");
  EXPECT_NEAR(light().position.y + world().origin.y, 1.75, 1e-9);
  drag_number("Position/x", 30.0f);
  EXPECT_GT(light().position.x, 0.01);
  drag_number("Position/z", -30.0f);
  EXPECT_LT(light().position.z + world().origin.z, 1.99);
}

TEST_F(LightsPanelTest, EveryKindHasItsSizes) {
  const auto size_of = [&](const char* type, const char* control, const char* typed) {
    rig.click(std::string("Type/") + type);
    // Rows for soft shadows come and go with the scene.
    ASSERT_TRUE(rig.frames_until([&] { return !rig.edits().relighting(); }));
    for (int i = 0; i < 3; ++i) rig.frame();
    type_into(control, typed);
  };
  size_of("Sphere", "Radius", "0.25");
  EXPECT_DOUBLE_EQ(light().radius, 0.25);
  size_of("Line", "Length", "3");
  EXPECT_NEAR(glm::length(light().half_u), 1.5, 1e-12);
  type_into("Radius", "0.05");
  EXPECT_DOUBLE_EQ(light().radius, 0.05);
  size_of("Rectangle", "Width", "0.5");
  type_into("Height", "0.75");
  EXPECT_NEAR(glm::length(light().half_u), 0.25, 1e-12);
  EXPECT_NEAR(glm::length(light().half_v), 0.375, 1e-12);
  size_of("Disk", "Radius", "0.125");
  EXPECT_DOUBLE_EQ(light().radius, 0.125);
  size_of("Directional", "Sun's angle", "2");
  EXPECT_NEAR(glm::degrees(light().angular_diameter_rad), 2.0, 1e-5);
  size_of("Spot", "Cone", "30");
  EXPECT_NEAR(glm::degrees(light().outer_cone_rad), 30.0, 1e-5);
  type_into("Inner cone", "99");
  EXPECT_NEAR(light().inner_cone_rad, light().outer_cone_rad, 1e-6) << "inside the cone";
  size_of("Polygon", "Radius", "0.4");
  EXPECT_NEAR(polygon_radius(light()), 0.4, 1e-12);
  const std::size_t hexagon = light().outlines[0].size();
  for (const auto& [name, corners] : {std::pair{"Star", 10u}, std::pair{"Triangle", 3u},
                                      std::pair{"Frame", 4u}, std::pair{"Hexagon", 6u}}) {
    rig.click(std::string("Shape/") + name);
    EXPECT_EQ(light().outlines[0].size(), corners) << name;
  }
  EXPECT_EQ(hexagon, 6u);
  EXPECT_TRUE(restarted());
}

TEST_F(LightsPanelTest, ALargerLightKeepsItsPowerUnlessToldNotTo) {
  rig.click_each({"Type/Polygon"});
  const auto power = [this] { return area_of(light()) * static_cast<double>(light().intensity); };
  const double before = power(), radius = polygon_radius(light());
  type_into("Radius", std::to_string(2.0 * radius));
  EXPECT_NEAR(polygon_radius(light()), 2.0 * radius, 1e-5);
  EXPECT_NEAR(power(), before, 1e-4 * before);
  rig.click("Shape/Star");
  EXPECT_NEAR(power(), before, 1e-4 * before);
  rig.click("Keep total power");
  const float intensity = light().intensity;
  type_into("Radius", std::to_string(4.0 * radius));
  EXPECT_EQ(light().intensity, intensity);
  EXPECT_GT(power(), 2.0 * before);
  rig.click_each({"Type/Sphere"});
  EXPECT_FALSE(rig.controls().contains("Keep total power")) << "candela do not depend on the size";
}

// Also for lights behind the viewer.
TEST_F(LightsPanelTest, ALightOutsideThePictureHasAnArrowAtItsBorder) {
  const auto& all = rig.controls();
  const auto picture = rig.content().layout().picture;
  const auto arrow_at = [&](double x, double y, double z) {
    rig.edits().edit_lights()[0].light.position = {x, y, z};
    rig.frame();
    rig.frame();
    EXPECT_FALSE(all.contains("Mark/1"));
    EXPECT_TRUE(all.contains("Light arrow/1"));
    const auto found = all.find("Light arrow/1");
    return found == all.end() ? glm::vec2(-1.0f)
                              : (found->second.centre() - picture.lo) / picture.size;
  };
  // The camera is at z = 3 and looks along -Z.
  EXPECT_GT(arrow_at(50, 0, 0).x, 0.9f);
  EXPECT_LT(arrow_at(-50, 0, 0).x, 0.1f);
  EXPECT_LT(arrow_at(0, 50, 0).y, 0.1f);
  EXPECT_GT(arrow_at(0, -50, 0).y, 0.9f);
  EXPECT_GT(arrow_at(5, 0, 20).x, 0.9f) << "behind the viewer";
  EXPECT_LT(arrow_at(0, 5, 20).y, 0.1f);
  rig.edits().edit_lights()[0].light.position = {0, 0, 0};
  rig.frame();
  rig.frame();
  EXPECT_TRUE(all.contains("Mark/1"));
  EXPECT_FALSE(all.contains("Light arrow/1"));
}

TEST_F(LightsPanelTest, AnArrowSelectsItsLight) {
  rig.click("Add light");
  rig.edits().edit_lights()[0].light.position = {50, 0, 0};
  rig.frame();
  rig.frame();
  ASSERT_EQ(rig.state().lights.selected, 1);
  rig.click("Light arrow/1");
  EXPECT_EQ(rig.state().lights.selected, 0);
}

TEST_F(LightsPanelTest, ResetLeavesTheEditorOpen) {
  type_into("Position/y", "1.75");
  rig.click("Reset/Lights");
  EXPECT_TRUE(restarted());
  EXPECT_NEAR(light().position.y + world().origin.y, 1.0, 1e-9);
  EXPECT_EQ(rig.state().lights.selected, 0);
  rig.click("Add light");
  rig.click("Reset/Lights");
  EXPECT_EQ(rig.state().lights.selected, -1) << "the added one is gone";
}

TEST_F(LightsPanelTest, ASelectedRowKeepsItsColourUnderThePointer) {
  rig.set_blind(false);
  rig.set_pixel_size(1);
  const Controls::Placed row = rig.control("Light/1");
  const auto colour = [&] {
    rig.frame();
    const auto pixels = rig.pixels();
    const glm::ivec2 at(row.lo + glm::vec2(1.0f, 2.0f));
    return pixels[static_cast<std::size_t>(at.y * rig.size().x + at.x)];
  };
  rig.move_to({5, 5});
  const glm::u8vec3 marked = colour();
  rig.move_to(row.centre());
  EXPECT_EQ(colour(), marked);
  rig.state().lights.selected = -1;
  rig.move_to({5, 5});
  EXPECT_NE(colour(), marked);
}

TEST_F(LightsPanelTest, LightsAreTurned) {
  rig.click_each({"Type/Rectangle"});
  type_into("Azimuth", "90");
  type_into("Elevation", "0");
  EXPECT_NEAR(light().direction.x, 1.0, 1e-6);
  type_into("Roll", "90");
  EXPECT_NEAR(std::abs(glm::normalize(light().half_u).y), 1.0, 1e-6);
  rig.click("Two-sided");
  EXPECT_TRUE(light().two_sided);
  rig.click("Casts shadows");
  EXPECT_FALSE(light().casts_shadows);
  EXPECT_TRUE(restarted());
}

TEST_F(LightsPanelTest, ColoursAreBytes) {
  // The first of the three fields.
  const Controls::Placed at = rig.control("Colour");
  const glm::vec2 red(glm::mix(at.lo.x, at.hi.x, 0.1f), at.centre().y);
  rig.drag(red, red - glm::vec2(60.0f, 0.0f));
  EXPECT_LT(light().color.x, 0.9f);
  EXPECT_EQ(light().color.y, 1.0f);
  EXPECT_TRUE(restarted());
}

TEST_F(LightsPanelTest, LightsAreSwitchedAddedAndRemoved) {
  rig.click("Light on/1");
  EXPECT_TRUE(restarted());
  EXPECT_TRUE(lights().empty());
  EXPECT_EQ(rig.edits().lights().size(), 1u);
  rig.click("Light on/1");
  EXPECT_TRUE(restarted());
  EXPECT_EQ(lights().size(), 1u);

  rig.click_each({"Add light"});
  EXPECT_TRUE(restarted());
  EXPECT_EQ(lights().size(), 2u);
  EXPECT_EQ(rig.state().lights.selected, 1);
  rig.click("Light/1");
  EXPECT_EQ(rig.state().lights.selected, 0);
  rig.click("Light/1");
  EXPECT_EQ(rig.state().lights.selected, -1) << "a second click closes the editor";
  rig.click("Light/1");
  rig.click("Remove light");
  EXPECT_TRUE(restarted());
  EXPECT_EQ(lights().size(), 1u);
  EXPECT_EQ(kind_of(light()), LightKind::sphere) << "the one that was added is left";
  rig.click("Reset/Lights");
  EXPECT_TRUE(restarted());
  EXPECT_EQ(kind_of(light()), LightKind::point);
  EXPECT_EQ(rig.state().lights.selected, 0) << "the editor stays open";
  rig.click("Remove light");
  EXPECT_TRUE(restarted());
  EXPECT_TRUE(lights().empty()) << "black as requested, without default lighting";
  rig.frame();
  EXPECT_FALSE(rig.controls().contains("Intensity"));
  rig.click("Remove light");
  EXPECT_TRUE(rig.edits().lights().empty()) << "without effect";
  rig.click("Add light");
  EXPECT_TRUE(restarted());
  EXPECT_EQ(lights().size(), 1u);
}

TEST_F(LightsPanelTest, AClickedFaceBecomesALight) {
  rig.set_pixel_size(1);
  EXPECT_TRUE(rig.settle());
  (void)restarted();
  rig.click_each({"Light from face"});
  EXPECT_TRUE(rig.controls().contains("Light error")) << "nothing was clicked yet";
  const PixelRect area = rig.content().picture_rect();
  rig.move_to({area.width / 2, area.height / 2});
  rig.press(MouseButton::left);
  rig.release(MouseButton::left);
  ASSERT_TRUE(rig.state().clicked.has_value());
  EXPECT_FALSE(restarted()) << "a click turns nothing";
  rig.click("Light from face");
  EXPECT_TRUE(restarted());
  ASSERT_EQ(rig.edits().lights().size(), 2u);
  EXPECT_EQ(light(1).type, Light::Type::polygon);
  // The triangle (-1, -0.9), (0.9, -0.8), (0.1, 1).
  EXPECT_NEAR(area_of(light(1)), 0.5 * (1.9 * 1.9 - 0.1 * 1.1), 1e-5);
  EXPECT_NEAR(light(1).direction.z, 1.0, 1e-6);
  rig.frame();
  EXPECT_FALSE(rig.controls().contains("Light error"));
}

TEST_F(LightsPanelTest, AMarkInThePictureMovesItsLight) {
  rig.set_pixel_size(1);
  type_into("Position/y", "0.2");
  (void)restarted();
  const glm::dvec3 before = light().position;
  const Controls::Placed mark = rig.control("Mark/1");
  const glm::dmat4 camera = rig.camera().camera().world_from_camera;
  rig.drag(mark.centre(), mark.centre() + glm::vec2(40.0f, 20.0f));
  EXPECT_EQ(rig.camera().camera().world_from_camera, camera) << "no orbit";
  const glm::dvec3 moved = light().position - before;
  // The light is at distance 1 from the eye at z = 3, which has the default field of view.
  const double metres_per_pixel = 2.0 * std::tan(0.5 * Camera{}.fov_y_rad) / rig.film().height;
  EXPECT_NEAR(moved.x, 40.0 * metres_per_pixel, 1e-4);
  EXPECT_NEAR(moved.y, -20.0 * metres_per_pixel, 1e-4);
  EXPECT_NEAR(moved.z, 0.0, 1e-6);
  EXPECT_TRUE(restarted());
  rig.frame();
  EXPECT_NEAR(rig.control("Mark/1").centre().x, mark.centre().x + 40.0f, 1.0f);
  rig.key(Key::escape);
  rig.frame();
  EXPECT_FALSE(rig.controls().contains("Mark/1")) << "put by";
  rig.click_each({"Light/1", "Show gizmos"});
  EXPECT_FALSE(rig.controls().contains("Mark/1"));
}

TEST_F(LightsPanelTest, ADoubleClickResets) {
  const auto double_click = [&](const std::string& name) {
    rig.move_to(rig.control(name).centre());
    for (int i = 0; i < 2; ++i) {
      rig.press(MouseButton::left);
      rig.release(MouseButton::left);
    }
    for (int i = 0; i < 30; ++i) rig.frame();
  };
  const float intensity = light().intensity;
  const glm::dvec3 position = light().position;
  drag_number("Intensity", 50.0f);
  drag_number("Position/x", 50.0f);
  EXPECT_NE(light().intensity, intensity);
  double_click("Intensity");
  EXPECT_EQ(light().intensity, intensity);
  // A vector is reset by its name, to the left of its fields.
  const Controls::Placed x = rig.control("Position/x");
  rig.move_to({x.lo.x - 40.0f, x.centre().y});
  for (int i = 0; i < 2; ++i) {
    rig.press(MouseButton::left);
    rig.release(MouseButton::left);
  }
  EXPECT_NEAR(glm::distance(light().position, position), 0.0, 1e-12);
  rig.state().display.exposure_ev = 2.0f;
  double_click("Exposure");
  EXPECT_EQ(display().exposure_ev, 0.0f);
  settings().asos.max_level = 5;
  double_click("MAX");
  EXPECT_EQ(settings().asos.max_level, RenderSettings{}.asos.max_level);
  settings().asos.eps = 0.5;
  double_click("EPS");
  EXPECT_EQ(settings().asos.eps, RenderSettings{}.asos.eps);
}

}  // namespace
}  // namespace asos
