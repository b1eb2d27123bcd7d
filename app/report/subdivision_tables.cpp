#include "app/report/subdivision_tables.h"

#include "renderer/asos/pixel_trace.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <numbers>

namespace asos {
namespace {

using Polygon = std::vector<glm::dvec2>;  // in a pixel, x to the right and y down

/// A scene with a convex polygon, for an orthographic camera with one pixel, the unit square.
Scene scene_of(const Polygon& polygon) {
  Scene scene;
  scene.source = "a polygon";
  Mesh mesh;
  for (const glm::dvec2 p : polygon) {
    mesh.positions.emplace_back(p.x - 0.5, 0.5 - p.y, -3.0);
    mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
  }
  for (std::uint32_t i = 1; i + 1 < polygon.size(); ++i) mesh.triangles.emplace_back(0, i, i + 1);
  Material white;
  white.double_sided = true;
  scene.materials.push_back(white);
  mesh.material = 0;
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back({"polygon", 0, glm::dmat4(1.0), false});
  return scene;
}

/// The camera in the author's coordinates, whatever the origin of the flattened scene.
Camera pixel_camera(const World& world) {
  Camera camera;
  camera.type = Camera::Type::orthographic;
  camera.height = 1.0;
  camera.world_from_camera = glm::translate(glm::dmat4(1.0), -world.origin);
  return camera;
}

Result<std::vector<SubdivisionRow>> subdivide_pixel(const Polygon& polygon) {
  const auto scene = prepare(scene_of(polygon));
  if (!scene) return unexpected(scene.error());
  RenderSettings settings;
  settings.width = 1;
  settings.height = 1;
  settings.method = Method::asos_published;
  settings.asos.max_level = 8;
  settings.asos.eps = 1.0 / 16.0;
  const View view(pixel_camera((*scene)->world()), 1, 1);
  std::vector<SubdivisionRow> rows;
  for (const LevelStatistics& tally : trace_pixel(**scene, view, settings, 0, 0).levels) {
    if (tally.level == 0 || tally.objects.size() != 1) continue;
    const ObjectStatistics& object = tally.objects.front();
    rows.push_back(
        {tally.level, tally.marginal, object.in, object.out, object.change(tally.level)});
  }
  return rows;
}

/// The half-plane to the left of a line at 68 degrees, 0.185 pixels from the pixel's centre.
Polygon one_edge() {
  const double angle = 68.0 * std::numbers::pi / 180.0;
  const glm::dvec2 along(std::cos(angle), std::sin(angle));
  const glm::dvec2 across(-along.y, along.x);
  const glm::dvec2 p = glm::dvec2(0.5) + 0.185 * across;
  return {p - 4.0 * along, p + 4.0 * along, p + 4.0 * (along + across), p + 4.0 * (across - along)};
}

}  // namespace

Result<std::vector<SubdivisionTable>> subdivision_tables() {
  std::vector<SubdivisionTable> tables{
      {"GI'93 table 1: a polygon inside the pixel",
       {{1, 3, 0, 3, 0.75}, {2, 5, 0, 5, 0.3125}, {3, 12, 4, 8, 0.125}, {4, 28, 13, 15, 0.0586}},
       {}},
      {"GI'93 table 2: one edge",
       {{1, 3, 1, 2, 0.25}, {2, 6, 3, 3, 0.0938}, {3, 13, 6, 7, 0.0547}},
       {}}};
  const std::vector<Polygon> polygons{
      {{0.491, 0.351}, {0.600, 0.404}, {0.804, 0.556}, {0.859, 0.903}}, one_edge()};
  for (std::size_t i = 0; i < tables.size(); ++i) {
    auto rows = subdivide_pixel(polygons[i]);
    if (!rows) return unexpected(rows.error());
    tables[i].measured = *std::move(rows);
  }
  return tables;
}

}  // namespace asos
