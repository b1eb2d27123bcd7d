// Builds a scene from arrays and prints how one pixel is subdivided.
#include <array>
#include <asos/asos.h>
#include <cstdio>

namespace {

namespace api = asos::api;

// A roof of two faces over a ball, in the light of a lamp.
api::Result<api::Scene> build_scene() {
  const std::array<float, 18> positions{-1, 0, -1, 1, 0, -1, 1, 1, 0, -1, 1, 0, 1, 0, 1, -1, 0, 1};
  const std::array<std::uint32_t, 12> triangles{0, 3, 2, 0, 2, 1, 3, 5, 4, 3, 4, 2};
  api::SceneBuilder builder("roof");
  api::Material clay;
  clay.name = "clay";
  clay.base_color = {0.6f, 0.3f, 0.2f, 1.0f};
  clay.double_sided = true;
  const api::Result<int> material = builder.add_material(clay);
  if (!material) return material.error();
  api::MeshData roof;
  roof.name = "roof";
  roof.positions = positions;
  roof.triangles = triangles;
  const api::Result<int> mesh = builder.add_mesh(roof, *material);
  if (!mesh) return mesh.error();
  api::Shape ball;
  ball.radius = 0.3;
  api::Light lamp;
  lamp.position = {2, 3, 3};
  lamp.intensity = 60.0f;  // candela
  api::Result<void> placed = builder.place_mesh(*mesh);
  if (placed) placed = builder.place_shape(ball, *material, api::translation({0, 0.2, 1.4}));
  if (placed) placed = builder.add_light(lamp);
  if (!placed) return placed.error();
  return builder.build();
}

}  // namespace

int main() {
  api::Settings settings;
  settings.width = 64;
  settings.height = 48;
  const api::Result<api::Scene> scene = build_scene();
  if (!scene) {
    std::fprintf(stderr, "%s\n", scene.error().message().c_str());
    return 1;
  }
  const api::Camera camera = api::look_at({1, 2, 5}, {0, 0.4, 0});
  // The outline of the ball crosses this pixel.
  const api::Result<api::PixelTrace> trace = api::trace_pixel(*scene, camera, settings, 24, 31);
  if (!trace) {
    std::fprintf(stderr, "%s\n", trace.error().message().c_str());
    return 1;
  }
  std::printf("level %d, cause %s, radiance %.4f %.4f %.4f\n", trace->level, trace->cause.c_str(),
              trace->radiance[0], trace->radiance[1], trace->radiance[2]);
  for (const api::TracedCell& cell : trace->cells)
    std::printf("level %d  x %.4f  y %.4f  side %.4f  %-10s %zu edges, %zu samples\n", cell.level,
                cell.x, cell.y, cell.side, cell.fate.c_str(), cell.edges.size(),
                cell.samples.size());
  return 0;
}
