#include "tests/support/temporary_folder.h"
#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace asos {
using namespace ui;
namespace {

using test::PanelsTest;

TEST_F(PanelsTest, LongLabelsMoveTheirWidgetToTheRight) {
  const float left = rig.control("Open...").lo.x;
  const char* name = "Jitter unresolved cells";
  EXPECT_GE(rig.control(name).lo.x, left + ImGui::CalcTextSize(name).x);
  EXPECT_EQ(rig.control("MAX").lo.x, rig.control("EPS").lo.x) << "short labels have a fixed column";
}

TEST_F(PanelsTest, EpsIsDraggedOnALogarithmicScale) {
  slide("EPS", 0.6f, 0.9f);
  const double high = settings().asos.eps;
  EXPECT_TRUE(restarted());
  EXPECT_GT(high, 0.1);
  EXPECT_LE(high, 1.0);
  slide("EPS", 0.9f, 0.5f);
  const double middle = settings().asos.eps;
  EXPECT_TRUE(restarted());
  EXPECT_LT(middle, 0.05);
  EXPECT_GT(middle, 1e-4);
  slide("EPS", 0.5f, -1.0f);
  EXPECT_EQ(settings().asos.eps, 0.0);
  slide("EPS", 0.0f, 2.0f);
  EXPECT_EQ(settings().asos.eps, 1.0);
}

TEST_F(PanelsTest, TypedValuesStayInTheirRange) {
  for (const auto& [typed, expected] :
       {std::pair<std::string, double>{"0.25", 0.25}, {"99", 1.0}, {"-3", 0.0}, {"1e999", 1.0}}) {
    rig.input().add(KeyChanged{Key::ctrl, true});
    rig.click("EPS");
    rig.input().add(KeyChanged{Key::ctrl, false});
    rig.frame();
    rig.chord(Key::ctrl, Key::a);
    rig.type(typed);
    rig.key(Key::enter);
    EXPECT_EQ(settings().asos.eps, expected) << typed;
  }
}

TEST_F(PanelsTest, MaxLeafAndJitterRestart) {
  slide("MAX", 0.2f, 2.0f);
  EXPECT_EQ(settings().asos.max_level, max_level_limit);
  EXPECT_TRUE(restarted());
  slide("MAX", 0.99f, -1.0f);
  EXPECT_EQ(settings().asos.max_level, 0);
  EXPECT_TRUE(restarted());
  rig.click("Cell shading/Point sample");
  EXPECT_EQ(settings().asos.leaf, LeafKind::point);
  EXPECT_TRUE(restarted());
  rig.click("Cell shading/Exact area");
  EXPECT_EQ(settings().asos.leaf, LeafKind::exact);
  EXPECT_TRUE(restarted());
  rig.click("Jitter unresolved cells");
  EXPECT_TRUE(settings().asos.jitter);
  EXPECT_TRUE(restarted());
}

TEST_F(PanelsTest, AWideFilterIsOfferedWhereTheMethodHasOne) {
  slide("Pixel filter", 0.1f, 0.5f);
  EXPECT_GT(settings().filter_width, 1.5);
  EXPECT_LT(settings().filter_width, 4.0);
  EXPECT_EQ(settings().filter_width, std::round(100.0 * settings().filter_width) / 100.0);
  EXPECT_TRUE(restarted());
  slide("Pixel filter", 0.5f, 2.0f);
  EXPECT_EQ(settings().filter_width, RenderSettings::max_filter_width);
  choose_method("Sobol");
  rig.frame();
  EXPECT_TRUE(rig.controls().contains("Pixel filter"));
  choose_method("Whitted");
  rig.frame();
  EXPECT_FALSE(rig.controls().contains("Pixel filter"));
}

TEST_F(PanelsTest, OtherMethodsShowTheirSamples) {
  choose_method("Stochastic");
  EXPECT_EQ(settings().method, Method::stochastic);
  EXPECT_TRUE(restarted());
  rig.frame();
  EXPECT_FALSE(rig.controls().contains("EPS"));
  slide("Samples", 0.1f, 0.2f);
  const int side = static_cast<int>(std::lround(std::sqrt(settings().sampling.spp)));
  EXPECT_EQ(side * side, settings().sampling.spp);
  EXPECT_TRUE(restarted());
  choose_method("Uniform");
  EXPECT_EQ(settings().method, Method::uniform);
  choose_method("ASOS");
  EXPECT_EQ(settings().method, Method::asos);
}

TEST_F(PanelsTest, AMethodThatSamplesToEpsShowsEpsAndMax) {
  choose_method("Adaptive Sobol");
  EXPECT_EQ(settings().method, Method::sobol_adaptive);
  EXPECT_TRUE(restarted());
  rig.frame();
  const auto& all = rig.controls();
  EXPECT_FALSE(all.contains("Samples"));
  EXPECT_FALSE(all.contains("Cell shading/Exact area"));
  ASSERT_TRUE(all.contains("Seed"));
  const double eps = settings().asos.eps;
  slide("EPS", 0.5f, 0.8f);
  EXPECT_GT(settings().asos.eps, eps);
  slide("MAX", 0.4f, 0.9f);
  EXPECT_GT(settings().asos.max_level, 4);
  EXPECT_TRUE(restarted());
}

TEST_F(PanelsTest, DisplayControlsRestartNothing) {
  slide("Exposure", 0.5f, 0.6f);
  EXPECT_GT(display().exposure_ev, 0.5f);
  rig.key(Key::m);
  EXPECT_TRUE(display().show_split_map);
  rig.frame();
  slide("Dimming", 0.5f, 0.25f);
  EXPECT_LT(display().split_dimming, 0.5f);
  rig.frame();
  EXPECT_TRUE(rig.controls().contains("Level/exact"));
  rig.key(Key::m);
  EXPECT_FALSE(display().show_split_map);
  EXPECT_FALSE(restarted());
}

TEST_F(PanelsTest, TheLegendShowsTheScaleOfLevels) {
  rig.set_pixel_size(1);
  EXPECT_TRUE(rig.settle());
  rig.key(Key::m);
  rig.frame();
  rig.frame();
  const std::vector<glm::u8vec3> pixels = rig.pixels();
  const auto colour_of = [&](const std::string& swatch) {
    const Controls::Placed at = rig.control("Level/" + swatch);
    EXPECT_TRUE(at.has_tooltip) << swatch;
    const int x = static_cast<int>(at.centre().x), y = static_cast<int>(at.lo.y) + 5;
    return pixels[static_cast<std::size_t>(y * rig.size().x + x)];
  };
  // The colours are the same for any MAX.
  EXPECT_EQ(colour_of("not split"), split_colour(0));
  EXPECT_EQ(colour_of("exact"), exact_colour);
  for (int level = 1; level <= split_colour_levels; ++level)
    EXPECT_EQ(colour_of(std::to_string(level)), split_colour(level)) << level;
}

TEST_F(PanelsTest, MouseAndKeysMoveTheCamera) {
  const OrbitCamera& camera = rig.camera();
  const glm::dvec3 pivot = camera.pivot();
  const glm::dmat4 before = camera.camera().world_from_camera;
  rig.drag({200, 200}, {260, 180});
  EXPECT_TRUE(restarted());
  EXPECT_NE(camera.camera().world_from_camera, before);
  EXPECT_EQ(camera.pivot(), pivot) << "an orbit keeps its pivot";

  rig.drag({200, 200}, {260, 180}, MouseButton::middle);
  EXPECT_TRUE(restarted());
  EXPECT_NE(camera.pivot(), pivot);

  const double distance = camera.distance();
  rig.wheel({200, 200}, 1.0f);
  EXPECT_TRUE(restarted());
  EXPECT_LT(camera.distance(), distance);
  rig.key(Key::home);
  EXPECT_TRUE(restarted());

  const glm::dvec3 orbited = camera.pivot();
  rig.input().add(KeyChanged{Key::shift, true});
  rig.drag({200, 200}, {260, 180});
  rig.input().add(KeyChanged{Key::shift, false});
  rig.frame();
  EXPECT_NE(camera.pivot(), orbited) << "Shift turns an orbit into a pan";
}

TEST_F(PanelsTest, TheRightButtonLooksAroundAndKeysFly) {
  const OrbitCamera& camera = rig.camera();
  const glm::dvec3 eye = camera.eye();
  rig.drag({200, 500}, {260, 480}, MouseButton::right);
  EXPECT_TRUE(restarted());
  EXPECT_LT(glm::distance(camera.eye(), eye), 1e-9) << "it only looks around";
  rig.input().add(KeyChanged{Key::w, true});
  for (int i = 0; i < 5; ++i) rig.frame();
  EXPECT_LT(glm::distance(camera.eye(), eye), 1e-9) << "no flight without the button";
  rig.press(MouseButton::right);
  EXPECT_EQ(rig.content().seconds_to_redraw(), 0.0) << "it goes on without input";
  const glm::dvec3 ahead = -glm::dvec3(camera.camera().world_from_camera[2]);
  const glm::dvec3 from = camera.eye();
  for (int i = 0; i < 30; ++i) rig.frame();
  rig.input().add(KeyChanged{Key::w, false});
  rig.release(MouseButton::right);
  const glm::dvec3 way = camera.eye() - from;
  EXPECT_GT(glm::dot(way, ahead), 0.1);
  EXPECT_NEAR(glm::length(way), glm::dot(way, ahead), 1e-9) << "straight ahead";
  EXPECT_TRUE(restarted());
}

TEST_F(PanelsTest, ADragThatBeginsOnThePanelLeavesTheCameraAlone) {
  const std::uint64_t revision = rig.camera().revision();
  const Controls::Placed at = rig.control("Exposure");
  rig.drag(at.centre(), {100.0f, 100.0f});
  EXPECT_EQ(rig.camera().revision(), revision);
}

TEST_F(PanelsTest, CamerasAreChosenFromTheList) {
  ASSERT_EQ(rig.viewpoint().chosen_camera(), 0);
  rig.click_each({"View"});
  rig.click("View/Whole scene");
  EXPECT_EQ(rig.viewpoint().chosen_camera(), -1);
  EXPECT_TRUE(restarted());
  rig.click_each({"View"});
  rig.click("View/front");
  EXPECT_EQ(rig.viewpoint().chosen_camera(), 0);
  rig.click("Frame all");
  EXPECT_TRUE(restarted());
}

TEST_F(PanelsTest, TheOpenDialogOpensWhatIsTyped) {
  rig.chord(Key::ctrl, Key::o);
  rig.frame();
  rig.frame();
  rig.type("second");
  EXPECT_EQ(rig.state().browser.typed, "second");
  rig.key(Key::enter);
  ASSERT_TRUE(rig.frames_until([&] { return rig.scene()->geometry->source == "second"; }));
  EXPECT_FALSE(rig.state().show_open);
}

// If the folder has no match, Enter opens the first recent file or built-in scene listed below.
TEST_F(PanelsTest, TheOpenDialogOpensWhatItListsOfThatName) {
  rig.state().recent = {"/gone/boxes-of-mine.glb"};
  const auto opened = [&](const char* typed, const std::string& source) {
    rig.chord(Key::ctrl, Key::o);
    rig.frame();
    rig.frame();
    rig.type(typed);
    rig.key(Key::enter);
    return rig.frames_until([&] { return rig.scene()->geometry->source == source; });
  };
  EXPECT_TRUE(opened("offic", "builtin:office"));
  EXPECT_TRUE(opened("boxes-", "/gone/boxes-of-mine.glb"));
  EXPECT_TRUE(opened("nothing like it", "nothing like it"));
}

TEST_F(PanelsTest, TheOpenDialogIsUsedByKeyboard) {
  const test::TemporaryFolder folder;
  folder.write("first.glb", "");
  folder.write("second.glb", "");
  std::filesystem::create_directories(folder.path() / "deep");
  folder.write("deep/third.glb", "");
  const auto open = [&] {
    rig.state().browser.folder = folder.path();
    rig.chord(Key::ctrl, Key::o);
    for (int i = 0; i < 3; ++i) rig.frame();
  };
  const auto opened = [&](const std::string& name) {
    for (int i = 0; i < 3; ++i) rig.frame();
    EXPECT_FALSE(rig.state().show_open);
    return rig.frames_until([&] { return rig.scene()->geometry->source == folder.file(name); });
  };
  open();
  rig.key(Key::down);
  rig.key(Key::down);
  rig.key(Key::enter);
  EXPECT_TRUE(opened("second.glb"));
  open();
  rig.type("DE");
  rig.key(Key::tab);
  EXPECT_EQ(rig.state().browser.typed, "deep/");
  rig.key(Key::enter);
  rig.frame();
  EXPECT_EQ(rig.state().browser.folder, folder.path() / "deep");
  EXPECT_EQ(rig.state().browser.typed, "");
  rig.frame();
  rig.type("thi");
  rig.key(Key::enter);
  EXPECT_TRUE(opened("deep/third.glb"));
  open();
  rig.click_each({"Folder/deep"});
  rig.click("Open");
  EXPECT_TRUE(opened("deep/third.glb"));
}

TEST_F(PanelsTest, PagesThroughTheModelsOfTheFolder) {
  const test::TemporaryFolder folder;
  for (const char* name : {"a.glb", "b.glb", "c.glb"}) folder.write(name, "");
  const auto opened = [&](const char* name) {
    return rig.frames_until([&] { return rig.scene()->geometry->source == folder.file(name); });
  };
  rig.scene().open(folder.file("a.glb"));
  ASSERT_TRUE(opened("a.glb"));
  rig.key(Key::page_down);
  EXPECT_TRUE(opened("b.glb"));
  EXPECT_EQ(rig.state().message, "2 of 3: b.glb");
  rig.key(Key::page_up);
  EXPECT_TRUE(opened("a.glb"));
  rig.key(Key::page_up);
  EXPECT_TRUE(opened("c.glb"));
}

// Once Page Down asked for the same broken file for ever.
TEST_F(PanelsTest, PagesStepOverABrokenFile) {
  const test::TemporaryFolder folder;
  for (const char* name : {"a.glb", "broken.glb", "c.glb"}) folder.write(name, "");
  rig.scene().open(folder.file("a.glb"));
  const auto opened = [&](const char* name) {
    return rig.frames_until([&] { return rig.scene()->geometry->source == folder.file(name); });
  };
  ASSERT_TRUE(opened("a.glb"));
  rig.key(Key::page_down);
  ASSERT_TRUE(rig.frames_until([&] { return rig.scene().error().has_value(); }));
  EXPECT_TRUE(opened("a.glb")) << "nothing that was open is lost";
  rig.key(Key::page_down);
  EXPECT_TRUE(opened("c.glb"));
}

// A snapshot stays for the next file, with the name of its own; comparisons end.
TEST_F(PanelsTest, AnotherFileEndsComparisonsAndKeepsSnapshots) {
  const test::TemporaryFolder folder;
  for (const char* name : {"a.glb", "b.glb"}) folder.write(name, "");
  const auto open = [&](const char* name) {
    rig.scene().open(folder.file(name));
    return rig.frames_until([&] { return rig.scene()->geometry->source == folder.file(name); });
  };
  ASSERT_TRUE(open("a.glb"));
  rig.frame();
  rig.key(Key::s);
  rig.key(Key::x);
  Frames& frames = rig.state().frames;
  ASSERT_EQ(frames.stored.size(), 1u);
  EXPECT_TRUE(frames.flipped);
  EXPECT_EQ(frames.title(frames.stored[0]), frames.stored[0].name);
  ASSERT_TRUE(open("b.glb"));
  rig.frame();
  EXPECT_FALSE(frames.flipped);
  EXPECT_EQ(frames.comparison, Comparison::none);
  ASSERT_EQ(frames.stored.size(), 1u);
  EXPECT_EQ(frames.title(frames.stored[0]), "a.glb: " + frames.stored[0].name);
}

// F6 moves the focus to the panel and back. There, arrow keys select a control, and Space goes to
// the control.
TEST_F(PanelsTest, ThePanelIsUsedByKeyboard) {
  rig.key(Key::f6);
  rig.frame();
  rig.key(Key::down);
  rig.frame();
  ASSERT_TRUE(ImGui::GetIO().NavVisible);
  const bool before = rig.refinement().paused();
  rig.key(Key::space);
  EXPECT_EQ(rig.refinement().paused(), before) << "it is the panel's key now";
  rig.key(Key::escape);
  if (rig.state().show_open) rig.key(Key::escape);
  rig.key(Key::f6);
  rig.frame();
  rig.key(Key::f6);
  rig.frame();
  rig.frame();
  EXPECT_FALSE(rig.state().leaving.quit);
}

// The keyboard's frame is at "Open..." first. Enter presses the selected control; on a slider it
// starts typing a value.
TEST_F(PanelsTest, EnterPressesWhatTheKeyboardStandsOn) {
  rig.key(Key::f6);
  rig.frame();
  rig.frame();
  rig.key(Key::right);
  rig.key(Key::left);
  ASSERT_TRUE(ImGui::GetIO().NavVisible);
  rig.key(Key::enter);
  rig.frame();
  EXPECT_TRUE(rig.state().show_open);
}

TEST_F(PanelsTest, TheOpenDialogOffersTheBuiltInScenes) {
  rig.click_each({"Open..."});
  rig.frame();
  rig.type("boxes");  // the list is long, and filtered, too
  rig.click("Built-in/boxes");
  ASSERT_TRUE(rig.frames_until([&] { return rig.scene()->geometry->source == "builtin:boxes"; }));
}

TEST_F(PanelsTest, TheOpenDialogCanBeCancelled) {
  for (const bool by_key : {true, false}) {
    rig.click_each({"Open..."});
    ASSERT_TRUE(rig.controls().contains("Cancel"));
    by_key ? rig.key(Key::escape) : rig.click("Cancel");
    EXPECT_FALSE(rig.state().show_open);
    EXPECT_FALSE(rig.state().leaving.quit);
  }
  EXPECT_EQ(rig.scene()->geometry->source, "scene");
}

TEST_F(PanelsTest, LettersTypedIntoTheDialogAreNoShortcuts) {
  rig.chord(Key::ctrl, Key::o);
  rig.frame();
  rig.key(Key::m);
  rig.key(Key::tab);
  EXPECT_FALSE(display().show_split_map);
  EXPECT_TRUE(rig.state().show_panel);
}

TEST_F(PanelsTest, ThePanelCanBeHidden) {
  rig.set_pixel_size(1);
  EXPECT_TRUE(rig.settle());
  const int width = rig.content().picture_rect().width;
  rig.key(Key::tab);
  EXPECT_EQ(rig.content().picture_rect().width, rig.size().x);
  rig.key(Key::tab);
  EXPECT_EQ(rig.content().picture_rect().width, width);
}

TEST_F(PanelsTest, ATooltipAppearsWhenThePointerRests) {
  rig.set_pixel_size(1);
  EXPECT_TRUE(rig.settle());
  rig.move_to(rig.control("EPS").centre());
  const std::vector<glm::u8vec3> before = rig.pixels();
  ASSERT_TRUE(rig.content().seconds_to_redraw().has_value()) << "a frame is due for the tooltip";
  ASSERT_TRUE(rig.sleeps()) << "drawn when due, and not again";
  EXPECT_NE(rig.pixels(), before);
}

TEST_F(PanelsTest, EveryWidgetThatChangesSomethingHasATooltip) {
  rig.key(Key::m);
  rig.frame();
  for (const char* name : {"EPS",
                           "MAX",
                           "Cell shading/Exact area",
                           "Cell shading/Point sample",
                           "Jitter unresolved cells",
                           "Pixel filter",
                           "Method",
                           "Back-face culling",
                           "Shadows",
                           "Soft shadows",
                           "Light rule/Physical",
                           "Light rule/Published",
                           "Exposure",
                           "Dimming",
                           "Legends",
                           "View",
                           "Frame all",
                           "Reset view",
                           "Front",
                           "Right",
                           "Top",
                           "Field of view",
                           "Open...",
                           "Save picture"}) {
    EXPECT_TRUE(rig.control(name).has_tooltip) << name;
  }
}

}  // namespace
}  // namespace asos
