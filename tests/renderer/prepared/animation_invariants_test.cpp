#include "renderer/prepared/render_scene.h"
#include "renderer/prepared/with_ground.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace asos::test::stage_test {
namespace {

/// A textured triangle at `x`, without a light.
Scene at(double x) {
  Scene scene;
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.texcoords[0] = {{0, 0}, {1, 0}, {0, 1}};
  mesh.triangles = {{0, 1, 2}};
  mesh.material = 0;
  scene.meshes.push_back(mesh);
  scene.images.push_back({"grey", 4, 4, std::vector<std::uint8_t>(64, 128)});
  scene.textures.resize(1);
  scene.textures[0].image = 0;
  scene.materials.resize(1);
  scene.materials[0].base_color_texture.texture = 0;
  scene.instances.resize(1);
  scene.instances[0].mesh = 0;
  scene.instances[0].world_from_mesh = glm::translate(glm::dmat4(1.0), glm::dvec3(x, 0, 0));
  return scene;
}

std::vector<glm::dvec3> places(const RenderScene& scene) {
  std::vector<glm::dvec3> places;
  for (const Light& light : scene.lights()) places.push_back(scene.world().origin + light.position);
  return places;
}

TEST(AnimationInvariants, LightsAndOriginStayWhereTheSceneIsAtRest) {
  const auto rest = prepare(at(0.0)).value();
  const AnimationInvariants& stage = rest->geometry->stage;
  ASSERT_TRUE(stage.has_default_lighting);
  const auto moved = prepare(at(7.0), {}, &stage).value();
  EXPECT_EQ(moved->world().origin, rest->world().origin);
  EXPECT_EQ(places(*moved), places(*rest));
  EXPECT_TRUE(moved->lighting->default_lights_added);
  EXPECT_EQ(moved->world().origin.x + static_cast<double>(moved->world().positions[1].x), 8.0);
  // Without the invariants, the default lighting follows the scene.
  const auto alone = prepare(at(7.0)).value();
  EXPECT_NE(places(*alone), places(*rest));
  // The new scene passes the invariants on.
  const auto again = prepare(at(2.0), {}, &moved->geometry->stage).value();
  EXPECT_EQ(places(*again), places(*rest));
}

// Objects that leave the ground do not lift it.
TEST(AnimationInvariants, TheGroundStaysWhereItIsAtRest) {
  const auto rest = prepare(at(0.0)).value();
  Scene jumps = at(0.0);
  jumps.instances[0].world_from_mesh = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.75, 0.0));
  const auto ground_height = [](const Scene& scene, const AnimationInvariants* stage) {
    const auto on = with_ground(prepare(scene, {}, stage).value(), Ground::on).value();
    const World& world = on->world();
    return world.origin.y + static_cast<double>(world.positions[world.positions.size() - 1].y);
  };
  const double at_rest = ground_height(at(0.0), nullptr);
  EXPECT_NEAR(at_rest, 0.0, 1e-3);
  EXPECT_NEAR(ground_height(jumps, &rest->geometry->stage), at_rest, 1e-6);
  EXPECT_NEAR(ground_height(jumps, nullptr), at_rest + 0.75, 1e-6);
}

TEST(AnimationInvariants, TheGroundOfAnotherMomentKeepsItsPlace) {
  const auto rest = prepare(at(0.0)).value();
  const AnimationInvariants& stage = rest->geometry->stage;
  const auto plate_of = [](const RenderScene& scene) {
    const World& world = scene.world();
    const Part& plate = world.parts.back();
    std::vector<glm::vec3> vertices;
    for (std::uint32_t i = 0; i < plate.vertex_count; ++i)
      vertices.push_back(world.positions[plate.first_vertex + i]);
    return vertices;
  };
  const auto moved = prepare(at(7.0), {}, &stage).value();
  const auto now = with_ground(rest, Ground::on).value();
  const auto own = with_ground(moved, Ground::on).value();
  const auto same = with_ground(moved, Ground::on, &now->world()).value();
  EXPECT_NE(plate_of(*own), plate_of(*now)) << "lies under the scene of its moment";
  EXPECT_EQ(plate_of(*same), plate_of(*now));
  // A moment without a ground has none to copy.
  EXPECT_EQ(plate_of(*with_ground(moved, Ground::on, &rest->world()).value()), plate_of(*own));
}

TEST(AnimationInvariants, TexturesAreNeitherCopiedNorAveragedAgain) {
  const Scene scene = at(0.0);
  const auto rest = prepare(scene).value();
  const auto moved = prepare(scene, {}, &rest->geometry->stage).value();
  ASSERT_FALSE(rest->mips().chain(0, TexelKind::color).empty());
  EXPECT_EQ(&moved->mips().chain(0, TexelKind::color), &rest->mips().chain(0, TexelKind::color));
  EXPECT_EQ(moved->world().images[0].rgba.data(), scene.images[0].rgba.data());
}

TEST(SharedBytes, ACopyThatIsWrittenToIsItsOwn) {
  SharedBytes a{1, 2, 3};
  SharedBytes b = a;
  EXPECT_EQ(a.data(), b.data());
  b.own()[1] = 9;
  b.own().push_back(4);
  EXPECT_EQ(a, (SharedBytes{1, 2, 3}));
  EXPECT_EQ(b, (SharedBytes{1, 9, 3, 4}));
  const SharedBytes none;
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.size(), 0u);
  EXPECT_EQ(none, SharedBytes(std::vector<std::uint8_t>{}));
}

}  // namespace
}  // namespace asos::test::stage_test
