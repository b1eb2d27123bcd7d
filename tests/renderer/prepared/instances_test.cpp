#include "renderer/prepared/exposure.h"
#include "renderer/prepared/render_scene.h"
#include "tests/support/instanced_scene.h"
#include "tests/support/make_settings.h"
#include "tests/support/picture_difference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <tbb/global_control.h>
#include <vector>

namespace asos {
namespace {

/// 140 instances of two meshes with 1512 triangles each: over 200,000 triangles.
constexpr int places = 140;
constexpr std::uint32_t rings = 28;

std::shared_ptr<const RenderScene> ready_to_render(const Scene& scene) {
  auto prepared = prepare(scene);
  EXPECT_TRUE(prepared) << prepared.error().message();
  return *prepared;
}

Camera above() {
  Camera camera;
  const glm::dvec3 eye(1.0, 5.0, 8.0);
  camera.world_from_camera = glm::inverse(glm::lookAt(eye, glm::dvec3(0, 0, -0.5), {0, 1, 0}));
  camera.fov_y_rad = 0.6;
  return camera;
}

/// The camera relative to the world's origin.
Camera camera_of(const RenderScene& scene) {
  Camera camera = above();
  camera.world_from_camera[3] -= glm::dvec4(scene.world().origin, 0.0);
  return camera;
}

RenderSettings small_picture(Method method) {
  return test::make_settings(48, 36, method, 4);
}

class Instances : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const Scene scene = test::instanced_scene(places, rings, 0.8);
    shared_ = ready_to_render(scene);
    copied_ = ready_to_render(test::unrolled(scene));
  }
  static void TearDownTestSuite() { shared_ = copied_ = nullptr; }

  static test::Picture picture(const RenderScene& scene, Method method) {
    return test::render_picture(scene, camera_of(scene), small_picture(method));
  }

  static inline std::shared_ptr<const RenderScene> shared_, copied_;
};

/// Fraction of pixels of two pictures that differ by more than 1e-5.
double differing(const test::Picture& a, const test::Picture& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.film.radiance.size(); ++i) {
    const glm::vec3 d = glm::abs(a.film.radiance[i] - b.film.radiance[i]);
    count += std::max({d.x, d.y, d.z}) > 1e-5f ? 1 : 0;
  }
  return static_cast<double>(count) / static_cast<double>(a.film.radiance.size());
}

TEST_F(Instances, AreShared) {
  ASSERT_TRUE(shared_->world().placements);
  EXPECT_EQ(shared_->world().placements->places.size(), static_cast<std::size_t>(places));
  EXPECT_FALSE(copied_->world().placements);
  EXPECT_EQ(shared_->world().origin, copied_->world().origin);
}

TEST_F(Instances, BlockTheSameRaysAsCopies) {
  const World& world = copied_->world();
  std::size_t met = 0;
  for (int i = 0; i < 4000; ++i) {
    Ray ray;
    ray.origin =
        glm::vec3(0.01f * static_cast<float>(i % 211) - 1.0f, 4.0f, 3.0f) - glm::vec3(world.origin);
    const glm::vec3 target = glm::vec3(0.05f * static_cast<float>(i % 97) - 2.0f, 0.4f,
                                       0.05f * static_cast<float>(i % 89) - 2.0f) -
                             glm::vec3(world.origin);
    ray.direction = glm::normalize(target - ray.origin);
    for (const Culling culling : {Culling::none, Culling::as_material_says}) {
      const Hit a = shared_->rays().closest(ray, culling),
                b = copied_->rays().closest(ray, culling);
      ASSERT_EQ(a.valid(), b.valid());
      if (!a.valid()) continue;
      ++met;
      ASSERT_NEAR(a.t, b.t, 2e-5f * b.t);
      const std::uint32_t part = shared_->world().triangle_part[a.triangle];
      if (part != world.triangle_part[b.triangle]) continue;  // the parts touch
      const glm::dvec3 p = hit_plane(shared_->world(), a).point(a.b1, a.b2);
      const HitPlane plane = hit_plane(world, b);
      // Along the ray, the rounding error grows at grazing angles.
      const double cosine =
          std::abs(glm::dot(glm::normalize(plane.normal()), glm::dvec3(ray.direction)));
      ASSERT_LT(glm::distance(p, plane.point(b.b1, b.b2)) * cosine, 4e-6) << world.parts[part].name;
    }
    EXPECT_EQ(shared_->rays().transmittance(ray), copied_->rays().transmittance(ray));
  }
  EXPECT_GT(met, 4000u);
}

TEST_F(Instances, LookLikeCopiesByPointSamples) {
  EXPECT_LE(differing(picture(*shared_, Method::sobol), picture(*copied_, Method::sobol)), 0.002);
}

// Not bit by bit: in copies, rounding bends flat faces and creates creases.
TEST_F(Instances, LookLikeCopiesByAsos) {
  const test::Picture a = picture(*shared_, Method::asos), b = picture(*copied_, Method::asos);
  const test::Difference d = test::difference(a, b);
  EXPECT_LT(d.rmse, 1e-3 * d.mean);
  EXPECT_LT(std::abs(d.bias), 1e-4 * d.mean);
  EXPECT_LT(d.largest, 0.02 * d.mean);
}

// A closed mesh of F triangles has 3/2 F edges. The diagonals of quads are flat.
TEST_F(Instances, HaveTheBoundariesOfTheirMeshes) {
  const FeatureCounts a = shared_->features().counts(), b = copied_->features().counts();
  constexpr std::uint64_t quadrangles = std::uint64_t{rings} * (rings - 2);
  constexpr std::uint64_t edges = 3 * std::uint64_t{rings} * (rings - 1) - quadrangles;
  EXPECT_EQ(a.silhouette_candidates, places / 2 * edges);
  EXPECT_EQ(a.crease, places / 2 * edges);
  EXPECT_EQ(a.open, b.open);
  EXPECT_EQ(a.seam, 0u);
  EXPECT_GT(b.intersection, 1000u);
  EXPECT_NEAR(static_cast<double>(a.intersection), static_cast<double>(b.intersection),
              0.001 * static_cast<double>(b.intersection));
}

/// The nodes of each instance contain its edges.
TEST_F(Instances, LieInTheNodesOfTheirHierarchy) {
  const FeatureSet& features = shared_->features();
  std::vector<std::uint32_t> left{0};
  std::size_t edges = 0;
  while (!left.empty()) {
    FeatureNode room;
    const FeatureNode& node = features.node(left.back(), room);
    left.pop_back();
    for (std::uint32_t c = 0; c < node.child_count; ++c) {
      if (node.edge_count[c] == FeatureNode::inner) {
        left.push_back(node.child[c]);
        continue;
      }
      for (std::uint32_t e = node.child[c]; e < node.child[c] + node.edge_count[c]; ++e, ++edges) {
        const FeatureEdge edge = features.edge(e);
        for (const std::uint32_t end : {edge.a, edge.b}) {
          const glm::dvec3 p = features.position(end);
          for (int k = 0; k < 3; ++k) {
            ASSERT_GE(p[k], static_cast<double>(node.lo[k][c]));
            ASSERT_LE(p[k], static_cast<double>(node.hi[k][c]));
          }
        }
        ASSERT_LT(edge.left_surface, shared_->world().surface_count());
      }
    }
  }
  const FeatureCounts& counts = features.counts();
  EXPECT_EQ(edges, counts.open + counts.crease + counts.seam + counts.silhouette_candidates +
                       counts.intersection);
}

TEST_F(Instances, TakeMemoryByTheirMeshes) {
  (void)shared_->features();
  (void)copied_->features();
  EXPECT_LT(8.0 * shared_->geometry->memory_mb(), copied_->geometry->memory_mb());
}

// The steps of motion blur are limited by what their moments store.
TEST_F(Instances, CountOnceInAnExposure) {
  EXPECT_EQ(stored_triangles(copied_->world()), copied_->world().triangles.size());
  EXPECT_EQ(shared_->world().triangles.size(), copied_->world().triangles.size());
  EXPECT_LT(stored_triangles(shared_->world()), copied_->world().triangles.size() / 50);
  EXPECT_GE(stored_triangles(shared_->world()), 2u * 1512u);
}

TEST_F(Instances, ShowTheSameWhateverTheThreads) {
  const auto parallel = picture(*shared_, Method::asos);
  std::shared_ptr<const RenderScene> again;
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    again = ready_to_render(test::instanced_scene(places, rings, 0.8));
    (void)again->features();
  }
  const auto alone = picture(*again, Method::asos);
  EXPECT_EQ(parallel.film.radiance, alone.film.radiance);
}

}  // namespace
}  // namespace asos
