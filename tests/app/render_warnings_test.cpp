#include "tests/app/run_asos.h"
#include "tests/renderer/gltf/gltf_builder.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace asos::test {
namespace {

// The number of intersections is determined only by the edge search of a render.
TEST(RenderWarnings, SayThatSurfacesPassThroughEachOtherTooOften) {
  const TemporaryFolder folder;
  const auto path = [&](const char* name) { return (folder.path() / name).string(); };
  GltfBuilder b;
  std::vector<glm::vec3> corners;
  constexpr int walls = 320;  // in each direction: more lines than IntersectionBudget allows
  for (int i = 0; i < walls; ++i) {
    const auto at = static_cast<float>(i), end = static_cast<float>(walls);
    const glm::vec3 x[]{{at, -1, -1}, {at, end, -1}, {at, end, 1}, {at, -1, 1}};
    const glm::vec3 y[]{{-1, at, -1}, {end, at, -1}, {end, at, 1}, {-1, at, 1}};
    for (const auto& wall : {x, y})
      for (const int k : {0, 1, 2, 0, 2, 3}) corners.push_back(wall[k]);
  }
  b.primitive({{"POSITION", b.vec3(corners)}});
  std::ofstream(path("walls.glb"), std::ios::binary) << b.glb();
  const AsosRun run = run_asos({"render", path("walls.glb"), "-o", path("walls.png"), "--size",
                                "16x9", "--max", "0", "--stats", path("walls.json")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string said = "too many surfaces overlap or lie close together";
  EXPECT_TRUE(contains(run.err, said));
  EXPECT_TRUE(
      contains(nlohmann::json::parse(std::ifstream(path("walls.json")))["warnings"].dump(), said));
}

}  // namespace
}  // namespace asos::test
