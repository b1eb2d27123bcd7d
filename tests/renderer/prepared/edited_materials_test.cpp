#include "renderer/prepared/render_scene.h"
#include "renderer/scene/builtin.h"
#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

namespace asos {
namespace {

Dfr blurred() {
  Dfr dfr;
  dfr.rgb.fill({0.2, 0.9, 4.0});
  return dfr;
}

/// The built-in boxes of polished metal, optionally with a DFR of their own.
std::shared_ptr<const RenderScene> polished_boxes(std::optional<Dfr> dfr, float roughness = 0.0f) {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    if (builtin.name != "boxes") continue;
    Scene scene = builtin.make();
    for (Material& material : scene.materials) {
      material.metallic = 1.0f;
      material.roughness = roughness;
      material.dfr = dfr;
    }
    return prepare(scene).value();
  }
  return nullptr;
}

Film film_of(const RenderScene& scene) {
  RenderSettings settings = test::make_settings(24, 18);
  settings.asos.max_level = 1;
  return test::render_picture(scene, test::first_camera(scene.world(), 4.0 / 3.0), settings).film;
}

TEST(WithDfrs, GivesThePictureOfASceneWithThoseMaterials) {
  const auto before = polished_boxes(std::nullopt);
  const auto fresh = polished_boxes(blurred());
  MaterialDfrs dfrs = dfrs_of(fresh->world());
  const auto edited = with_dfrs(before, dfrs);
  ASSERT_TRUE(edited.has_value());
  EXPECT_EQ((*edited)->geometry, before->geometry) << "nothing is rebuilt";
  EXPECT_EQ((*edited)->lighting, before->lighting);
  EXPECT_EQ((*edited)->dfrs(), dfrs);
  const Film got = film_of(**edited);
  EXPECT_EQ(got.radiance, film_of(*fresh).radiance);
  EXPECT_NE(got.radiance, film_of(*before).radiance);
  const auto back = with_dfrs(*edited, dfrs_of(before->world()));
  EXPECT_EQ(film_of(**back).radiance, film_of(*before).radiance);
}

TEST(WithDfrs, LightsAndRatiosAreEditedInEitherOrder) {
  const auto before = polished_boxes(std::nullopt);
  const MaterialDfrs dfrs = dfrs_of(polished_boxes(blurred())->world());
  const Light sun = test::make_sun({0, -1, 0});
  const auto lit_first = with_dfrs(with_lights(before, {sun}).value(), dfrs).value();
  const auto lit_last = with_lights(with_dfrs(before, dfrs).value(), {sun}).value();
  for (const auto& scene : {lit_first, lit_last}) {
    EXPECT_EQ(scene->geometry, before->geometry);
    EXPECT_EQ(scene->dfrs(), dfrs);
    EXPECT_EQ(scene->lights().size(), 1u);
  }
  EXPECT_EQ(lit_first->render_features, lit_last->render_features);
  EXPECT_EQ(film_of(*lit_first).radiance, film_of(*lit_last).radiance);
}

// A DFR makes a rough material a mirror; without it the material is rough again.
TEST(WithDfrs, ARoughMaterialBecomesAMirror) {
  const auto rough = polished_boxes(std::nullopt, 0.6f);
  const auto mirrors = polished_boxes(blurred(), 0.6f);
  EXPECT_FALSE(rough->render_features.mirrors);
  const auto edited = with_dfrs(rough, dfrs_of(mirrors->world())).value();
  EXPECT_EQ(edited->render_features, mirrors->render_features);
  EXPECT_EQ(film_of(*edited).radiance, film_of(*mirrors).radiance);
  const auto back = with_dfrs(edited, dfrs_of(rough->world())).value();
  EXPECT_EQ(back->render_features, rough->render_features);
}

TEST(WithDfrs, RefusesWhatIsOutOfRange) {
  const auto scene = polished_boxes(std::nullopt);
  MaterialDfrs dfrs = dfrs_of(scene->world());
  EXPECT_FALSE(with_dfrs(scene, {}).has_value());
  for (const double bad : {-0.1, 1.5, std::numeric_limits<double>::quiet_NaN()}) {
    dfrs[0] = blurred();
    dfrs[0]->rgb[1].min = bad;
    const auto refused = with_dfrs(scene, dfrs);
    ASSERT_FALSE(refused.has_value()) << bad;
    EXPECT_NE(refused.error().message().find("material"), std::string::npos);
  }
}

}  // namespace
}  // namespace asos
