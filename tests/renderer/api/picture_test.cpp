#include "renderer/film/image_io.h"
#include "renderer/picture/picture_description.h"
#include "tests/renderer/api/api_scenes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace asos::api {
namespace {

template <typename T>
T value_of(Result<T> result) {
  EXPECT_TRUE(result.has_value()) << (result ? "" : result.error().message());
  return result ? std::move(*result) : T(std::move(result).value());
}

template <typename T>
void expect_refused(const Result<T>& result, const std::string& subject) {
  ASSERT_FALSE(result.has_value()) << subject;
  EXPECT_EQ(result.error().code, ErrorCode::invalid_argument) << result.error().message();
  EXPECT_EQ(result.error().subject, subject) << result.error().message();
}

// The square covers x from -1/2 to 1/2 and y from -1/2 to 1/2; a pixel is 1/3 unit wide.
Picture picture_of_square(const std::vector<std::string>& layers) {
  Settings settings = test::small_settings(6, 6);
  settings.layers = layers;
  return value_of(render(value_of(test::white_square(0, 0, 1)), test::flat_camera(), settings));
}

TEST(ApiLayers, AllThatAreListedCanBeAskedFor) {
  std::vector<std::string> names;
  for (const LayerInfo& info : layer_list()) names.push_back(info.name);
  EXPECT_EQ(names.size(), 21u);
  const Picture picture = picture_of_square(names);
  ASSERT_EQ(picture.layers().size(), names.size());
  for (const LayerInfo& info : picture.layers()) {
    const Layer layer = value_of(picture.layer(info.name));
    EXPECT_EQ(layer.values.size(), 36u * static_cast<unsigned>(info.channels)) << info.name;
    EXPECT_FALSE(info.about.empty()) << info.name;
    const Result<LayerView> view = picture.view(info.name);
    const bool floats = !info.ids && info.name != "level" && info.name != "cause";
    ASSERT_EQ(view.has_value(), floats) << info.name;
    if (view) {
      EXPECT_TRUE(std::equal(view->values.begin(), view->values.end(), layer.values.begin(),
                             layer.values.end()));
    }
  }
}

TEST(ApiLayers, HoldDepthsAndShares) {
  const Picture picture = picture_of_square({"depth", "object"});
  const Layer depth = value_of(picture.layer("depth"));
  EXPECT_FLOAT_EQ(depth.values[6 * 2 + 2], 5.0f);
  EXPECT_EQ(depth.values[0], std::numeric_limits<float>::infinity());
  const Layer object = value_of(picture.layer("object"));
  EXPECT_EQ(object.values[0], -1.0f);
  EXPECT_EQ(object.values[6 * 2 + 2], 0.0f);
  EXPECT_EQ(value_of(picture.id_names("object")), std::vector<std::string>{"square"});
  // The square's corner covers a quarter of the pixel (1, 1).
  double square = 0.0, rest = 0.0;
  for (const IdShare& share : value_of(picture.id_shares("object")))
    if (share.pixel == 6 + 1) (share.id == 0 ? square : rest) += share.share;
  EXPECT_NEAR(square, 0.25, 1e-5);
  EXPECT_NEAR(rest, 0.75, 1e-5);
  expect_refused(picture.id_shares("depth"), "layer 'depth'");
  expect_refused(picture.id_names("material"), "layer 'material'");
}

TEST(ApiLayers, AreWrittenIntoExr) {
  const asos::test::TemporaryFolder folder;
  const std::string path = folder.path() / "square.exr";
  ASSERT_TRUE(picture_of_square({"depth"}).save(path));
  const auto size = std::filesystem::file_size(path);
  ASSERT_TRUE(picture_of_square({}).save(path));
  EXPECT_GT(size, std::filesystem::file_size(path) + 50);
}

TEST(ApiPrediction, FollowsEpsAndMax) {
  const Scene boxes = value_of(Scene::load("builtin:boxes"));
  const Settings settings = test::small_settings(48, 27);
  const Picture picture = value_of(render(boxes, boxes.default_camera(16.0 / 9.0), settings));
  const std::vector<float> level = value_of(picture.layer("level")).values;
  const auto predicted = [&](double eps, int max) {
    return value_of(picture.predicted_level(eps, max)).values;
  };
  std::size_t split = 0, kept = 0;
  const std::vector<float> same = predicted(settings.eps, settings.max_level);
  for (std::size_t i = 0; i < level.size(); ++i) {
    split += level[i] > 0;
    kept += level[i] > 0 && same[i] > 0;
  }
  EXPECT_GT(split, 20u);
  EXPECT_GT(kept, 0u);
  // A larger EPS splits no pixel deeper, and MAX bounds all levels.
  std::vector<float> before = same;
  for (const double eps : {1.0 / 64, 1.0 / 8, 1.0}) {
    const std::vector<float> now = predicted(eps, settings.max_level);
    for (std::size_t i = 0; i < now.size(); ++i) ASSERT_LE(now[i], before[i]) << eps << " " << i;
    before = now;
  }
  for (const int max : {0, 1})
    for (const float value : predicted(settings.eps, max)) ASSERT_LE(value, max);
  EXPECT_NE(predicted(settings.eps, 1), predicted(settings.eps, 0));
  EXPECT_NE(predicted(1.0, settings.max_level), same);
  expect_refused(picture.predicted_level(2.0, 4), "eps");
  expect_refused(picture.predicted_level(0.5, 9), "max");
}

TEST(ApiCompare, GivesTheErrorOfAnEdge) {
  // One pixel of 36 shows a quarter of the square: a sample at its centre misses it.
  const Scene square = value_of(test::white_square(0, 0, 1));
  Settings settings = test::small_settings(6, 6);
  const Picture exact = value_of(render(square, test::flat_camera(), settings));
  settings.method = "uniform";
  settings.samples = 1;
  const Picture sampled = value_of(render(square, test::flat_camera(), settings));
  const Difference none = value_of(compare(exact, exact));
  EXPECT_EQ(none.rmse, 0.0);
  EXPECT_TRUE(std::isinf(none.psnr_db));
  const Difference some = value_of(compare(sampled, exact));
  EXPECT_GT(some.rmse, 0.01);
  EXPECT_NEAR(some.psnr_db, -20.0 * std::log10(some.rmse), 1e-9);
  EXPECT_GE(some.worst, some.p99);
  settings.width = 5;
  const Picture narrow = value_of(render(square, test::flat_camera(), settings));
  expect_refused(compare(narrow, exact), "pictures");
}

TEST(ApiSettings, TakeWhatIsListed) {
  for (const SettingInfo& info : setting_list()) {
    EXPECT_FALSE(info.about.empty()) << info.name;
    if (info.name == "dfr" || info.name == "shutter_seconds") continue;
    Settings settings = test::small_settings(4, 4);
    settings.more[info.name] = info.name == "width" || info.name == "height" ? "4" : info.usual;
    EXPECT_TRUE(render(value_of(test::white_square(0, 0, 1)), test::flat_camera(), settings))
        << info.name;
    settings.more[info.name] = "nonsense";
    expect_refused(render(value_of(test::white_square(0, 0, 1)), test::flat_camera(), settings),
                   info.name);
  }
  Settings settings = test::small_settings(4, 4);
  settings.more["nothing"] = "1";
  expect_refused(render(value_of(test::white_square(0, 0, 1)), test::flat_camera(), settings),
                 "nothing");
}

// A box filter 2 pixels wide gives the pixel beside the square a part of its light.
TEST(ApiSettings, ReachTheRenderer) {
  const Scene square = value_of(test::white_square(0, 0, 2.0f / 3.0f));
  Settings settings = test::small_settings(6, 6);
  settings.background = Background::transparent;
  settings.more = {{"filter_width", "2"}};
  const Picture picture = value_of(render(square, test::flat_camera(), settings));
  const std::vector<float> alpha = value_of(picture.layer("alpha")).values;
  EXPECT_NEAR(alpha[6 * 2 + 2], 0.75 * 0.75, 1e-5);
  EXPECT_NEAR(alpha[6 * 2 + 1], 0.25 * 0.75, 1e-5);
}

TEST(ApiSettings, TakeSkiesOfTheCommandLine) {
  const Scene ball = value_of(value_of(test::lit_ball(false)).with_lights({}));
  Settings settings = test::small_settings(8, 8);
  const Camera camera = ball.default_camera(1.0);
  settings.sky = "1,0,0:0,0,1";
  const Picture picture = value_of(render(ball, camera, settings));
  const std::vector<float> beauty = value_of(picture.layer("beauty")).values;
  float most_green = 0.0f, most_blue = 0.0f;
  for (std::size_t i = 0; i < beauty.size(); i += 3) {
    most_green = std::max(most_green, beauty[i + 1]);
    most_blue = std::max(most_blue, beauty[i + 2]);
  }
  EXPECT_EQ(most_green, 0.0f);
  EXPECT_GT(most_blue, 0.05f);
  settings.sky = "nowhere";
  expect_refused(render(ball, camera, settings), "sky");
}

TEST(ApiCamera, IsFittedToThePicture) {
  Camera camera{.fov_y_rad = 1.0, .aspect_ratio = 2.0};
  EXPECT_EQ(fitted(camera, 2.0).fov_y_rad, 1.0);
  EXPECT_EQ(fitted(camera, 4.0).fov_y_rad, 1.0);
  EXPECT_NEAR(std::tan(fitted(camera, 1.0).fov_y_rad / 2), 2.0 * std::tan(0.5), 1e-12);
  EXPECT_NEAR(std::tan(fitted(camera, 4.0, CameraFit::fill).fov_y_rad / 2), 0.5 * std::tan(0.5),
              1e-12);
  EXPECT_EQ(fitted(camera, 1.0, CameraFit::crop).fov_y_rad, 1.0);
  // 24 mm high at this angle: a focal length of 24 mm.
  EXPECT_NEAR(aperture_of_f_stop(2.0, 2.0 * std::atan(0.5)), 0.006, 1e-12);
}

TEST(ApiCamera, HasALensWithBlades) {
  const Scene square = value_of(test::white_square(0, 0, 1));
  Camera camera = look_at({0, 0, 5}, {0, 0, 0}, 0.5);
  camera.aperture_radius = 0.5;
  camera.focus = 2.0;
  Settings settings = test::small_settings(16, 16);
  settings.method = "sobol";
  settings.samples = 256;
  const Picture round = value_of(render(square, camera, settings));
  camera.blades = 3;
  const Picture cornered = value_of(render(square, camera, settings));
  EXPECT_GT(value_of(compare(cornered, round)).rmse, 0.01);
  camera.blades = 2;
  EXPECT_FALSE(render(square, camera, settings));
}

// Looks along -Z at x from 0 to 6 and y from -1 to 2; the triangle of half a square metre has its
// right angle at x = 2 seconds.
Camera camera_at_the_slide() {
  Camera camera;
  camera.perspective = false;
  camera.height = 3.0;
  camera.world_from_camera = translation({3, 0.5, 5});
  return camera;
}

struct Seen {
  double area = 0.0;    ///< square metres
  double centre = 0.0;  ///< x
  double first = 0.0, last = 0.0;
};

Seen seen_of(const Picture& picture) {
  Seen seen;
  const std::vector<float> alpha = value_of(picture.layer("alpha")).values;
  const double side = 6.0 / picture.width();
  bool any = false;
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    const double x =
        side * (static_cast<double>(i % static_cast<std::size_t>(picture.width())) + 0.5);
    const double area = side * side * static_cast<double>(alpha[i]);
    seen.area += area;
    seen.centre += x * area;
    if (alpha[i] <= 1e-4f) continue;
    seen.first = any ? std::min(seen.first, x) : x;
    seen.last = any ? std::max(seen.last, x) : x;
    any = true;
  }
  seen.centre /= seen.area;
  return seen;
}

TEST(ApiMotion, AnOpenShutterSmearsTheWay) {
  const asos::test::TemporaryFolder folder;
  const Scene at_rest = value_of(Scene::load(folder.write("slide.gltf", test::moving_triangle())));
  const Scene scene = value_of(at_rest.at(1.0));
  Settings settings = test::small_settings(48, 24);
  settings.background = Background::transparent;
  const Seen still = seen_of(value_of(render(scene, camera_at_the_slide(), settings)));
  EXPECT_NEAR(still.area, 0.5, 1e-5);
  EXPECT_NEAR(still.centre, 2.0 + 1.0 / 3.0, 1e-2);
  EXPECT_NEAR(still.last - still.first, 1.0 - 6.0 / 48, 0.13);
  settings.shutter_seconds = 1.0;  // from x = 1 to x = 3
  const Seen moving = seen_of(value_of(render(scene, camera_at_the_slide(), settings)));
  EXPECT_NEAR(moving.area, 0.5, 1e-3);
  EXPECT_NEAR(moving.centre, 2.0 + 1.0 / 3.0, 1e-2);
  EXPECT_NEAR(moving.last - moving.first, 3.0 - 6.0 / 48, 0.13);
  // A scene at rest begins with its first animation; half a second of it is before the beginning.
  const Seen begun = seen_of(value_of(render(at_rest, camera_at_the_slide(), settings)));
  EXPECT_NEAR(begun.last - begun.first, 2.0 - 6.0 / 48, 0.13);
  expect_refused(render(value_of(Scene::load("builtin:boxes")), camera_at_the_slide(), settings),
                 "shutter_seconds");
}

TEST(ApiMotion, AMomentEqualsItsOwnLoad) {
  const asos::test::TemporaryFolder folder;
  const std::string path = folder.write("slide.gltf", test::moving_triangle());
  const Scene at_rest = value_of(Scene::load(path));
  LoadOptions options;
  options.seconds = 0.75;
  const Scene loaded = value_of(Scene::load(path, options));
  const Scene moved = value_of(value_of(at_rest.at(1.5)).at(0.75, "slide"));
  const Settings settings = test::small_settings(48, 24);
  const Picture a = value_of(render(loaded, camera_at_the_slide(), settings));
  const Picture b = value_of(render(moved, camera_at_the_slide(), settings));
  EXPECT_EQ(value_of(a.layer("beauty")).values, value_of(b.layer("beauty")).values);
  EXPECT_GT(value_of(compare(a, value_of(render(at_rest, camera_at_the_slide(), settings)))).rmse,
            0.01);
  expect_refused(at_rest.at(-1.0), "seconds");
  expect_refused(value_of(Scene::load("builtin:boxes")).at(0.0), "builtin:boxes");
}

TEST(ApiMotion, AMomentKeepsTheCallersLights) {
  const asos::test::TemporaryFolder folder;
  const Scene at_rest = value_of(Scene::load(folder.write("slide.gltf", test::moving_triangle())));
  const Scene dark = value_of(at_rest.with_lights({}));
  Settings settings = test::small_settings(48, 24);
  settings.sky = "0,0,0";
  const Picture picture = value_of(render(value_of(dark.at(1.0)), camera_at_the_slide(), settings));
  for (const float value : value_of(picture.layer("beauty")).values) ASSERT_EQ(value, 0.0f);
}

TEST(ApiPicture, SavesWithAnotherCurveAndItsMap) {
  const asos::test::TemporaryFolder folder;
  const Scene boxes = value_of(Scene::load("builtin:boxes"));
  const Picture picture =
      value_of(render(boxes, boxes.default_camera(1.0), test::small_settings(16, 16)));
  const std::string path = folder.path() / "boxes.png";
  ASSERT_TRUE(picture.save(path, {0.5f, Tone::agx}));
  const auto saved = read_description(path);
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->display.tone, ToneCurve::agx);
  EXPECT_EQ(saved->display.exposure_ev, 0.5f);
  const std::string map = folder.path() / "map.png";
  ASSERT_TRUE(picture.save_split_map(map, SplitMapKind::cause));
  const auto mapped = read_description(map);
  ASSERT_TRUE(mapped);
  EXPECT_TRUE(mapped->display.split_map);
  EXPECT_EQ(mapped->display.split_colours, SplitMapColours::cause);
  expect_refused(picture.save_split_map(folder.path() / "map.exr"), folder.path() / "map.exr");
}

}  // namespace
}  // namespace asos::api
