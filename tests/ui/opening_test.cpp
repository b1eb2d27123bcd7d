#include "renderer/film/image_io.h"
#include "renderer/prepared/prepare_on_ground.h"
#include "renderer/work_counts.h"
#include "renderer/world/ground.h"
#include "tests/renderer/gltf/gltf_builder.h"
#include "tests/support/render_picture.h"
#include "tests/ui/previewer_fixture.h"
#include "tests/ui/ui_rig.h"
#include "ui/edit_history.h"

// Scenes replace each other; scenes that cannot be opened leave the old one.

namespace asos::test::opening_test {
using namespace ui;
namespace {

class OpeningTest : public PreviewerTest {};

TEST_F(OpeningTest, TheOpenSceneStaysWhenAnotherFails) {
  ASSERT_TRUE(opens("red", {48, 32}));
  previewer.scene().open("/no/such.glb");
  ASSERT_TRUE(update_until([&] { return previewer.scene().error().has_value(); }));
  EXPECT_EQ(previewer.scene().error()->message(), "/no/such.glb: there is no such file");
  EXPECT_EQ(previewer.scene()->geometry->source, "red");
  EXPECT_FALSE(previewer.scene().loading().has_value());
  ASSERT_TRUE(finished());

  // The next scene removes the message.
  ASSERT_TRUE(opens("green"));
  EXPECT_FALSE(previewer.scene().error().has_value());
}

TEST_F(OpeningTest, ExceptionsOfTheLoaderAreErrors) {
  previewer.scene().open("huge");
  ASSERT_TRUE(update_until([&] { return previewer.scene().error().has_value(); }));
  EXPECT_EQ(previewer.scene().error()->reason, "not enough memory to load this scene");
  previewer.scene().open("odd");
  ASSERT_TRUE(update_until([&] { return previewer.scene().error().has_value(); }));
  EXPECT_EQ(previewer.scene().error()->message(), "odd: an odd thing");
}

TEST_F(OpeningTest, ANewerSceneReplacesOneThatLoads) {
  previewer.viewpoint().set_picture_size(48, 32, now);
  previewer.scene().open("slow");
  ASSERT_TRUE(update_until([&] { return loader.calls == 1; }));
  previewer.scene().open("green");
  previewer.scene().open("red");
  ASSERT_TRUE(previewer.scene().loading().has_value());
  EXPECT_EQ(previewer.scene().loading()->source, "red");
  loader.released = true;
  std::vector<std::string> seen;
  ASSERT_TRUE(update_until([&] {
    if (const RenderScene* scene = previewer.scene().get()) {
      if (seen.empty() || seen.back() != scene->geometry->source)
        seen.push_back(scene->geometry->source);
    }
    return !seen.empty() && seen.back() == "red";
  }));
  EXPECT_EQ(seen, std::vector<std::string>{"red"});
  EXPECT_EQ(loader.calls, 2) << "requests that were replaced early need not be loaded";
}

TEST_F(OpeningTest, ReplacingScenesWhileTheyRenderIsSafe) {
  previewer.viewpoint().set_picture_size(160, 120, now);
  for (int i = 0; i < 20; ++i) {
    const std::string source = i % 2 == 0 ? "red" : "green";
    previewer.scene().open(source);
    ASSERT_TRUE(opened(source)) << "scene " << i;
  }
  ASSERT_TRUE(finished());
  previewer.update(now);
  EXPECT_EQ(previewer.render().film().radiance[previewer.render().film().index(80, 60)],
            glm::vec3(0, 1, 0));
}

TEST_F(OpeningTest, ReplacingASceneWhoseBoundariesAreLookedForIsSafe) {
  previewer.viewpoint().set_picture_size(64, 48, 0.0);
  std::weak_ptr<const Geometry> before;
  for (const char* source : {"many", "green", "many"}) {
    ASSERT_TRUE(opens(source));
    // Waits for the coarse picture only.
    ASSERT_TRUE(update_until([&] { return !previewer.render().first_picture_pending(); }));
    EXPECT_TRUE(before.expired()) << "the scene before " << source;
    before = previewer.scene()->geometry;
  }
  // The previewer is destroyed while it searches the edges of the last scene.
}

TEST_F(OpeningTest, EndsWhileALoadIsWaiting) {
  previewer.scene().open("slow");
  ASSERT_TRUE(update_until([&] { return loader.calls == 1; }));
  previewer.scene().open("red");
  loader.released = true;
}

/// Loads "red" at once. Any other scene has a stage and a box, and never ends by itself.
class EndlessLoader {
 public:
  LoadFunction function() {
    return [this](const std::string& source) -> Result<Scene> {
      if (source == "red") return two_triangles({1, 0, 0}, source);
      ++begun;
      begin_stage(LoadStage::meshes);
      LoadProgress::current()->publish(
          std::make_shared<const ScenePreview>(ScenePreview{{-1, -1, -1}, {1, 1, 1}, {}}));
      try {
        for (;;) {
          stop_point();
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
      } catch (const LoadStopped&) {
        ++stopped;
        throw;
      }
    };
  }
  std::atomic<int> begun = 0, stopped = 0;
};

TEST(StoppedLoad, MakesRoomForTheNextOne) {
  EndlessLoader loader;
  std::atomic<int> wakes = 0;
  {
    Previewer previewer({loader.function(), [&] { ++wakes; }}, small_picture());
    const auto wait = [&](const std::function<bool()>& done) {
      for (int i = 0; i < 20000 && !done(); ++i) {
        previewer.update(0.0);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      return done();
    };
    previewer.scene().open("endless");
    ASSERT_TRUE(wait([&] { return previewer.scene().loading()->preview != nullptr; }));
    EXPECT_EQ(previewer.scene().loading()->stage, LoadStage::meshes);
    EXPECT_GE(wakes, 2) << "the window is woken for the stage and for the box";
    previewer.scene().open("red");
    EXPECT_FALSE(previewer.scene().loading()->preview) << "it was of the other scene";
    ASSERT_TRUE(wait([&] { return previewer.scene().get() != nullptr; }));
    EXPECT_EQ(loader.stopped, 1);
    EXPECT_FALSE(previewer.scene().error());
    previewer.scene().open("endless");
    ASSERT_TRUE(wait([&] { return loader.begun == 2; }));
  }
  EXPECT_EQ(loader.stopped, 2) << "closing the window stops the load, too";
}

// The box appears in the upper half of the picture, where the notice is not.
TEST(StoppedLoad, ShowsTheBoxMeanwhile) {
  EndlessLoader loader;
  UiRig rig(loader.function());
  const auto open_red = [&] {
    rig.scene().open("red");
    return rig.frames_until([&] {
      return rig.scene() && !rig.scene().loading() && !rig.render().first_picture_pending();
    });
  };
  ASSERT_TRUE(open_red());
  const auto lines = [&] {
    const std::uint32_t colour = theme::rgb(theme::accent_bright);
    const std::vector<glm::u8vec3> pixels = rig.pixels();
    const PixelRect area = rig.content().picture_rect();
    int count = 0;
    for (int y = 0; y < area.height / 2; ++y) {
      for (int x = 0; x < area.width; ++x) {
        const glm::ivec3 off =
            glm::abs(glm::ivec3(pixels[static_cast<std::size_t>(y * rig.size().x + x)]) -
                     glm::ivec3(colour >> 16 & 255u, colour >> 8 & 255u, colour & 255u));
        count += std::max({off.x, off.y, off.z}) < 40 ? 1 : 0;
      }
    }
    return count;
  };
  EXPECT_EQ(lines(), 0);
  rig.scene().open("endless");
  ASSERT_TRUE(rig.frames_until([&] {
    const auto loading = rig.scene().loading();
    return loading && loading->preview && loading->seconds > loading_box_delay;
  }));
  EXPECT_GT(lines(), 150);
  ASSERT_TRUE(open_red());
  EXPECT_EQ(lines(), 0);
}

/// A square with a large picture, and a small one that glows.
GltfBuilder large_picture() {
  GltfBuilder b = GltfBuilder::square();
  const int uv = b.vec2({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  nlohmann::json& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["attributes"]["TEXCOORD_0"] = uv;
  primitive["material"] = 0;
  b.json["accessors"][0]["min"] = {0, 0, 0};
  b.json["accessors"][0]["max"] = {1, 1, 0};
  b.json["images"] = {{{"uri", "large.png"}}, {{"uri", small_png}}};
  b.json["textures"] = {{{"source", 0}}, {{"source", 1}}};
  b.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                          {"normalTexture", {{"index", 0}}},
                          {"emissiveFactor", {1, 1, 1}},
                          {"emissiveTexture", {{"index", 1}}}}};
  return b;
}

/// Writes the large picture next to the scene, with texels that do not compress well.
void write_large_picture(const std::string& scene, int height = 2049) {
  RgbImage image{2048, height, {}, {}};
  image.rgb.resize(std::size_t{3} * 2048 * static_cast<std::size_t>(height));
  std::uint32_t noise = 1;
  for (std::uint8_t& byte : image.rgb) {
    noise = noise * 1664525u + 1013904223u;
    byte = static_cast<std::uint8_t>(noise >> 24 & 15u);
  }
  const auto path = std::filesystem::path(scene).parent_path() / "large.png";
  ASSERT_TRUE(write_png(path.string(), image));
}

// The first picture shows the factors of materials whose textures take longest.
TEST(LateTextures, FollowTheFirstPicture) {
  const TemporaryFolder folder;
  const std::string path = folder.write("square.glb", large_picture().glb());
  write_large_picture(path);
  Previewer previewer({{}, {}}, small_picture());
  previewer.viewpoint().set_picture_size(48, 32, 0.0);
  previewer.scene().open(path);
  const auto update_until = [&](const std::function<bool()>& done) {
    for (int i = 0; i < 20000 && !done(); ++i) {
      previewer.update(0.0);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return done();
  };
  ASSERT_TRUE(update_until([&] { return previewer.scene().get() != nullptr; }));
  ASSERT_EQ(previewer.scene()->world().images.size(), 2u);
  EXPECT_EQ(previewer.scene()->world().images[0].width, 1);
  EXPECT_EQ(previewer.scene()->world().images[0].rgba.get(),
            (SharedBytes::Bytes{128, 128, 255, 255}));
  EXPECT_EQ(previewer.scene()->world().images[1].width, 2) << "emission decides on the lighting";
  EXPECT_EQ(previewer.scene().textures_missing(), 1u);
  const Camera camera = previewer.viewpoint().camera().camera();

  EXPECT_TRUE(previewer.awaits_first_picture());
  EXPECT_FALSE(previewer.scene().loading()) << "the textures wait for the first picture";
  ASSERT_TRUE(update_until([&] { return !previewer.awaits_first_picture(); }));
  EXPECT_TRUE(previewer.scene().loading());
  ASSERT_TRUE(update_until([&] { return previewer.scene().textures_missing() == 0; }));
  EXPECT_EQ(previewer.scene()->world().images[0].width, 2048);
  EXPECT_EQ(previewer.viewpoint().camera().camera(), camera);
  // The scene is the one that a program without a window opens.
  const Scene whole = load_scene(path).value();
  EXPECT_EQ(previewer.scene()->world().images[0].rgba, whole.images[0].rgba);
  EXPECT_EQ(previewer.scene()->geometry->notes.warnings, whole.notes.warnings);
}

// Pictures that are decoded within some 20 ms come with the first picture.
TEST(LateTextures, AreNoSmallOnes) {
  for (const int height : {2047, 2049}) {
    const TemporaryFolder folder;
    const std::string path = folder.write("square.glb", large_picture().glb());
    write_large_picture(path, height);
    LoadProgress progress;
    progress.allow_missing_textures();
    const LoadProgress::Scope scope(&progress);
    EXPECT_EQ(load_scene(path).value().images[0].width, height < 2048 ? 2048 : 1);
    EXPECT_EQ(progress.missing_textures(), height < 2048 ? 0u : 1u);
  }
}

// Textures that arrive change no edit, and build nothing again.
TEST(LateTextures, KeepEditsAndHierarchies) {
  const TemporaryFolder folder;
  const std::string path = folder.write("square.glb", large_picture().glb());
  write_large_picture(path);
  Previewer previewer({{}, {}}, small_picture());
  EditHistory history;
  DisplaySettings display;
  double now = 0.0;
  previewer.viewpoint().set_picture_size(48, 32, now);
  const auto update = [&] {
    previewer.update(now);
    history.update(previewer, display, false, now);
    now += 0.01;
  };
  const auto update_until = [&](const std::function<bool()>& done) {
    for (int i = 0; i < 20000 && !done(); ++i) {
      update();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return done();
  };
  previewer.scene().open(path);
  ASSERT_TRUE(update_until([&] { return previewer.scene().get() != nullptr; }));
  ASSERT_EQ(previewer.scene().textures_missing(), 1u);
  update();
  const std::uint64_t opened = previewer.scene().times_opened();
  previewer.edits().settings().asos.max_level = 2;
  previewer.edits().edit_dfrs()[0] = Dfr{};
  for (int i = 0; i < 100; ++i) update();
  ASSERT_TRUE(history.can_undo());

  ASSERT_TRUE(update_until([&] { return previewer.scene().loading().has_value(); }));
  const std::uint64_t surfaces = WorkDone::of(Work::hierarchy_surfaces);
  const std::uint64_t pairs = WorkDone::of(Work::coplanar_pairs);
  const std::uint64_t lookups = WorkDone::of(Work::emission_lookups);
  ASSERT_TRUE(update_until([&] { return previewer.scene().textures_missing() == 0; }));
  EXPECT_EQ(previewer.scene()->world().images[0].width, 2048);
  EXPECT_EQ(WorkDone::of(Work::hierarchy_surfaces), surfaces);
  EXPECT_EQ(WorkDone::of(Work::coplanar_pairs), pairs);
  EXPECT_EQ(WorkDone::of(Work::emission_lookups), lookups);
  EXPECT_EQ(previewer.scene().times_opened(), opened) << "a selection stays";
  EXPECT_EQ(previewer.scene()->dfrs().at(0), Dfr{});
  EXPECT_EQ(previewer.edits().settings().asos.max_level, 2);
  update();
  ASSERT_TRUE(history.undo(previewer, display));
  EXPECT_EQ(previewer.edits().settings().asos.max_level, small_picture().asos.max_level);
  // The picture is that of a program that waits for all textures.
  ASSERT_TRUE(update_until([&] { return !previewer.edits().relighting(); }));
  const auto whole =
      prepare_on_ground(load_scene(path).value(), {}, nullptr, [&](const World&, bool) {
        return GroundChoice{previewer.edits().settings().ground};
      }).value();
  RenderSettings settings = small_picture();
  settings.width = 24, settings.height = 16, settings.method = Method::sobol;
  const Camera camera = previewer.viewpoint().camera().camera();
  EXPECT_EQ(render_picture(*previewer.scene(), camera, settings).film.radiance,
            render_picture(*whole, camera, settings).film.radiance);
}

// The lists of textures differ if a picture is broken; then the file is read as a whole.
TEST(LateTextures, OfABrokenPictureAreLeftOut) {
  const TemporaryFolder folder;
  const std::string path = folder.write("square.glb", large_picture().glb());
  write_large_picture(path);
  const auto picture = std::filesystem::path(path).parent_path() / "large.png";
  std::filesystem::resize_file(picture, 4096);
  Previewer previewer({{}, {}}, small_picture());
  previewer.viewpoint().set_picture_size(48, 32, 0.0);
  previewer.scene().open(path);
  const Scene whole = load_scene(path).value();
  bool done = false;
  for (int i = 0; i < 20000 && !done; ++i) {
    previewer.update(0.0);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    done = previewer.scene() && previewer.scene().textures_missing() == 0 &&
           !previewer.scene().loading();
  }
  ASSERT_TRUE(done);
  EXPECT_EQ(previewer.scene()->world().images.size(), whole.images.size());
  EXPECT_EQ(previewer.scene()->world().textures.size(), whole.textures.size());
  EXPECT_EQ(previewer.scene()->geometry->notes.warnings, whole.notes.warnings);
  EXPECT_FALSE(previewer.scene().error());
}

TEST(LateTextures, DoNotDelayGeometryThatTakesAsLong) {
  GltfBuilder b = large_picture();
  for (int i = 0; i < 8000; ++i) b.json["scenes"][0]["nodes"].push_back(i + 1);
  for (int i = 0; i < 8000; ++i) b.json["nodes"].push_back({{"mesh", 0}});
  const TemporaryFolder folder;
  const std::string path = folder.write("square.glb", b.glb());
  write_large_picture(path);
  LoadProgress progress;
  progress.allow_missing_textures();
  const LoadProgress::Scope scope(&progress);
  EXPECT_EQ(load_scene(path).value().images[0].width, 2048);
  EXPECT_EQ(progress.missing_textures(), 0u);
}

/// Counts of work for opening.
struct Counts {
  std::uint64_t files = WorkDone::of(Work::files_read);
  std::uint64_t surfaces = WorkDone::of(Work::hierarchy_surfaces);
  std::uint64_t pairs = WorkDone::of(Work::coplanar_pairs);
  std::uint64_t lookups = WorkDone::of(Work::emission_lookups);
  std::uint64_t bytes = WorkDone::of(Work::decoded_bytes);
  bool operator==(const Counts&) const = default;
};

// They read the file and built everything again.
TEST(HiddenObjects, AreHiddenWithoutReadingOrBuilding) {
  GltfBuilder b = GltfBuilder::square();
  b.json["nodes"].push_back({{"mesh", 0}, {"translation", {0.5, 0, 0}}});
  b.json["nodes"].push_back({{"mesh", 0}, {"translation", {0, 3, 1}}});
  b.json["scenes"][0]["nodes"] = {0, 1, 2};
  const TemporaryFolder folder;
  const std::string path = folder.write("squares.glb", b.glb());
  Previewer previewer({{}, {}}, small_picture());
  previewer.viewpoint().set_picture_size(48, 32, 0.0);
  const auto settled = [&] {
    for (int i = 0; i < 20000; ++i) {
      previewer.update(0.0);
      if (previewer.scene() && !previewer.scene().loading() &&
          ground_of(previewer.scene()->world()) == previewer.edits().settings().ground &&
          !previewer.render().first_picture_pending())
        return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  };
  const auto picture = [&] {
    RenderSettings settings = small_picture();
    settings.width = 24, settings.height = 16, settings.method = Method::sobol;
    return render_picture(*previewer.scene(), previewer.viewpoint().camera().camera(), settings)
        .film.radiance;
  };
  previewer.scene().open(path);
  ASSERT_TRUE(settled());
  ASSERT_NE(ground_of(previewer.scene()->world()), Ground::off);
  const auto all = picture();
  Counts before;
  previewer.scene().hide(2);
  ASSERT_TRUE(settled());
  EXPECT_EQ(Counts(), before);
  EXPECT_EQ(objects_without_ground(previewer.scene()->world()), 2u);
  const auto two = picture();
  EXPECT_NE(two, all);
  previewer.scene().show_only(0);
  ASSERT_TRUE(settled());
  EXPECT_EQ(objects_without_ground(previewer.scene()->world()), 1u);
  previewer.scene().show_without({2});
  ASSERT_TRUE(settled());
  EXPECT_EQ(picture(), two);
  EXPECT_EQ(Counts(), before);

  // A file that is read again has the same picture with the same objects hidden.
  previewer.scene().reload();
  ASSERT_TRUE(settled());
  EXPECT_GT(Counts().files, before.files);
  EXPECT_EQ(objects_without_ground(previewer.scene()->world()), 2u);
  EXPECT_EQ(picture(), two);
  before = Counts();
  previewer.scene().show_all();
  ASSERT_TRUE(settled());
  EXPECT_FALSE(previewer.scene().hides());
  EXPECT_EQ(picture(), all);
  EXPECT_EQ(Counts(), before);
}

// A scene without lights stands on a ground, which is not added to a hierarchy without it.
TEST(GroundOfScene, IsBuiltWithIt) {
  const TemporaryFolder folder;
  const std::string path = folder.write("square.glb", GltfBuilder::square().glb());
  Previewer previewer({{}, {}}, small_picture());
  previewer.viewpoint().set_picture_size(48, 32, 0.0);
  const std::uint64_t before = WorkDone::of(Work::geometries);
  previewer.scene().open(path);
  const auto settled = [&](Ground ground) {
    for (int i = 0; i < 20000; ++i) {
      previewer.update(0.0);
      if (previewer.scene() && !previewer.scene().loading() &&
          ground_of(previewer.scene()->world()) == ground &&
          !previewer.render().first_picture_pending())
        return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  };
  ASSERT_TRUE(settled(Ground::on));
  EXPECT_EQ(WorkDone::of(Work::geometries), before + 1);

  // A ground that the user chose stays, and so it does in the next scene.
  previewer.edits().settings().ground = Ground::mirror;
  ASSERT_TRUE(settled(Ground::mirror));
  EXPECT_EQ(WorkDone::of(Work::geometries), before + 2);
  previewer.scene().reload();
  previewer.update(0.0);
  ASSERT_TRUE(settled(Ground::mirror));
  EXPECT_EQ(WorkDone::of(Work::geometries), before + 3);
}

// So are those of an animation.
TEST(GroundOfScene, IsBuiltWithEachPose) {
  Previewer previewer({{}, {}}, small_picture());
  previewer.edits().keep_first({true, true, true});
  previewer.edits().settings().ground = Ground::on;
  previewer.viewpoint().set_picture_size(48, 32, 0.0);
  previewer.scene().open("builtin:turning-fence");
  const auto posed = [&](const std::optional<ClipTime>& time) {
    for (int i = 0; i < 20000; ++i) {
      previewer.update(0.0);
      if (previewer.scene() && previewer.scene()->geometry->time == time &&
          ground_of(previewer.scene()->world()) == Ground::on)
        return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  };
  ASSERT_TRUE(posed(std::nullopt));
  const std::uint64_t before = WorkDone::of(Work::geometries);
  previewer.playback().seek(2.0);
  ASSERT_TRUE(posed(ClipTime{0, 2.0}));
  EXPECT_EQ(WorkDone::of(Work::geometries), before + 1);
}

}  // namespace
}  // namespace asos::test::opening_test
