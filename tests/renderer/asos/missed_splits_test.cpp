#include "renderer/gltf/load.h"
#include "renderer/scene/builtin.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/shared_dir.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

// Pixels that show several surfaces although no edge was found in them (design section 3): none in
// our own scenes, next to none in models from other sources.

namespace asos::test::missed_splits_test {
namespace {

struct Case {
  std::string name;
  std::string source;  ///< empty: nothing to render
  int width = 320;
  int height = 180;
};

/// Everything, or no shadows and reflections, which are not needed for edges.
enum class Shows { everything, edges };

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name << " at " << c.width << "x" << c.height;
}

class MissedSplits : public testing::TestWithParam<Case> {
 protected:
  void load() {
    const auto loaded = load_scene(GetParam().source);
    ASSERT_TRUE(loaded) << loaded.error().message();
    const auto scene = prepare(*loaded);
    ASSERT_TRUE(scene) << scene.error().message();
    scene_ = *scene;
  }
  void render(Shows shows, int width, int height) {
    RenderSettings settings = make_settings(width, height);
    if (shows == Shows::edges) {
      settings.shadow.cast = settings.asos.refine_shading = false;
      settings.mirror.bounces = 0;
    }
    const Camera camera = first_camera(scene_->world(), static_cast<double>(width) / height);
    const auto picture = render_picture(*scene_, camera, settings);
    statistics_ = picture.statistics;
    for (const glm::vec3& c : picture.film.radiance)
      ASSERT_TRUE(std::isfinite(c.x + c.y + c.z) && glm::min(c.x, glm::min(c.y, c.z)) >= 0.0f);
    ASSERT_GT(statistics_.split_pixels, 0u) << "nothing is in view";
    RecordProperty("missed_splits", std::to_string(statistics_.missed_splits));
    RecordProperty("split_pixels", std::to_string(statistics_.split_pixels));
    RecordProperty("saturated_pixels", std::to_string(statistics_.saturated_pixels));
  }

  std::shared_ptr<const RenderScene> scene_;
  RenderStatistics statistics_;
};

std::string name_of(const testing::TestParamInfo<Case>& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::vector<Case> builtin_cases() {
  std::vector<Case> cases;
  for (const BuiltinScene& scene : builtin_scenes()) {
    const std::string source = "builtin:" + scene.name;
    cases.push_back({scene.name, source});
    // These two would take half a minute, because of their triangles and lights.
    if (scene.name != "dense" && scene.name != "neon")
      cases.push_back({scene.name + "_large", source, 640, 360});
  }
  return cases;
}

/// The glTF files of the shared scenes, or one case without a source if there are none.
std::vector<Case> shared_cases() {
  std::vector<Case> cases;
  if (const auto dir = shared_dir()) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(*dir / "scenes")) {
      const std::filesystem::path& path = entry.path();
      if (path.extension() == ".glb" || path.extension() == ".gltf")
        cases.push_back({path.stem().string(), path.string()});
    }
  }
  std::sort(cases.begin(), cases.end(),
            [](const Case& a, const Case& b) { return a.name < b.name; });
  if (cases.empty()) cases.push_back({"none", ""});
  return cases;
}

class BuiltinScenes : public MissedSplits {};
TEST_P(BuiltinScenes, MissNothing) {
  ASSERT_NO_FATAL_FAILURE(load());
  ASSERT_NO_FATAL_FAILURE(render(Shows::edges, GetParam().width, GetParam().height));
  EXPECT_EQ(statistics_.missed_splits, 0u);
  EXPECT_EQ(statistics_.rejected_samples, 0u);
}
INSTANTIATE_TEST_SUITE_P(MissedSplits, BuiltinScenes, testing::ValuesIn(builtin_cases()), name_of);

// Loading, which takes most of the time for models with textures, is shared by both pictures.
class SharedScenes : public MissedSplits {};
TEST_P(SharedScenes, MissAThousandthOfThePixelsAtMostAndAreFinite) {
  if (GetParam().source.empty())
    GTEST_SKIP() << "no models: set ASOS_SHARED to a folder with scenes/";
  ASSERT_NO_FATAL_FAILURE(load());
  // All features on: shadows, mirrors, and rough, curved or invalid surfaces of other people's
  // files.
  ASSERT_NO_FATAL_FAILURE(render(Shows::everything, 64, 36));
  EXPECT_EQ(statistics_.rejected_samples, 0u) << "with everything on";
  ASSERT_NO_FATAL_FAILURE(render(Shows::edges, GetParam().width, GetParam().height));
  EXPECT_LT(1000u * statistics_.missed_splits, 320u * 180u);
  EXPECT_EQ(statistics_.rejected_samples, 0u);
}
INSTANTIATE_TEST_SUITE_P(MissedSplits, SharedScenes, testing::ValuesIn(shared_cases()), name_of);

}  // namespace
}  // namespace asos::test::missed_splits_test
