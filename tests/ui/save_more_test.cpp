#include "renderer/files/helper_program.h"
#include "renderer/gltf/load.h"
#include "renderer/picture/picture_description.h"
#include "renderer/scene/posable_scene.h"
#include "renderer/session/render_session.h"
#include "renderer/world/ground.h"
#include "tests/renderer/gltf/moving_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/panels_fixture.h"
#include "ui/legend_strip.h"
#include "ui/scene_export.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

// Saving of scenes, the clipboard, and the legend below a saved split map.

namespace asos::test::save_more_test {
using namespace ui;
namespace {

/// An environment variable that is restored.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    setenv(name, value.c_str(), 1);
  }
  ~Variable() {
    if (before_)
      setenv(name_, before_->c_str(), 1);
    else
      unsetenv(name_);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

class SceneExportTest : public testing::Test {
 protected:
  SceneExportTest() {
    RenderSettings settings{.threads = 1};
    previewer = std::make_unique<Previewer>(Previewer::Hooks{{}, [] {}}, settings);
    open("builtin:office");
  }
  void open(const std::string& source) {
    const std::uint64_t before = previewer->scene().times_opened();
    previewer->scene().open(source);
    for (int i = 0; i < 60000 && previewer->scene().times_opened() == before; ++i) wait();
    ASSERT_GT(previewer->scene().times_opened(), before);
  }
  void wait() {
    previewer->update(now += 0.01);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  void relit() {
    for (int i = 0; i < 20000 && previewer->edits().relighting(); ++i) wait();
    ASSERT_FALSE(previewer->edits().relighting());
  }
  [[nodiscard]] Film picture() const {
    RenderSettings settings{.width = 64, .height = 40, .threads = 1};
    const auto scene = previewer->scene().shared();
    return render_to_end({scene, scene->world().cameras.front(), settings, false}).film;
  }

  /// Files without a camera are framed.
  [[nodiscard]] Film picture_by_default() const {
    RenderSettings settings{.width = 64, .height = 40, .threads = 1};
    const auto scene = previewer->scene().shared();
    return render_to_end({scene, default_camera(scene->world(), 1.6), settings, false}).film;
  }

  /// The largest difference of two pictures, in steps of 8 bits.
  [[nodiscard]] static int largest_step(const Film& a, const Film& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.radiance.size(); ++i) {
      const glm::ivec3 d = glm::abs(glm::ivec3(display_bytes(a.radiance[i], 0.0f)) -
                                    glm::ivec3(display_bytes(b.radiance[i], 0.0f)));
      largest = std::max({largest, d.x, d.y, d.z});
    }
    return largest;
  }

  [[nodiscard]] static double mean(const Film& film) {
    double sum = 0.0;
    for (const glm::vec3& colour : film.radiance)
      sum += static_cast<double>(colour.x + colour.y + colour.z);
    return sum / static_cast<double>(3 * film.radiance.size());
  }

  TemporaryFolder folder;
  std::unique_ptr<Previewer> previewer;
  double now = 0.0;
};

TEST_F(SceneExportTest, KeepsLightsDfrsAndThePicture) {
  std::vector<EditedLight>& lights = previewer->edits().edit_lights();
  ASSERT_FALSE(lights.empty());
  lights[0].light.intensity *= 2.0f;
  lights[0].light.position.y -= 0.1;
  Dfr dfr;
  dfr.rgb[0].max = dfr.rgb[1].max = dfr.rgb[2].max = 0.25;
  MaterialDfrs& dfrs = previewer->edits().edit_dfrs();
  dfrs[0] = dfr;
  relit();
  const Film before = picture();
  const std::vector<Light> lights_before = previewer->scene()->lights();
  const glm::dvec3 origin_before = previewer->scene()->world().origin;
  const MaterialDfrs dfrs_before = previewer->edits().dfrs();

  const Result<std::string> written =
      export_edited(order_of(*previewer, folder.file("edited.glb")));
  ASSERT_TRUE(written) << written.error().message();
  EXPECT_EQ(*written, folder.file("edited.glb"));
  open(folder.file("edited.glb"));

  const std::vector<Light>& lights_after = previewer->scene()->lights();
  ASSERT_EQ(lights_after.size(), lights_before.size());
  const glm::dvec3 origin_after = previewer->scene()->world().origin;
  for (std::size_t i = 0; i < lights_after.size(); ++i) {
    EXPECT_EQ(lights_after[i].type, lights_before[i].type) << i;
    EXPECT_FLOAT_EQ(lights_after[i].intensity, lights_before[i].intensity) << i;
    EXPECT_LT(glm::distance(lights_after[i].position + origin_after,
                            lights_before[i].position + origin_before),
              1e-6)
        << i;
  }
  ASSERT_EQ(previewer->edits().dfrs().size(), dfrs_before.size());
  EXPECT_EQ(previewer->edits().dfrs(), dfrs_before);
  EXPECT_LE(largest_step(picture(), before), 1) << "one step of an 8-bit picture";
}

TEST_F(SceneExportTest, WithoutEditsTheFileKeepsItsOwnLights) {
  const SceneOrder order = order_of(*previewer, folder.file("same.glb"));
  EXPECT_FALSE(order.lights);
  EXPECT_FALSE(order.dfrs);
}

// Animations were left out, and a light of an emissive surface was doubled.
TEST_F(SceneExportTest, AFilesAnimationsAndSurfaceLightsStay) {
  GltfBuilder b = GltfBuilder::square();
  add_channel(b, 0, "translation", b.scalars({0.0f, 1.0f}), b.vec3({{0, 0, 0}, {2, 0, 0}}));
  b.json["materials"] = {{{"name", "panel"}, {"emissiveFactor", {1, 1, 1}}}};
  b.json["meshes"][0]["primitives"][0]["material"] = 0;
  b.json["extensionsUsed"] = {"KHR_lights_punctual"};
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", 9}}};
  b.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  b.node()["children"] = {1};
  open(folder.write("panel.glb", b.glb()));
  ASSERT_EQ(previewer->edits().lights().size(), 2u);
  for (const bool edits_panel : {false, true}) {
    std::vector<EditedLight>& lights = previewer->edits().edit_lights();
    for (EditedLight& edited : lights)
      if ((edited.light.own_part >= 0) == edits_panel) edited.light.intensity *= 3.0f;
    relit();
    const std::string path = folder.file(edits_panel ? "both.glb" : "lamp.glb");
    const Result<std::string> written = export_edited(order_of(*previewer, path));
    ASSERT_TRUE(written) << written.error().message();
    const Result<Scene> saved = load_scene(path, {});
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->contents.animations.size(), 1u);
    const auto prepared = *prepare(*saved);
    ASSERT_EQ(prepared->lights().size(), 2u);
    float point = 0.0f, panel = 0.0f;
    for (const Light& light : prepared->lights())
      (light.type == Light::Type::point ? point : panel) = light.intensity;
    EXPECT_FLOAT_EQ(point, 27.0f);
    EXPECT_FLOAT_EQ(panel, edits_panel ? 3.0f : 1.0f);
  }
}

TEST_F(SceneExportTest, LightsThatAreOffStayOff) {
  for (EditedLight& edited : previewer->edits().edit_lights()) edited.on = false;
  relit();
  const std::vector<EditedLight> before = previewer->edits().lights();
  const Film dark = picture();
  ASSERT_TRUE(export_edited(order_of(*previewer, folder.file("off.glb"))));
  open(folder.file("off.glb"));
  const std::vector<EditedLight>& after = previewer->edits().lights();
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_FALSE(after[i].on) << after[i].light.name;
    const glm::vec3 once_on = after[i].light.color * after[i].light.intensity;
    const glm::vec3 expected = before[i].light.color * before[i].light.intensity;
    EXPECT_LT(glm::distance(once_on, expected), 1e-5f * glm::length(expected));
  }
  // Lights that were on, or default lights, would brighten it many times.
  EXPECT_NEAR(mean(picture()) / mean(dark), 1.0, 0.01);
}

// Lights of an intensity up to 1 could not be told from black ones: default lights came back.
TEST_F(SceneExportTest, AWeakOrRemovedLightGetsNoDefaultLights) {
  for (EditedLight& edited : previewer->edits().edit_lights()) edited.on = false;
  relit();
  const double dark = mean(picture());
  for (const bool removed : {false, true}) {
    std::vector<EditedLight>& lights = previewer->edits().edit_lights();
    if (removed) lights.clear();
    for (EditedLight& edited : lights) edited.light.intensity = 0.5f, edited.on = false;
    relit();
    const std::size_t count = lights.size();
    const std::string path = folder.file(removed ? "removed.glb" : "weak.glb");
    ASSERT_TRUE(export_edited(order_of(*previewer, path)));
    open(path);
    EXPECT_EQ(previewer->edits().lights().size(), count);
    EXPECT_NEAR(mean(picture()) / dark, 1.0, 0.01);
  }
}

// A default light that was edited is the scene's own; its environment stays.
TEST_F(SceneExportTest, EditedDefaultLightsKeepTheirEnvironment) {
  open(folder.write("square.glb", GltfBuilder::square().glb()));
  ASSERT_TRUE(previewer->scene()->lighting->default_lights_added);
  const std::size_t count = previewer->edits().lights().size();
  previewer->edits().edit_lights()[0].on = false;
  relit();
  ASSERT_TRUE(export_edited(order_of(*previewer, folder.file("one.glb"))));
  open(folder.file("one.glb"));
  EXPECT_EQ(previewer->edits().lights().size(), count);
  EXPECT_FALSE(previewer->edits().lights()[0].on);
  EXPECT_TRUE(previewer->scene()->geometry->stage.has_default_lighting);
}

// They were left out together with the file's animations.
TEST_F(SceneExportTest, HiddenObjectsAreRemovedFromTheFile) {
  GltfBuilder b = GltfBuilder::square();
  add_channel(b, 0, "translation", b.scalars({0.0f, 1.0f}), b.vec3({{0, 0, 0}, {2, 0, 0}}));
  for (const double x : {2.0, 4.0})
    b.json["nodes"].push_back({{"mesh", 0}, {"translation", {x, 0.0, 0.0}}});
  b.json["scenes"][0]["nodes"] = {0, 1, 2};
  open(folder.write("three.glb", b.glb()));
  const std::uint64_t opened = previewer->scene().times_opened();
  previewer->scene().hide(1);
  for (int i = 0; i < 20000 && previewer->scene().times_opened() == opened; ++i) wait();
  ASSERT_EQ(objects_without_ground(previewer->scene()->world()), 2u);
  const Film before = picture_by_default();
  const std::string path = folder.file("two.glb");
  ASSERT_EQ(*export_edited(order_of(*previewer, path)), path);
  const Result<Scene> saved = load_scene(path, {});
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->contents.animations.size(), 1u);
  EXPECT_EQ(saved->contents.nodes.size(), 3u);
  EXPECT_EQ(saved->contents.object_nodes, (std::vector<int>{0, 2}));
  open(path);
  EXPECT_LE(largest_step(picture_by_default(), before), 1);
}

// An animation changes KHR_node_visibility of three squares in a row: the first is visible before
// 1 s, the second from then on.
class BlinkingTest : public SceneExportTest {
 protected:
  BlinkingTest() {
    GltfBuilder b = GltfBuilder::square();
    for (const double x : {2.0, 4.0})
      b.json["nodes"].push_back({{"mesh", 0}, {"translation", {x, 0.0, 0.0}}});
    b.json["scenes"][0]["nodes"] = {0, 1, 2};
    b.json["extensionsUsed"] = {"KHR_node_visibility", "KHR_animation_pointer"};
    b.json["nodes"][1]["extensions"]["KHR_node_visibility"]["visible"] = false;
    for (const int node : {0, 1}) {
      const std::vector<std::uint8_t> visible{node == 0, node == 1};
      add_channel(b, 0, "pointer", b.scalars({0.0f, 1.0f}),
                  b.accessor(b.view(visible), 5121, "SCALAR", 2), "STEP");
      nlohmann::json& target = b.json["animations"][0]["channels"].back()["target"];
      target.erase("node");
      target["extensions"]["KHR_animation_pointer"]["pointer"] =
          "/nodes/" + std::to_string(node) + "/extensions/KHR_node_visibility/visible";
    }
    open(folder.write("blinking.glb", b.glb()));
  }
  void seek(double seconds) {
    previewer->playback().seek(seconds);
    const auto shown = [&] { return previewer->scene()->geometry->time == ClipTime{0, seconds}; };
    for (int i = 0; i < 20000 && !shown(); ++i) wait();
    ASSERT_TRUE(shown());
  }
  void hide(int part) {
    const std::uint64_t opened = previewer->scene().times_opened();
    previewer->scene().hide(part);
    for (int i = 0; i < 20000 && previewer->scene().times_opened() == opened; ++i) wait();
    ASSERT_GT(previewer->scene().times_opened(), opened);
  }
  /// The x of the first corner of each visible object.
  [[nodiscard]] std::vector<int> places() const {
    std::vector<int> found;
    const World& world = previewer->scene()->world();
    for (std::size_t i = 0; i < objects_without_ground(world); ++i) {
      const glm::uvec3 corners = world.triangles[world.parts[i].first_triangle];
      found.push_back(static_cast<int>(std::lround(world.positions[corners.x].x + world.origin.x)));
    }
    return found;
  }
};

TEST_F(BlinkingTest, ObjectsStayHiddenInAllPoses) {
  EXPECT_EQ(places(), (std::vector<int>{0, 4}));
  seek(1.0);
  EXPECT_EQ(places(), (std::vector<int>{2, 4}));
  hide(0);
  seek(1.0);
  EXPECT_EQ(places(), std::vector<int>{4});
  EXPECT_EQ(previewer->scene().hidden(), std::vector<int>{0});
  seek(0.0);
  EXPECT_EQ(places(), (std::vector<int>{0, 4}));
  EXPECT_TRUE(previewer->scene().hidden().empty()) << "it is invisible in this pose";
  EXPECT_TRUE(previewer->scene().hides());
  hide(0);
  seek(1.0);
  EXPECT_EQ(places(), std::vector<int>{4}) << "the other one stays hidden";
}

// The second of two visible objects was taken for the second of the file.
TEST_F(BlinkingTest, TheHiddenObjectIsRemovedFromTheFile) {
  seek(1.0);
  hide(0);
  seek(0.0);
  const std::string path = folder.file("two.glb");
  ASSERT_EQ(*export_edited(order_of(*previewer, path)), path);
  const Result<Scene> saved = load_scene(path, {.keep_posable = true});
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->contents.object_nodes, (std::vector<int>{0, 2}));
  EXPECT_EQ(saved->rig->pose(ClipTime{0, 1.0})->contents.object_nodes, std::vector<int>{2});
}

TEST_F(SceneExportTest, CopiesOfOneNodeAreHiddenWithoutAnimations) {
  GltfBuilder b = GltfBuilder::square();
  add_channel(b, 0, "translation", b.scalars({0.0f, 1.0f}), b.vec3({{0, 0, 0}, {2, 0, 0}}));
  b.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  b.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"TRANSLATION", b.vec3({{0, 0, 0}, {3, 0, 0}})}};
  open(folder.write("copies.glb", b.glb()));
  const std::uint64_t opened = previewer->scene().times_opened();
  previewer->scene().hide(0);
  for (int i = 0; i < 20000 && previewer->scene().times_opened() == opened; ++i) wait();
  const std::string path = folder.file("one.glb");
  EXPECT_EQ(*export_edited(order_of(*previewer, path)), path + " (without its animations)");
  EXPECT_EQ(load_scene(path, {})->instances.size(), 1u);
}

TEST_F(SceneExportTest, ABuiltInScenesAnimationIsSaved) {
  open("builtin:walking-pole");
  const std::string path = folder.file("pole.glb");
  ASSERT_EQ(*export_edited(order_of(*previewer, path)), path);
  const Result<Scene> saved = load_scene(path, {});
  ASSERT_TRUE(saved);
  ASSERT_EQ(saved->contents.animations.size(), 1u);
  EXPECT_EQ(saved->contents.animations[0].seconds, 10.0);
}

TEST_F(SceneExportTest, SaysWhatCannotBeWritten) {
  const auto error = [&](const std::string& path) {
    const Result<std::string> written = export_edited(order_of(*previewer, path));
    return written ? std::string("written") : written.error().message();
  };
  EXPECT_EQ(error(folder.file("scene.obj")),
            folder.file("scene.obj") + ": a scene is written as .glb or .gltf");
  EXPECT_TRUE(error(folder.file("no/such.glb")).starts_with(folder.file("no/such.glb") + ": "));
  ASSERT_EQ(error(folder.file("own.glb")), "written");
  open(folder.file("own.glb"));
  EXPECT_EQ(error(folder.file("own.glb")),
            folder.file("own.glb") + ": is the open file; choose another name");
}

class SaveMoreTest : public PanelsTest {
 protected:
  UiState& state() { return rig.state(); }
  void install(const std::string& name, const std::string& script) {
    folder.write(name, "#!/bin/sh\n" + script);
    std::filesystem::permissions(folder.file(name), std::filesystem::perms::owner_all);
  }
  [[nodiscard]] bool says(const std::string& words) {
    return rig.frames_until([&] { return state().message.starts_with(words); }, 20.0);
  }

  TemporaryFolder folder;
  Variable pictures{"XDG_PICTURES_DIR", folder.path().string()};
  Variable programs{"PATH", folder.path().string()};
  Variable wayland{"WAYLAND_DISPLAY", ""};
};

TEST_F(SaveMoreTest, ThePictureIsCopiedByXclip) {
  install("xclip", "echo \"$@\" > " + folder.file("arguments") + "\n/bin/cat > " +
                       folder.file("copied.png") + "\n");
  rig.chord(Key::ctrl, Key::c);
  ASSERT_TRUE(says("Copied the picture")) << state().message;
  EXPECT_EQ(content_of(folder.file("arguments")), "-selection clipboard -t image/png -i\n");
  const Result<RgbImage> copied = read_png(folder.file("copied.png"));
  ASSERT_TRUE(copied) << copied.error().message();
  const Film& film = rig.film();
  ASSERT_EQ(glm::ivec2(copied->width, copied->height), glm::ivec2(film.width, film.height));
  const glm::u8vec3 first = display_bytes(film, 0, usual_display);
  EXPECT_EQ(glm::u8vec3(copied->rgb[0], copied->rgb[1], copied->rgb[2]), first);
}

TEST_F(SaveMoreTest, SaysWhyThePictureIsNotCopied) {
  rig.chord(Key::ctrl, Key::c);
  EXPECT_TRUE(says("Not copied: clipboard: copying pictures needs xclip")) << state().message;
  install("xclip", "echo no display >&2\nexit 3\n");
  rig.chord(Key::ctrl, Key::c);
  EXPECT_TRUE(says("Not copied: xclip: ended with code 3: no display")) << state().message;
}

TEST_F(SaveMoreTest, TheDialogSavesTheScene) {
  rig.input().add(KeyChanged{Key::shift, true});
  rig.chord(Key::ctrl, Key::s);
  rig.input().add(KeyChanged{Key::shift, false});
  for (int i = 0; i < 3; ++i) rig.frame();
  EXPECT_FALSE(state().save.show);
  ASSERT_TRUE(state().save_scene.show);
  EXPECT_EQ(state().save_scene.path, folder.file("scene-001.glb"));
  state().save_scene.path = folder.file("scene.obj");
  rig.frame();
  rig.click("Save scene");
  EXPECT_TRUE(state().save_scene.show) << "the name has to end in .glb or .gltf";
  rig.key(Key::escape);
  rig.frame();
  EXPECT_FALSE(state().save_scene.show);
}

TEST_F(SaveMoreTest, TheSplitMapIsOffForTheNextFile) {
  rig.key(Key::m);
  EXPECT_TRUE(display().show_split_map);
  rig.scene().reload();
  const std::uint64_t opened = rig.scene().times_opened();
  ASSERT_TRUE(rig.frames_until([&] { return rig.scene().times_opened() > opened; }));
  rig.frame();
  EXPECT_TRUE(display().show_split_map) << "it is the same file";
  ASSERT_TRUE(rig.opens("grating"));
  rig.frame();
  EXPECT_FALSE(display().show_split_map);
}

TEST_F(SaveMoreTest, ASavedSplitMapHasItsLegend) {
  show_all_pixels();
  rig.key(Key::m);
  rig.key(Key::p);
  const Result<RgbImage> saved = read_png(folder.file("scene-001.png"));
  ASSERT_TRUE(saved) << saved.error().message();
  const Film& film = rig.film();
  EXPECT_EQ(saved->width, film.width);
  ASSERT_GT(saved->height, film.height + 20);
  const auto below = [&](glm::u8vec3 colour) {
    int count = 0;
    const auto first = 3 * static_cast<std::size_t>(film.width * film.height);
    for (std::size_t i = first; i < saved->rgb.size(); i += 3)
      count += glm::u8vec3(saved->rgb[i], saved->rgb[i + 1], saved->rgb[i + 2]) == colour;
    return count;
  };
  for (const LegendEntry& entry : legend_entries(SplitMapColours::level, {}))
    EXPECT_GT(below(entry.colour), 60) << entry.words;
  EXPECT_GT(below(glm::u8vec3(0xe0)), 10) << "letters";
  state().display.show_legend = false;
  rig.key(Key::p);
  EXPECT_EQ(read_png(folder.file("scene-002.png"))->height, film.height);
}

TEST(HelperProgram, IsFoundOnThePath) {
  TemporaryFolder folder;
  folder.write("tool", "#!/bin/sh\n");
  const Variable path("PATH", "/no/such/folder:" + folder.path().string());
  EXPECT_EQ(find_program("tool"), "") << "it is not executable";
  std::filesystem::permissions(folder.file("tool"), std::filesystem::perms::owner_all);
  EXPECT_EQ(find_program("tool"), folder.file("tool"));
  EXPECT_FALSE(run_program({"/no/such/program"}, "", {}));
}

TEST(HelperProgram, CanBeStopped) {
  const Result<void> ended = run_program({"/bin/sleep", "60"}, "", [] { return true; });
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().message(), "sleep: stopped");
}

TEST(HelperProgram, IsKilledIfItDoesNotEnd) {
  TemporaryFolder folder;
  const std::string ready = folder.file("ready");
  const std::string deaf = "trap '' TERM; : > '" + ready + "'; while :; do sleep 1; done";
  const Result<void> ended =
      run_program({"/bin/sh", "-c", deaf}, "", [&] { return std::filesystem::exists(ready); });
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().message(), "sh: stopped");
}

}  // namespace
}  // namespace asos::test::save_more_test
