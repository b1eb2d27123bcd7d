#include "renderer/scene/builtin.h"

#include "renderer/scene/builtin/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace asos {
namespace {

using builtin::Blob;

struct PositionHash {
  std::size_t operator()(const std::array<std::uint32_t, 3>& bits) const {
    return (bits[0] * 73856093u) ^ (bits[1] * 19349663u) ^ (bits[2] * 83492791u);
  }
};

/// For each vertex the first vertex at exactly the same position.
std::vector<std::uint32_t> weld(const Mesh& mesh) {
  std::unordered_map<std::array<std::uint32_t, 3>, std::uint32_t, PositionHash> first_at;
  std::vector<std::uint32_t> welded;
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3 p = mesh.positions[i] + 0.0f;  // -0 and 0 are one place
    std::array<std::uint32_t, 3> bits;
    std::memcpy(bits.data(), &p, sizeof bits);
    welded.push_back(first_at.try_emplace(bits, i).first->second);
  }
  return welded;
}

/// The reason why a mesh is not a closed, consistently wound surface; empty: it is one.
std::string why_not_closed(const Mesh& mesh) {
  const std::vector<std::uint32_t> welded = weld(mesh);
  std::unordered_map<std::uint64_t, int> directed;
  const auto key = [](std::uint32_t a, std::uint32_t b) {
    return (static_cast<std::uint64_t>(a) << 32) | b;
  };
  for (const glm::uvec3& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) ++directed[key(welded[t[i]], welded[t[(i + 1) % 3]])];
  }
  for (const auto& [edge, count] : directed) {
    const auto a = static_cast<std::uint32_t>(edge >> 32), b = static_cast<std::uint32_t>(edge);
    if (a == b) return "a triangle uses position " + std::to_string(a) + " twice";
    const auto opposite = directed.find(key(b, a));
    if (count != 1 || opposite == directed.end() || opposite->second != 1) {
      return "edge " + std::to_string(a) + "-" + std::to_string(b) + " has " +
             std::to_string(count) + " faces one way and " +
             std::to_string(opposite == directed.end() ? 0 : opposite->second) + " the other";
    }
  }
  return {};
}

/// Volume enclosed by a closed mesh, positive when it is wound outwards.
double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    sum += glm::dot(a, glm::cross(b, c)) / 6.0;
  }
  return sum;
}

/// Every triangle must face in the direction of its vertices' normals.
void expect_normals_agree(const Mesh& mesh) {
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  for (const glm::vec3& n : mesh.normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-5f);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::uvec3 t = mesh.triangles[i];
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    const glm::dvec3 face = glm::cross(b - a, c - a);
    ASSERT_GT(glm::length(face), 0.0) << "triangle " << i << " of " << mesh.name;
    for (int corner = 0; corner < 3; ++corner) {
      ASSERT_GT(glm::dot(face, glm::dvec3(mesh.normals[t[corner]])), 0.0)
          << "triangle " << i << " of " << mesh.name;
    }
  }
}

/// Open surfaces by design: grounds, the room seen from inside, panes and the disk.
bool is_sheet(const std::string& scene, const std::string& mesh) {
  static const std::map<std::string, std::set<std::string>> sheets{
      {"office", {"floor", "ceiling", "walls", "sky", "lawn"}},
      {"office-metal", {"floor", "ceiling", "walls", "sky", "lawn"}},
      {"primitives", {"plane", "disk"}},
      {"primitives-ball", {"plane", "disk"}},
      {"primitives-linear", {"plane", "disk"}},
      {"primitives-rectangle", {"plane", "disk"}},
      {"solids", {"plane"}},
      {"house", {"ground", "window pane"}},
      {"house-textured", {"ground", "window pane"}},
      {"house-mirror", {"mirror", "window pane"}},
      {"fence", {"ground"}},
      {"boxes", {"ground"}},
      {"mixed", {"ground"}},
      {"dense", {"ground"}},
      {"wheel", {"ground"}},
      {"park", {"lawn"}},
      {"neon",
       {"road", "night sky", "dark panes", "lit panes 1", "lit panes 2", "lit panes 3",
        "shop panes"}},
      {"workshop", {"floor", "wall"}},
      {"railing", {"terrace", "railing"}},
      {"foliage", {"lawn", "leaves"}},
      {"glass", {"dark squares", "light squares"}},
      {"turning-fence", {"ground"}},
      {"walking-pole", {"ground", "wall"}},
      {"cards", {"wall", "front", "hidden", "left", "right", "wires", "plate", "bar"}}};
  return sheets.at(scene).contains(mesh);
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const BuiltinScene& scene : builtin_scenes()) all.push_back(scene.name);
  return all;
}

class BuiltinSceneTest : public testing::TestWithParam<std::string> {
 protected:
  static Scene make(const std::string& name) {
    for (const BuiltinScene& scene : builtin_scenes()) {
      if (scene.name == name) return scene.make();
    }
    ADD_FAILURE() << "no built-in scene is called " << name;
    return {};
  }
};

TEST_P(BuiltinSceneTest, HasTheTrianglesItPromises) {
  static const std::map<std::string, std::pair<std::uint64_t, std::uint64_t>> range{
      {"office", {5'000, 40'000}},
      {"office-metal", {5'000, 40'000}},
      {"primitives", {14, 14}},
      {"primitives-ball", {14, 14}},
      {"primitives-linear", {14, 14}},
      {"primitives-rectangle", {14, 14}},
      {"solids", {2, 2}},
      {"house", {2'600, 3'000}},
      {"house-textured", {3'800, 4'100}},
      {"house-mirror", {2'600, 3'000}},
      {"fence", {10'000, 80'000}},
      {"boxes", {200, 900}},
      {"mixed", {45'000, 55'000}},
      {"dense", {1'190'000, 1'210'000}},
      {"wheel", {25'000, 40'000}},
      {"park", {250'000, 500'000}},
      {"neon", {10'000, 16'000}},
      {"workshop", {20'000, 35'000}},
      {"railing", {90, 120}},
      {"foliage", {500, 900}},
      {"glass", {820, 820}},
      {"turning-fence", {298, 298}},
      {"walking-pole", {48, 52}},
      {"cards", {32, 32}}};
  const Scene scene = make(GetParam());
  EXPECT_GE(scene.instanced_triangles(), range.at(GetParam()).first);
  EXPECT_LE(scene.instanced_triangles(), range.at(GetParam()).second);
  EXPECT_EQ(scene.name, GetParam());
  EXPECT_EQ(scene.source, "builtin:" + GetParam());
}

TEST_P(BuiltinSceneTest, IsWellFormed) {
  const Scene scene = make(GetParam());
  for (const Instance& instance : scene.instances) {
    ASSERT_GE(instance.mesh, 0);
    ASSERT_LT(instance.mesh, static_cast<int>(scene.meshes.size()));
    EXPECT_NEAR(glm::determinant(glm::dmat3(instance.world_from_mesh)), 1.0, 1e-9)
        << instance.name << " is placed by something else than a rotation";
  }
  for (const Mesh& mesh : scene.meshes) {
    SCOPED_TRACE(mesh.name);
    ASSERT_GE(mesh.material, 0);
    ASSERT_LT(mesh.material, static_cast<int>(scene.materials.size()));
    ASSERT_FALSE(mesh.triangles.empty());
    for (const glm::vec3& p : mesh.positions) {
      ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    }
    for (const glm::uvec3& t : mesh.triangles) {
      ASSERT_LT(std::max({t.x, t.y, t.z}), mesh.positions.size());
    }
    expect_normals_agree(mesh);
  }
}

TEST_P(BuiltinSceneTest, SolidsAreClosedAndTurnedOutwards) {
  const Scene scene = make(GetParam());
  for (const Mesh& mesh : scene.meshes) {
    SCOPED_TRACE(mesh.name);
    if (is_sheet(GetParam(), mesh.name)) {
      EXPECT_NE(why_not_closed(mesh), "");
    } else {
      EXPECT_EQ(why_not_closed(mesh), "");
      EXPECT_GT(volume(mesh), 0.0);
    }
  }
}

TEST_P(BuiltinSceneTest, EachCameraSeesGeometry) {
  const Scene scene = make(GetParam());
  ASSERT_FALSE(scene.cameras.empty());
  for (const Camera& camera : scene.cameras) {
    const glm::dmat4 camera_from_world = glm::inverse(camera.world_from_camera);
    const double reach_y = std::tan(0.5 * camera.fov_y_rad), reach_x = reach_y * 16.0 / 9.0;
    std::set<int> seen;
    for (const Instance& instance : scene.instances) {
      for (const glm::vec3& p : scene.meshes[instance.mesh].positions) {
        const glm::dvec3 q(camera_from_world * instance.world_from_mesh * glm::dvec4(p, 1.0));
        if (q.z < 0.0 && std::abs(q.x) < -q.z * reach_x && std::abs(q.y) < -q.z * reach_y) {
          seen.insert(instance.mesh);
        }
      }
    }
    // Most objects have to be visible in the picture.
    EXPECT_GE(2 * seen.size(), scene.meshes.size() - 1) << camera.name;
  }
}

TEST_P(BuiltinSceneTest, IsLitAndTheSameEveryTime) {
  const Scene first = make(GetParam()), second = make(GetParam());
  ASSERT_FALSE(first.lights.empty());
  for (const Light& light : first.lights) {
    EXPECT_GT(light.intensity, 0.0f);
    EXPECT_NEAR(glm::length(light.direction), 1.0, 1e-12);
  }
  ASSERT_EQ(first.meshes.size(), second.meshes.size());
  for (std::size_t i = 0; i < first.meshes.size(); ++i) {
    EXPECT_EQ(first.meshes[i].positions, second.meshes[i].positions);
    EXPECT_EQ(first.meshes[i].triangles, second.meshes[i].triangles);
  }
  ASSERT_EQ(first.images.size(), second.images.size());
  for (std::size_t i = 0; i < first.images.size(); ++i) {
    EXPECT_EQ(first.images[i].rgba, second.images[i].rgba) << first.images[i].name;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, BuiltinSceneTest, testing::ValuesIn(names()),
                         [](const auto& scene) {
                           std::string name = scene.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(BuiltinScenes, AreTwentyThreeWithOfficeFirst) {
  ASSERT_EQ(builtin_scenes().size(), 24u);
  EXPECT_EQ(builtin_scenes().front().name, "office");
  for (const BuiltinScene& scene : builtin_scenes()) EXPECT_FALSE(scene.summary.empty());
}

TEST(Shapes, SphereHasExactlySharedVerticesAndTheVolumeOfASphere) {
  for (const int n : {1, 2, 3, 7, 24}) {
    Mesh mesh;
    builtin::add_sphere(mesh, {1.0f, -2.0f, 0.5f}, 2.0f, n);
    EXPECT_EQ(mesh.triangles.size(), 8u * n * n);
    EXPECT_EQ(mesh.positions.size(), 4u * n * n + 2u);
    EXPECT_EQ(why_not_closed(mesh), "");
    const double exact = 4.0 / 3.0 * 3.14159265358979 * 8.0;
    EXPECT_LT(volume(mesh), exact);
    // The inscribed volume is too small by a fraction that falls with 1 / n^2.
    EXPECT_NEAR(volume(mesh) / exact, 1.0, 1.6 / (n * n));
  }
}

TEST(Shapes, FrustumIsClosedForEveryPairOfRadii) {
  const glm::vec3 base(0.3f, -1.0f, 2.0f), top(1.3f, 1.0f, 4.0f);  // 3 apart
  for (const auto& [r0, r1] : {std::pair{0.5f, 0.5f}, {0.5f, 0.0f}, {0.0f, 0.5f}, {0.5f, 0.2f}}) {
    Mesh mesh;
    builtin::add_frustum(mesh, base, top, r0, r1, 200);
    EXPECT_EQ(why_not_closed(mesh), "") << r0 << ", " << r1;
    expect_normals_agree(mesh);
    const double exact = 3.14159265358979 / 3.0 * 3.0 * (r0 * r0 + r0 * r1 + r1 * r1);
    EXPECT_NEAR(volume(mesh) / exact, 1.0, 0.001) << r0 << ", " << r1;
  }
}

TEST(Shapes, CylinderNormalsAreExactAndItsRimIsSharp) {
  Mesh mesh;
  builtin::add_frustum(mesh, {0, 0, 0}, {0, 2, 0}, 0.5f, 0.5f, 16);
  int side = 0, cap = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3 p = mesh.positions[i], n = mesh.normals[i];
    if (std::abs(n.y) > 0.5f) {
      EXPECT_NEAR(std::abs(n.y), 1.0f, 1e-6f);
      ++cap;
    } else {
      EXPECT_NEAR(glm::length(n - glm::vec3(2.0f * p.x, 0.0f, 2.0f * p.z)), 0.0f, 1e-6f);
      ++side;
    }
  }
  EXPECT_EQ(side, 32);
  EXPECT_EQ(cap, 64);
}

TEST(Shapes, TubeAndKnotAreClosed) {
  Mesh tube, knot;
  const std::array<glm::vec3, 4> path{{{0, 0, 0}, {0, 1, 0.1f}, {0.1f, 2, 0.3f}, {0.3f, 3, 0.6f}}};
  builtin::add_tube(tube, path, 0.1f, 9);
  EXPECT_EQ(why_not_closed(tube), "");
  EXPECT_GT(volume(tube), 0.0);
  expect_normals_agree(tube);
  builtin::add_torus_knot(knot, {1, 2, 3}, {2, 5, 1.0f, 0.4f, 0.1f}, 300, 12);
  EXPECT_EQ(knot.triangles.size(), 7200u);
  EXPECT_EQ(why_not_closed(knot), "");
  EXPECT_GT(volume(knot), 0.0);
  expect_normals_agree(knot);
}

TEST(Shapes, BlobNormalsAreThoseOfTheSurface) {
  Blob blob{.bumps = {{{0, 1, 0}, 0.3f, 8.0f}}, .ripples = {{{4.0f, -3.0f, 2.0f}, 0.05f, 0.7f}}};
  Mesh mesh;
  builtin::add_blob(mesh, {0, 0, 0}, {1.0f, 2.0f, 0.5f}, blob, 128);
  EXPECT_EQ(why_not_closed(mesh), "");
  // Finely tessellated, so each face's normal is close to the exact normals of its corners.
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    const glm::dvec3 face = glm::normalize(glm::cross(b - a, c - a));
    ASSERT_GT(glm::dot(face, glm::dvec3(mesh.normals[t.x])), 0.99);
  }
}

}  // namespace
}  // namespace asos
