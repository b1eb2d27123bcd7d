#include "renderer/comparison/method.h"
#include "renderer/film/image_io.h"
#include "renderer/gltf/load.h"
#include "renderer/picture/picture_description.h"
#include "renderer/session/film_render.h"
#include "tests/renderer/api/api_scenes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <stdexcept>
#include <vector>

namespace asos::api {
namespace {

template <typename T>
void expect_error(const Result<T>& result, ErrorCode code, const std::string& subject) {
  ASSERT_FALSE(result.has_value()) << subject;
  EXPECT_EQ(result.error().code, code) << result.error().message();
  EXPECT_EQ(result.error().subject, subject) << result.error().message();
}

std::vector<float> layer_of(const Picture& picture, const std::string& name) {
  const Result<Layer> layer = picture.layer(name);
  EXPECT_TRUE(layer) << name;
  return layer ? layer->values : std::vector<float>{};
}

// The square covers x from -1 to -1/4 and y from -1/2 to 1/4; a pixel is 1 unit wide.
TEST(ApiRender, GivesExactCoverage) {
  const Result<Scene> square = test::white_square(-0.625f, -0.125f, 0.75f);
  ASSERT_TRUE(square) << square.error().message();
  Settings settings = test::small_settings(2, 2);
  settings.background = Background::transparent;
  const Result<Picture> picture = render(*square, test::flat_camera(), settings);
  ASSERT_TRUE(picture) << picture.error().message();
  const std::vector<float> alpha = layer_of(*picture, "alpha");
  ASSERT_EQ(alpha.size(), 4u);
  EXPECT_NEAR(alpha[0], 0.75 * 0.25, 1e-6);
  EXPECT_NEAR(alpha[2], 0.75 * 0.5, 1e-6);
  EXPECT_EQ(alpha[1], 0.0f);
  EXPECT_EQ(alpha[3], 0.0f);
}

TEST(ApiRender, GivesBitsOfCommandLine) {
  const asos::Result<asos::Scene> scene = load_scene("builtin:boxes");
  ASSERT_TRUE(scene);
  const auto prepared = prepare(*scene);
  ASSERT_TRUE(prepared);
  RenderSettings of_renderer{.width = 48, .height = 32, .asos = {.max_level = 2}};
  of_renderer = judged_by(of_renderer, ToneCurve::neutral);
  const asos::Camera& seen = (*prepared)->world().cameras.front();
  const Film film = render_to_end({*prepared, seen, of_renderer, false}).film;

  const Result<Scene> boxes = Scene::load("builtin:boxes");
  ASSERT_TRUE(boxes);
  const Result<Picture> picture =
      render(*boxes, boxes->cameras().front(), test::small_settings(48, 32));
  ASSERT_TRUE(picture) << picture.error().message();
  const std::vector<float> beauty = layer_of(*picture, "beauty");
  ASSERT_EQ(beauty.size(), 3 * film.radiance.size());
  for (std::size_t i = 0; i < beauty.size(); ++i)
    ASSERT_EQ(beauty[i], film.radiance[i / 3][static_cast<int>(i % 3)]) << i;
}

TEST(ApiRender, CropEqualsPartOfPicture) {
  const Result<Scene> ball = test::lit_ball();
  ASSERT_TRUE(ball);
  Settings settings = test::small_settings(24, 16);
  const Result<Picture> whole = render(*ball, ball->default_camera(1.5), settings);
  settings.crop = Rect{5, 3, 10, 9};
  const Result<Picture> part = render(*ball, ball->default_camera(1.5), settings);
  ASSERT_TRUE(whole && part);
  ASSERT_EQ(part->width(), 10);
  ASSERT_EQ(part->height(), 9);
  const std::vector<float> all = layer_of(*whole, "beauty"), cut = layer_of(*part, "beauty");
  for (std::size_t y = 0; y < 9; ++y)
    for (std::size_t x = 0; x < 30; ++x)
      ASSERT_EQ(cut[30 * y + x], all[72 * (y + 3) + 15 + x]) << x << " " << y;
}

TEST(ApiRender, ReportsProgressOnCallingThread) {
  const Result<Scene> ball = test::lit_ball();
  ASSERT_TRUE(ball);
  std::vector<Progress> reports;
  RenderOptions options;
  const auto here = std::this_thread::get_id();
  options.on_progress = [&](const Progress& progress) {
    EXPECT_EQ(std::this_thread::get_id(), here);
    reports.push_back(progress);
  };
  const Result<Picture> picture =
      render(*ball, ball->default_camera(1.0), test::small_settings(16, 16), options);
  ASSERT_TRUE(picture);
  ASSERT_FALSE(reports.empty());
  EXPECT_TRUE(reports.back().finished);
  EXPECT_EQ(reports.back().fraction, 1.0);
  EXPECT_TRUE(picture->finished());
  EXPECT_GT(picture->rays(), 0u);
}

TEST(ApiRender, StopsOnRequest) {
  const Result<Scene> ball = test::lit_ball();
  ASSERT_TRUE(ball);
  std::stop_source source;
  source.request_stop();
  RenderOptions options;
  options.stop = source.get_token();
  expect_error(render(*ball, ball->default_camera(1.0), test::small_settings(512, 512), options),
               ErrorCode::cancelled, "render");
}

TEST(ApiRender, ReturnsExceptionOfCallback) {
  const Result<Scene> ball = test::lit_ball();
  ASSERT_TRUE(ball);
  RenderOptions options;
  options.on_progress = [](const Progress&) { throw std::runtime_error("full"); };
  const Result<Picture> picture =
      render(*ball, ball->default_camera(1.0), test::small_settings(8, 8), options);
  expect_error(picture, ErrorCode::internal, "render");
  EXPECT_EQ(picture.error().reason, "full");
}

TEST(ApiRender, NamesWrongSetting) {
  const Result<Scene> ball = test::lit_ball();
  ASSERT_TRUE(ball);
  const Camera camera = ball->default_camera(1.0);
  const Settings good = test::small_settings(8, 8);
  const auto refused = [&](const Settings& settings, const std::string& subject,
                           ErrorCode code = ErrorCode::invalid_argument) {
    expect_error(render(*ball, camera, settings), code, subject);
  };
  Settings s = good;
  s.width = 0;
  refused(s, "width");
  s = good, s.eps = std::numeric_limits<double>::quiet_NaN();
  refused(s, "eps");
  s = good, s.method = "magic";
  refused(s, "method");
  s = good, s.crop = Rect{4, 4, 5, 1};
  refused(s, "crop");
  s = good, s.crop = Rect{1, 1, std::numeric_limits<int>::max(), 1};
  refused(s, "crop");
  s = good, s.tone = static_cast<Tone>(9);
  refused(s, "tone");
  s = good, s.ground = static_cast<Ground>(9);
  refused(s, "ground");
  s = good, s.background = static_cast<Background>(9);
  refused(s, "background");
  s = good, s.sky_brightness = -1;
  refused(s, "sky_brightness");
  s = good, s.sky = "/no/such/sky.hdr";
  refused(s, "/no/such/sky.hdr", ErrorCode::cannot_open);
  RenderOptions options;
  options.time_limit_seconds = std::numeric_limits<double>::quiet_NaN();
  expect_error(render(*ball, camera, good, options), ErrorCode::invalid_argument,
               "time_limit_seconds");
  expect_error(render(*ball, look_at({0, 0, 0}, {0, 0, 0}), good), ErrorCode::invalid_argument,
               "camera 'look-at'");
}

TEST(ApiRender, RefusesShapesByMethodOfTriangles) {
  const Result<Scene> ball = test::lit_ball();
  ASSERT_TRUE(ball);
  Settings settings = test::small_settings(8, 8);
  settings.method = "beam";
  const Result<Picture> picture = render(*ball, ball->default_camera(1.0), settings);
  ASSERT_FALSE(picture);
  EXPECT_EQ(picture.error().code, ErrorCode::unsupported);
  Session session;
  const Result<void> started = session.start(*ball, ball->default_camera(1.0), settings);
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().message(), picture.error().message());
}

TEST(ApiRender, RendersByEveryMethodName) {
  const std::vector<std::string> names = method_names();
  ASSERT_FALSE(names.empty());
  EXPECT_EQ(names.front(), "asos");
  const Result<Scene> square = test::white_square(0, 0, 1);
  ASSERT_TRUE(square);
  for (const std::string& name : names) {
    Settings settings = test::small_settings(8, 8);
    settings.method = name;
    const Result<Picture> picture = render(*square, test::flat_camera(), settings);
    ASSERT_TRUE(picture) << name << ": " << picture.error().message();
    EXPECT_EQ(layer_of(*picture, "beauty")[3 * (8 * 4 + 4)], 1.0f) << name;
  }
}

TEST(ApiLights, AddLinearly) {
  const Result<Scene> ball = test::lit_ball();
  ASSERT_TRUE(ball);
  std::vector<std::vector<float>> beauty;
  for (const float candela : {0.0f, 2000.0f, 4000.0f}) {
    const Light lamp = test::ball_lamp(candela);
    const Result<Scene> relit = ball->with_lights({&lamp, 1});
    ASSERT_TRUE(relit) << relit.error().message();
    Settings settings = test::small_settings(12, 8);
    settings.max_level = 0;
    const Result<Picture> picture = render(*relit, relit->default_camera(1.5), settings);
    ASSERT_TRUE(picture);
    beauty.push_back(layer_of(*picture, "beauty"));
  }
  double brightest = 0.0;
  for (std::size_t i = 0; i < beauty[0].size(); ++i) {
    const double once = beauty[1][i] - beauty[0][i];
    brightest = std::max(brightest, once);
    EXPECT_NEAR(beauty[2][i] - beauty[0][i], 2.0 * once, 1e-4 * (1.0 + once)) << i;
  }
  EXPECT_GT(brightest, 1.0);
}

// The picture equals that of a scene built with the lights.
TEST(ApiLights, ReplaceDefaultLighting) {
  const Result<Scene> lit = test::lit_ball(), unlit = test::lit_ball(false);
  ASSERT_TRUE(lit && unlit);
  const Light lamp = test::ball_lamp();
  const Result<Scene> relit = unlit->with_lights({&lamp, 1});
  ASSERT_TRUE(relit);
  Settings settings = test::small_settings(12, 8);
  settings.sky.clear();
  settings.ground = Ground::automatic;
  settings.background = Background::automatic;
  std::vector<std::vector<float>> beauty;
  for (const Scene& scene : {*lit, *unlit, *relit}) {
    const Result<Picture> picture = render(scene, scene.default_camera(1.5), settings);
    ASSERT_TRUE(picture) << picture.error().message();
    beauty.push_back(layer_of(*picture, "beauty"));
  }
  EXPECT_EQ(beauty[2], beauty[0]);
  EXPECT_NE(beauty[1], beauty[0]);
}

TEST(ApiLights, RefusesLightWithoutSize) {
  const Result<Scene> ball = test::lit_ball();
  ASSERT_TRUE(ball);
  Light flat{.name = "panel", .type = LightType::rectangle};
  expect_error(ball->with_lights({&flat, 1}), ErrorCode::invalid_argument, "light 'panel'");
}

TEST(ApiPicture, ListsLayers) {
  const Result<Scene> square = test::white_square(0, 0, 1);
  ASSERT_TRUE(square);
  const Result<Picture> picture = render(*square, test::flat_camera(), test::small_settings(6, 6));
  ASSERT_TRUE(picture);
  std::vector<std::string> names;
  for (const LayerInfo& info : picture->layers()) {
    const Result<Layer> layer = picture->layer(info.name);
    ASSERT_TRUE(layer) << info.name;
    EXPECT_EQ(layer->values.size(), 36u * static_cast<unsigned>(info.channels)) << info.name;
    EXPECT_FALSE(info.unit.empty());
    names.push_back(info.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"beauty", "level", "cause", "rays", "time"}));
  expect_error(picture->layer("alpha"), ErrorCode::invalid_argument, "layer 'alpha'");
  // The square's corner lies in pixel (1, 1), whose pyray is split along the outline.
  const std::vector<float> causes = layer_of(*picture, "cause");
  EXPECT_EQ(cause_name(static_cast<int>(causes[6 + 1])), "outline");
  EXPECT_EQ(cause_name(static_cast<int>(causes[0])), "none");
  EXPECT_EQ(cause_name(-1) + cause_name(99), "");
}

TEST(ApiPicture, SavesWhatLayersHold) {
  const asos::test::TemporaryFolder folder;
  const auto file = [&](const char* name) { return folder.file(name); };
  const Result<Scene> ball = test::lit_ball();
  ASSERT_TRUE(ball);
  const Result<Picture> picture =
      render(*ball, ball->default_camera(1.5), test::small_settings(12, 8));
  ASSERT_TRUE(picture);
  ASSERT_TRUE(picture->save(file("ball.exr")));
  ASSERT_TRUE(picture->save(file("ball.png"), {1.0f}));
  const auto exr = read_exr(file("ball.exr"));
  ASSERT_TRUE(exr);
  const std::vector<float> beauty = layer_of(*picture, "beauty");
  for (std::size_t i = 0; i < beauty.size(); ++i)
    ASSERT_EQ(exr->film.radiance[i / 3][static_cast<int>(i % 3)], beauty[i]);
  const auto png = read_png(file("ball.png"));
  ASSERT_TRUE(png);
  EXPECT_EQ(png->width, 12);
  EXPECT_EQ(png->height, 8);
  EXPECT_FALSE(read_description(file("ball.png"))) << "no file has this scene";

  expect_error(picture->save(file("ball.jpg")), ErrorCode::invalid_argument, file("ball.jpg"));
  const std::string nowhere = file("no/ball.png");
  const Result<void> failed = picture->save(nowhere);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, ErrorCode::cannot_write);
  EXPECT_NE(failed.error().message().find(nowhere), std::string::npos);
  expect_error(picture->save(file("ball.png"), {std::numeric_limits<float>::quiet_NaN()}),
               ErrorCode::invalid_argument, "exposure_ev");
}

TEST(ApiPicture, DescribesSceneOfFile) {
  const asos::test::TemporaryFolder folder;
  const std::string path = folder.file("boxes.png");
  const Result<Scene> boxes = Scene::load("builtin:boxes");
  ASSERT_TRUE(boxes);
  const Result<Picture> picture =
      render(*boxes, boxes->default_camera(1.0), test::small_settings(8, 8));
  ASSERT_TRUE(picture);
  ASSERT_TRUE(picture->save(path));
  const auto description = read_description(path);
  ASSERT_TRUE(description) << description.error().message();
  EXPECT_EQ(description->scene, "builtin:boxes");
  EXPECT_EQ(description->settings.width, 8);
}

TEST(ApiTrace, EqualsPixelOfPicture) {
  const Result<Scene> square = test::white_square(0, 0, 1);
  ASSERT_TRUE(square);
  const Settings settings = test::small_settings(6, 6);
  const Result<PixelTrace> trace = trace_pixel(*square, test::flat_camera(), settings, 1, 1);
  ASSERT_TRUE(trace) << trace.error().message();
  const Result<Picture> picture = render(*square, test::flat_camera(), settings);
  ASSERT_TRUE(picture);
  const std::vector<float> beauty = layer_of(*picture, "beauty");
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(trace->radiance[c], beauty[3 * (6 + 1) + c]);
  EXPECT_EQ(trace->cause, "outline");
  EXPECT_EQ(static_cast<float>(trace->level), layer_of(*picture, "level")[6 + 1]);
  double area = 0.0;
  std::size_t edges = 0;
  for (const TracedCell& cell : trace->cells) {
    edges += cell.edges.size();
    for (const TracedSample& sample : cell.samples) area += sample.weight;
  }
  EXPECT_NEAR(area, 1.0, 1e-6);
  EXPECT_GE(edges, 2u);
}

TEST(ApiTrace, RefusesPixelOutside) {
  const Result<Scene> square = test::white_square(0, 0, 1);
  ASSERT_TRUE(square);
  Settings settings = test::small_settings(6, 6);
  expect_error(trace_pixel(*square, test::flat_camera(), settings, 6, 0),
               ErrorCode::invalid_argument, "pixel");
  expect_error(trace_pixel(*square, test::flat_camera(), settings, 0, -1),
               ErrorCode::invalid_argument, "pixel");
  settings.method = "sobol";
  expect_error(trace_pixel(*square, test::flat_camera(), settings, 0, 0),
               ErrorCode::invalid_argument, "method");
}

}  // namespace
}  // namespace asos::api
