#include "asos/session.h"

#include "tests/renderer/api/api_scenes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace asos::api {
namespace {

using std::chrono::milliseconds;
constexpr milliseconds patience{60'000};

constexpr int width = 24, height = 16;

std::vector<float> beauty_of(const Picture& picture) {
  return picture.layer("beauty")->values;
}

std::vector<float> rendered(const Scene& scene) {
  const Result<Picture> picture =
      render(scene, scene.default_camera(1.5), test::small_settings(width, height));
  return picture ? beauty_of(*picture) : std::vector<float>{};
}

Light lamp_of(float candela) {
  Light lamp;
  lamp.name = "lamp";
  lamp.position = {999, 2, 2};
  lamp.intensity = candela;
  return lamp;
}

/// Takes tiles until the render ends; returns false if none arrives within a minute.
bool follow(Session& session, std::vector<float>& rgb) {
  for (;;) {
    if (!session.wait(patience)) return false;
    const bool finished = session.progress().finished;
    if (!session.take_tiles(rgb)) return false;
    if (finished) return true;
  }
}

TEST(ApiSession, FillsBufferWithPicture) {
  const Result<Scene> ball = test::lit_ball();
  ASSERT_TRUE(ball);
  std::atomic<int> calls{0};
  Session session([&] { ++calls; });
  std::vector<float> rgb(3 * width * height, -1.0f);
  ASSERT_TRUE(session.start(*ball, ball->default_camera(1.5), test::small_settings(width, height)));
  ASSERT_TRUE(follow(session, rgb));
  EXPECT_EQ(rgb, rendered(*ball));
  EXPECT_GT(calls, 0);
  EXPECT_TRUE(session.take_tiles(rgb)->empty());
  const Result<Picture> picture = session.picture();
  ASSERT_TRUE(picture);
  EXPECT_TRUE(picture->finished());
  EXPECT_EQ(beauty_of(*picture), rgb);
}

TEST(ApiSession, PictureTakesNoTileFromBuffer) {
  const Result<Scene> ball = test::lit_ball();
  ASSERT_TRUE(ball);
  Session session;
  ASSERT_TRUE(session.start(*ball, ball->default_camera(1.5), test::small_settings(width, height)));
  while (!session.progress().finished) {
    ASSERT_TRUE(session.wait(patience));
    ASSERT_TRUE(session.picture());
  }
  std::vector<float> rgb(3 * width * height, -1.0f);
  ASSERT_TRUE(session.take_tiles(rgb));
  EXPECT_EQ(rgb, rendered(*ball));
}

TEST(ApiSession, Relights) {
  const Result<Scene> ball = test::lit_ball();
  ASSERT_TRUE(ball);
  const Light lamp = lamp_of(9000.0f);
  Session session;
  EXPECT_EQ(session.relight({&lamp, 1}).error().code, ErrorCode::invalid_argument);
  ASSERT_TRUE(session.start(*ball, ball->default_camera(1.5), test::small_settings(width, height)));
  ASSERT_TRUE(session.relight({&lamp, 1}));
  std::vector<float> rgb(3 * width * height);
  ASSERT_TRUE(follow(session, rgb));
  EXPECT_EQ(rgb, rendered(*ball->with_lights({&lamp, 1})));
  EXPECT_NE(rgb, rendered(*ball));
}

TEST(ApiSession, KeepsRenderWhenStartFails) {
  const Result<Scene> ball = test::lit_ball();
  ASSERT_TRUE(ball);
  Session session;
  EXPECT_EQ(session.picture().error().subject, "session");
  ASSERT_TRUE(session.start(*ball, ball->default_camera(1.5), test::small_settings(width, height)));
  Settings wrong = test::small_settings(width, height);
  wrong.max_level = 99;
  EXPECT_EQ(session.start(*ball, ball->default_camera(1.5), wrong).error().subject, "max");
  std::vector<float> rgb(5);
  EXPECT_EQ(session.take_tiles(rgb).error().subject, "buffer");
  rgb.resize(3 * width * height);
  ASSERT_TRUE(follow(session, rgb));
  EXPECT_EQ(rgb, rendered(*ball));
}

TEST(ApiSession, WaitEndsOnCancel) {
  const Result<Scene> ball = test::lit_ball();
  ASSERT_TRUE(ball);
  Session session;
  session.pause();
  ASSERT_TRUE(session.start(*ball, ball->default_camera(1.5), test::small_settings(width, height)));
  session.cancel();
  EXPECT_TRUE(session.wait(patience));
  EXPECT_FALSE(session.progress().finished);
  session.resume();
}

// Calls all functions of a session, in an order that depends on `first`.
void use(Session& session, const Scene& scene, const std::string& file, int first) {
  const Settings settings = test::small_settings(width, height);
  std::vector<float> rgb(3 * width * height);
  for (int i = first; i < first + 16; ++i) {
    const Light lamp = lamp_of(static_cast<float>(1000 * i));
    switch (i % 8) {
      case 0:
        EXPECT_TRUE(session.start(scene, scene.default_camera(1.5), settings));
        break;
      case 1:
        EXPECT_TRUE(session.take_tiles(rgb));
        break;
      case 2:
        EXPECT_TRUE(session.relight({&lamp, 1}));
        break;
      case 3:
        EXPECT_TRUE(session.picture()->save(file));
        break;
      case 4:
        session.pause(), session.resume();
        break;
      case 5:
        EXPECT_GE(session.progress().fraction, 0.0);
        break;
      case 6:
        EXPECT_TRUE(trace_pixel(scene, scene.default_camera(1.5), settings, i, 8));
        break;
      default:
        session.cancel();
    }
  }
}

TEST(ApiThreads, ShareTwoSessions) {
  const asos::test::TemporaryFolder folder;
  const Result<Scene> ball = test::lit_ball();
  ASSERT_TRUE(ball);
  const Camera camera = ball->default_camera(1.5);
  const Settings settings = test::small_settings(width, height);
  std::array<Session, 2> sessions;
  for (Session& session : sessions) ASSERT_TRUE(session.start(*ball, camera, settings));
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 8; ++i)
      threads.emplace_back([&, i] {
        const std::string name = std::to_string(i) + (i % 3 ? ".png" : ".exr");
        use(sessions[static_cast<std::size_t>(i % 2)], *ball, folder.file(name), i);
      });
  }
  const std::vector<float> expected = rendered(*ball);
  for (Session& session : sessions) {
    std::vector<float> rgb(3 * width * height, -1.0f);
    ASSERT_TRUE(session.start(*ball, camera, settings));
    ASSERT_TRUE(follow(session, rgb));
    EXPECT_EQ(rgb, expected);
  }
}

}  // namespace
}  // namespace asos::api
