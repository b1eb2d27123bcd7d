#include "renderer/prepared/edited_materials.h"

#include "renderer/scene/load.h"
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

/// The built-in boxes, of polished metal; with a ratio of their own where that is asked for.
std::shared_ptr<const RenderScene> polished_boxes(std::optional<Dfr> dfr) {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    if (builtin.name != "boxes") continue;
    Scene scene = builtin.make();
    for (Material& material : scene.materials) {
      material.metallic = 1.0f;
      material.roughness = 0.0f;
      material.dfr = dfr;
    }
    return prepare(scene).value();
  }
  return nullptr;
}

Film film_of(const RenderScene& scene) {
  RenderSettings settings;
  settings.width = 24;
  settings.height = 18;
  settings.asos.max_level = 1;
  return test::render_picture(scene, test::first_camera(scene.world, 4.0 / 3.0), settings).film;
}

TEST(WithDfrs, GivesThePictureOfASceneWithThoseMaterials) {
  const auto before = polished_boxes(std::nullopt);
  const auto fresh = polished_boxes(blurred());
  MaterialDfrs dfrs = dfrs_of(fresh->world);
  const auto edited = with_dfrs(before, dfrs);
  ASSERT_TRUE(edited.has_value());
  EXPECT_EQ(&(*edited)->features, &before->features) << "nothing is built again";
  EXPECT_EQ((*edited)->built_from, before);
  const Film got = film_of(**edited);
  EXPECT_EQ(got.radiance, film_of(*fresh).radiance);
  EXPECT_NE(got.radiance, film_of(*before).radiance);
  const auto back = with_dfrs(*edited, dfrs_of(before->world));
  EXPECT_EQ((*back)->built_from, before) << "no chain of scenes";
  EXPECT_EQ(film_of(**back).radiance, film_of(*before).radiance);
}

TEST(WithDfrs, RefusesWhatIsOutOfRange) {
  const auto scene = polished_boxes(std::nullopt);
  MaterialDfrs dfrs = dfrs_of(scene->world);
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
