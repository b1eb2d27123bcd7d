// Rays a second by packet width: `bench_rays`. RayScene::build's choice of width rests on it.

#include "renderer/geometry/view.h"
#include "renderer/rays/ray_scene.h"
#include "tests/support/tiny_world.h"

#include <benchmark/benchmark.h>
#include <cstddef>
#include <vector>

namespace asos {
namespace {

constexpr int width = 640;
constexpr int height = 360;

float opaque_alpha(const World&, std::uint32_t, float, float) {
  return 1.0f;
}

/// A floor and a sphere of about `triangles` triangles.
World scene_of(int triangles) {
  World world = test::still_life();
  int rings = 4;
  while (4 * rings * rings < triangles) ++rings;
  test::add_sphere(world, {-0.5f, 1.0f, -1.0f}, 1.0f, rings, test::matte(glm::vec3(0.5f)));
  return world;
}

/// Eye rays, a block of 8 x 8 pixels after the other: as the methods trace them.
void closest_by_packet_width(benchmark::State& state) {
  const World world = scene_of(static_cast<int>(state.range(1)));
  RayScene scene = RayScene::build(world, opaque_alpha).value();
  scene.set_packet_width(static_cast<int>(state.range(0)));
  const View view(test::look_at({2, 2, 5}, {0, 0.7, 0}, 0.7), width, height);
  std::vector<Ray> rays;
  for (int by = 0; by < height; by += 8) {
    for (int bx = 0; bx < width; bx += 8) {
      for (int i = 0; i < 64; ++i) rays.push_back(view.ray(bx + i % 8 + 0.5, by + i / 8 + 0.5));
    }
  }
  std::vector<Hit> hits(rays.size());
  for (auto _ : state) {
    for (std::size_t i = 0; i < rays.size(); i += 64) {
      scene.closest(std::span(rays).subspan(i, 64), std::span(hits).subspan(i, 64));
    }
    benchmark::DoNotOptimize(hits.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays.size()));
}
BENCHMARK(closest_by_packet_width)->ArgsProduct({{1, 4, 8, 16}, {1'000, 1'000'000}});

}  // namespace
}  // namespace asos

BENCHMARK_MAIN();
