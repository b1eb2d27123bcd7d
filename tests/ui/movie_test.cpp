#include "ui/movie.h"

#include "renderer/film/image_io.h"
#include "renderer/gltf/load.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/scene/turned_camera.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

// Turntables and animations as frames, and as MP4 with a program that replaces ffmpeg.

namespace asos::test::movie_test {
using namespace ui;
namespace {

namespace fs = std::filesystem;

class MovieTest : public testing::Test {
 protected:
  MovieTest() {
    const char* path = std::getenv("PATH");
    path_before = path ? path : "";
    setenv("PATH", folder.path().c_str(), 1);
    order.snapshot.scene = prepare(two_triangles({1, 0, 0})).value();
    order.snapshot.camera = order.snapshot.scene->world().cameras.front();
    order.snapshot.settings.width = 24;
    order.snapshot.settings.height = 16;
    order.snapshot.settings.threads = 1;
    order.snapshot.progressive = false;
    order.stem = folder.file("turn");
    order.frames = 3;
  }
  ~MovieTest() override { setenv("PATH", path_before.c_str(), 1); }

  void install_ffmpeg(const std::string& script) {
    folder.write("ffmpeg", "#!/bin/sh\n" + script);
    fs::permissions(folder.file("ffmpeg"), fs::perms::owner_all);
  }
  [[nodiscard]] std::optional<Result<std::string>> write() {
    return write_movie(order, std::stop_source().get_token(),
                       [&](double fraction) { told.push_back(fraction); });
  }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
  }

  TemporaryFolder folder;
  std::string path_before;
  MovieOrder order;
  std::vector<double> told;
};

TEST_F(MovieTest, ATurntableIsRenderedFrameByFrame) {
  const auto written = write();
  ASSERT_TRUE(written && *written);
  EXPECT_EQ(**written, folder.file("turn-0000.png") + " to 0002.png");
  EXPECT_EQ(files(), 3u);
  for (int number = 0; number < 3; ++number) {
    Snapshot snapshot = order.snapshot;
    snapshot.camera = turned_camera(snapshot.camera, glm::dvec3(0.0), number, 3);
    const Film film = render_to_end(snapshot).film;
    const RgbImage frame =
        read_png(folder.file("turn-000" + std::to_string(number) + ".png")).value();
    ASSERT_EQ(frame.rgb.size(), 3 * film.radiance.size());
    for (std::size_t i = 0; i < film.radiance.size(); ++i)
      ASSERT_EQ(glm::u8vec3(frame.rgb[3 * i], frame.rgb[3 * i + 1], frame.rgb[3 * i + 2]),
                display_bytes(film, i, order.display))
          << number << ", " << i;
  }
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_DOUBLE_EQ(told.back(), 1.0);
}

TEST_F(MovieTest, AStoppedMovieLeavesNoFile) {
  order.frames = 1000;
  std::stop_source stop;
  const auto written = write_movie(order, stop.get_token(), [&](double fraction) {
    if (fraction > 0.002) stop.request_stop();
  });
  EXPECT_FALSE(written.has_value());
  EXPECT_EQ(files(), 0u);
}

TEST_F(MovieTest, FfmpegJoinsTheFrames) {
  order.mp4 = true;
  order.fps = 12.5;
  install_ffmpeg("printf '%s\\n' \"$@\" > " + folder.file("arguments") +
                 "\nfor last; do :; done\nprintf video > \"$last\"\n");
  const auto written = write();
  ASSERT_TRUE(written && *written) << (*written).error().message();
  EXPECT_EQ(**written, folder.file("turn.mp4"));
  EXPECT_EQ(content_of(folder.file("turn.mp4")), "video");
  EXPECT_EQ(files(), 3u) << "ffmpeg, its arguments, and the video";
  const std::string arguments = content_of(folder.file("arguments"));
  EXPECT_NE(arguments.find("-framerate\n12.5\n-i\n"), std::string::npos) << arguments;
  EXPECT_NE(arguments.find("/%06d.png\n"), std::string::npos) << arguments;
}

TEST_F(MovieTest, SaysWhyFfmpegFailedAndKeepsTheFrames) {
  order.mp4 = true;
  install_ffmpeg("echo Unknown encoder >&2\nexit 1\n");
  const auto written = write();
  ASSERT_TRUE(written.has_value());
  ASSERT_FALSE(written->has_value());
  const std::string message = written->error().message();
  EXPECT_TRUE(message.starts_with("ffmpeg: ended with code 1: Unknown encoder; the frames are in " +
                                  folder.file("turn-frames-")))
      << message;
  const std::string frames = message.substr(message.find(folder.path().string()));
  EXPECT_TRUE(fs::exists(frames + "/000002.png"));
  EXPECT_FALSE(fs::exists(folder.file("turn.mp4")));
}

TEST_F(MovieTest, SaysWhereNoFrameCanBeWritten) {
  order.stem = folder.file("missing/turn");
  const auto written = write();
  ASSERT_TRUE(written.has_value());
  ASSERT_FALSE(written->has_value());
  EXPECT_TRUE(written->error().message().starts_with(folder.file("missing/turn-0000.png")))
      << written->error().message();
}

TEST(MovieLength, CountsTheFirstAndTheLastFrame) {
  EXPECT_EQ(frames_of(1.0, 24.0), 25);
  EXPECT_EQ(frames_of(0.0, 24.0), 1);
  EXPECT_EQ(frames_of(0.99, 10.0), 10);
}

class MovieDialogTest : public PanelsTest {
 protected:
  MovieDialogTest() {
    setenv("XDG_PICTURES_DIR", folder.path().c_str(), 1);
    path_before = std::getenv("PATH");
    setenv("PATH", folder.path().c_str(), 1);
  }
  ~MovieDialogTest() override {
    setenv("PATH", path_before.c_str(), 1);
    unsetenv("XDG_PICTURES_DIR");
  }
  [[nodiscard]] bool has(const char* control) { return rig.controls().contains(control); }
  void frames(int count) {
    for (int i = 0; i < count; ++i) rig.frame();
  }
  TemporaryFolder folder;
  std::string path_before;
};

TEST_F(MovieDialogTest, OffersMp4OnlyWithFfmpeg) {
  rig.chord(Key::ctrl, Key::s);
  frames(3);
  EXPECT_FALSE(has("Content/Clip")) << "nothing moves in this scene";
  rig.click("Content/Turntable");
  frames(2);
  EXPECT_FALSE(has("Movie format/MP4"));
  const auto& all = rig.controls();
  ASSERT_TRUE(has("Movie format"));
  EXPECT_NE(all.at("Movie format").words.find("needs ffmpeg"), std::string::npos);
  folder.write("ffmpeg", "#!/bin/sh\n");
  fs::permissions(folder.file("ffmpeg"), fs::perms::owner_all);
  frames(2);
  EXPECT_TRUE(has("Movie format/MP4"));
  EXPECT_FALSE(has("Movie format"));
}

TEST_F(MovieDialogTest, SavesTheFramesOfATurn) {
  rig.chord(Key::ctrl, Key::s);
  frames(3);
  SaveChoice& choice = rig.state().save;
  choice.what = SaveChoice::What::turntable;
  choice.frames = 2;
  choice.size = {16, 12};
  frames(2);
  rig.click("Save");
  ASSERT_TRUE(rig.frames_until([&] { return rig.state().message.starts_with("Saved "); }, 20.0))
      << rig.state().message;
  EXPECT_TRUE(fs::exists(folder.file("scene-001-0000.png")));
  EXPECT_TRUE(fs::exists(folder.file("scene-001-0001.png")));
}

// The first and the last frame of an animated scene differ.
TEST(MovieOfAClip, ShowsTheAnimation) {
  const TemporaryFolder folder;
  MovieOrder order;
  const Result<Scene> scene = load_scene("builtin:turning-fence", {.keep_posable = true});
  ASSERT_TRUE(scene && scene->rig);
  order.snapshot.scene = prepare(*scene).value();
  order.snapshot.camera = order.snapshot.scene->world().cameras.front();
  order.snapshot.settings.width = 32;
  order.snapshot.settings.height = 20;
  order.snapshot.settings.threads = 1;
  order.snapshot.progressive = false;
  order.stem = folder.file("clip");
  order.animation = 0;
  order.fps = 1.0;
  order.frames = 2;
  const auto written = write_movie(order, std::stop_source().get_token(), [](double) {});
  ASSERT_TRUE(written && *written);
  EXPECT_NE(read_png(folder.file("clip-0000.png"))->rgb,
            read_png(folder.file("clip-0001.png"))->rgb);
}

}  // namespace
}  // namespace asos::test::movie_test
