// Rays per second: `bench_rays`. The basis of RayScene's choice of packet sizes and filters.

#include "renderer/geometry/view.h"
#include "renderer/rays/ray_scene.h"
#include "tests/support/tiny_world.h"

#include <benchmark/benchmark.h>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace asos {
namespace {

constexpr int width = 640;
constexpr int height = 360;

float opaque_alpha(const World&, std::uint32_t, float, float) {
  return 1.0f;
}

/// A floor and spheres of about `triangles` triangles.
World scene_of(int triangles, const Material& material = test::matte(glm::vec3(0.5f))) {
  World world = test::still_life().world;
  int rings = 4;
  while (4 * rings * rings < triangles) ++rings;
  test::add_sphere(world, {-0.5f, 1.0f, -1.0f}, 1.0f, rings, material);
  return world;
}

RayScene built(const World& world) {
  return RayScene::build(world, opaque_alpha).value();
}

/// Eye rays in blocks of 8 x 8 pixels, the order in which the methods trace them.
std::vector<Ray> eye_rays() {
  const View view(test::look_at({2, 2, 5}, {0, 0.7, 0}, 0.7), width, height);
  std::vector<Ray> rays;
  for (int by = 0; by < height; by += 8) {
    for (int bx = 0; bx < width; bx += 8) {
      for (int i = 0; i < 64; ++i) rays.push_back(view.ray(bx + i % 8 + 0.5, by + i / 8 + 0.5));
    }
  }
  return rays;
}

void count_rays(benchmark::State& state, std::size_t rays) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays));
}

void trace_blocks(benchmark::State& state, const RayScene& scene, const std::vector<Ray>& rays,
                  Culling faces) {
  std::vector<Hit> hits(rays.size());
  for (auto _ : state) {
    for (std::size_t i = 0; i < rays.size(); i += 64) {
      scene.closest(std::span(rays).subspan(i, 64), std::span(hits).subspan(i, 64), faces);
    }
    benchmark::DoNotOptimize(hits.data());
  }
  count_rays(state, rays.size());
}

void closest_by_packet_width(benchmark::State& state) {
  const World world = scene_of(static_cast<int>(state.range(1)));
  RayScene scene = built(world);
  scene.set_packet_width(static_cast<int>(state.range(0)));
  trace_blocks(state, scene, eye_rays(), Culling::none);
}
BENCHMARK(closest_by_packet_width)->ArgsProduct({{1, 4, 8, 16}, {1'000, 1'000'000}});

/// Single-sided surfaces. Turned 0: closed bodies seen from outside, so no back is hit first.
/// Turned 1: inside out, so every ray hits a back first and continues.
void closest_without_backs(benchmark::State& state) {
  World world = scene_of(static_cast<int>(state.range(2)));
  if (state.range(1) != 0) {
    for (glm::uvec3& corners : world.triangles) std::swap(corners.y, corners.z);
  }
  const RayScene scene = built(world);
  trace_blocks(state, scene, eye_rays(),
               state.range(0) ? Culling::as_material_says : Culling::none);
}
BENCHMARK(closest_without_backs)
    ->ArgNames({"cull", "turned", "triangles"})
    ->ArgsProduct({{0, 1}, {0, 1}, {1'000, 1'000'000}});

/// Rays from visible points to random points of a square light, 4 per pixel of each block of 8 x 8:
/// batches of 256.
std::vector<Ray> shadow_rays(const RayScene& scene) {
  std::mt19937 rng(1);
  std::uniform_real_distribution<float> side(-0.5f, 0.5f);
  std::vector<Ray> rays;
  for (const Ray& eye : eye_rays()) {
    const Hit hit = scene.closest(eye);
    for (int i = 0; i < 4; ++i) {
      Ray ray;
      ray.origin = eye.at(hit.valid() ? hit.t * 0.9999f : 5.0f);
      ray.direction = glm::vec3(1.0f + side(rng), 4.0f, 1.0f + side(rng)) - ray.origin;
      ray.t_far = 1.0f;
      rays.push_back(ray);
    }
  }
  return rays;
}

constexpr std::size_t batch = 256;

World lit_scene(const benchmark::State& state) {
  Material material = test::matte(glm::vec3(0.5f));
  if (state.range(1) != 0) material.alpha_mode = AlphaMode::mask;
  return scene_of(static_cast<int>(state.range(2)), material);
}

void shadows(benchmark::State& state) {
  const World world = lit_scene(state);
  RayScene scene = built(world);
  const std::vector<Ray> rays = shadow_rays(scene);
  scene.set_packet_width(static_cast<int>(state.range(0)));
  std::vector<glm::vec3> shares(rays.size());
  for (auto _ : state) {
    for (std::size_t i = 0; i < rays.size(); i += batch) {
      scene.transmittance(std::span(rays).subspan(i, batch), std::span(shares).subspan(i, batch));
    }
    benchmark::DoNotOptimize(shares.data());
  }
  count_rays(state, rays.size());
}
BENCHMARK(shadows)
    ->ArgNames({"width", "masked", "triangles"})
    ->ArgsProduct({{1, 4, 8, 16}, {0, 1}, {1'000, 1'000'000}});

void shadows_one_by_one(benchmark::State& state) {
  const World world = lit_scene(state);
  const RayScene scene = built(world);
  const std::vector<Ray> rays = shadow_rays(scene);
  for (auto _ : state) {
    float sum = 0.0f;
    for (const Ray& ray : rays) sum += scene.transmittance(ray).x;
    benchmark::DoNotOptimize(sum);
  }
  count_rays(state, rays.size());
}
BENCHMARK(shadows_one_by_one)
    ->ArgNames({"", "masked", "triangles"})
    ->ArgsProduct({{1}, {0, 1}, {1'000, 1'000'000}});

void blockers(benchmark::State& state) {
  const World world = lit_scene(state);
  RayScene scene = built(world);
  const std::vector<Ray> rays = shadow_rays(scene);
  scene.set_packet_width(static_cast<int>(state.range(0)));
  std::vector<Blocker> met(rays.size());
  for (auto _ : state) {
    for (std::size_t i = 0; i < rays.size(); i += batch) {
      scene.blockers(std::span(rays).subspan(i, batch), std::span(met).subspan(i, batch));
    }
    benchmark::DoNotOptimize(met.data());
  }
  count_rays(state, rays.size());
}
BENCHMARK(blockers)
    ->ArgNames({"width", "masked", "triangles"})
    ->ArgsProduct({{1, 16}, {0, 1}, {1'000, 1'000'000}});

}  // namespace
}  // namespace asos

BENCHMARK_MAIN();
