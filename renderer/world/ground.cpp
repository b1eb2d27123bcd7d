#include "renderer/world/ground.h"

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace asos {
namespace {

constexpr const char* ground_name = "ground";
constexpr std::uint32_t plate_corners = 48;
constexpr double below_in_radii = 2e-4;

Material ground_material(Ground ground) {
  Material material;
  material.name = ground_name;
  material.metallic = 0.0f;
  material.base_color = {ground_albedo, ground_albedo, ground_albedo, 1.0f};
  material.specular = 0.0f;
  material.double_sided = true;
  if (ground != Ground::mirror) return material;
  // Like varnish: it reflects a tenth of the light at normal incidence, and sharply at grazing
  // angles.
  material.base_color = {0.22f, 0.22f, 0.22f, 1.0f};
  material.specular = 1.0f;
  material.ior = 1.9f;
  material.roughness = 0.0f;
  material.dfr.emplace().rgb.fill({0.1, 1.0, 8.0});
  return material;
}

void add_vertex(World& world, glm::vec3 position) {
  world.positions.push_back(position);
  world.normals.emplace_back(0, 1, 0);
  if (!world.tangents.empty()) world.tangents.emplace_back(1, 0, 0, 1);
  for (auto& texcoords : world.texcoords)
    if (!texcoords.empty()) texcoords.emplace_back(0.0f);
  if (!world.colors.empty()) world.colors.emplace_back(1.0f);
}

/// Returns the ground plate; null where there is none.
const Part* plate_of(const World& world) {
  if (world.solid_parts() == 0 || world.materials.empty()) return nullptr;
  const Part& last = world.parts[world.solid_parts() - 1];
  const bool made_here = last.name == ground_name && last.triangle_count == plate_corners &&
                         last.vertex_count == plate_corners + 1 &&
                         last.material + 1 == world.materials.size() &&
                         world.materials.back().name == ground_name;
  return made_here ? &last : nullptr;
}

/// Moves the first part of lines and points by `parts`.
void shift_lines(World& world, std::uint32_t parts) {
  if (world.lines_and_points.empty()) return;
  world.lines_and_points.first_part += parts;
  for (std::vector<LineOrPoint>* lines_and_points :
       {&world.lines_and_points.segments, &world.lines_and_points.points})
    for (LineOrPoint& stroke : *lines_and_points) stroke.part += parts;
}

/// Returns the plate's centre, followed by its corners.
std::vector<glm::vec3> plate_vertices(const Box& around, std::optional<double> floor) {
  const glm::dvec3 lo(around.lo), hi(around.hi);
  const double scene_radius = 0.5 * glm::length(hi - lo);
  const double height = floor.value_or(lo.y) - below_in_radii * scene_radius;
  const glm::dvec3 middle(0.5 * (lo.x + hi.x), height, 0.5 * (lo.z + hi.z));
  std::vector<glm::vec3> vertices{glm::vec3(middle)};
  for (std::uint32_t i = 0; i < plate_corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / plate_corners;
    const glm::dvec3 outward(std::sin(angle), 0.0, std::cos(angle));
    vertices.emplace_back(middle + ground_radii * scene_radius * outward);
  }
  return vertices;
}

/// Returns the same of the ground that a world has.
std::vector<glm::vec3> present_vertices(const World& world, const Part& plate) {
  std::vector<glm::vec3> vertices;
  for (std::uint32_t i = 0; i < plate.vertex_count; ++i)
    vertices.push_back(world.positions[plate.first_vertex + i]);
  return vertices;
}

void take_ground_away(World& world) {
  const Part* plate = plate_of(world);
  if (!plate) return;
  const Box bounds = bounds_without_ground(world);
  const auto first = static_cast<std::ptrdiff_t>(plate->first_triangle);
  const std::size_t vertices = plate->first_vertex;
  world.triangles.resize(plate->first_triangle);
  world.triangle_part.erase(world.triangle_part.begin() + first,
                            world.triangle_part.begin() + first + plate_corners);
  world.positions.resize(vertices);
  world.normals.resize(vertices);
  if (!world.tangents.empty()) world.tangents.resize(vertices);
  for (auto& texcoords : world.texcoords)
    if (!texcoords.empty()) texcoords.resize(vertices);
  if (!world.colors.empty()) world.colors.resize(vertices);
  world.materials.pop_back();
  world.parts.erase(world.parts.begin() + static_cast<std::ptrdiff_t>(world.solid_parts()) - 1);
  world.bounds = bounds;
  shift_lines(world, static_cast<std::uint32_t>(-1));
  world.set_placements(world.placements);
}

}  // namespace

Ground ground_of(const World& world) {
  if (!plate_of(world)) return Ground::off;
  return world.materials.back().dfr ? Ground::mirror : Ground::on;
}

Box bounds_without_ground(const World& world) {
  const Part* plate = plate_of(world);
  if (!plate && world.lines_and_points.empty()) return world.bounds;
  Box bounds;
  for (const Part& part : std::span(world.parts).first(world.solid_parts()))
    if (&part != plate) bounds.grow(part.bounds);
  return bounds;
}

std::size_t objects_without_ground(const World& world) {
  return world.solid_parts() - (plate_of(world) ? 1 : 0);
}

std::size_t parts_without_ground(const World& world) {
  return world.parts.size() - (plate_of(world) ? 1 : 0);
}

std::size_t materials_without_ground(const World& world) {
  return world.materials.size() - (plate_of(world) ? 1 : 0);
}

std::size_t triangles_without_ground(const World& world) {
  return world.triangles.size() - (plate_of(world) ? plate_corners : 0);
}

MaterialDfrs dfrs_without_ground(const World& world) {
  MaterialDfrs dfrs = dfrs_of(world);
  dfrs.resize(materials_without_ground(world));
  return dfrs;
}

void put_on_ground(World& world, Ground ground, std::optional<double> floor, const World* as,
                   const Box& around) {
  take_ground_away(world);
  const Box bounds = around.empty() ? world.bounds : around;
  if (ground == Ground::off || bounds.empty()) return;
  if (!(glm::length(glm::dvec3(bounds.hi) - glm::dvec3(bounds.lo)) > 0.0)) return;

  Part part;
  part.name = ground_name;
  part.first_triangle = static_cast<std::uint32_t>(world.triangles.own_size());
  part.triangle_count = plate_corners;
  part.first_vertex = static_cast<std::uint32_t>(world.positions.own_size());
  part.vertex_count = plate_corners + 1;
  part.material = static_cast<std::uint32_t>(world.materials.size());
  part.surfaces = new_surfaces_id();
  world.materials.push_back(ground_material(ground));

  // Make a fan, so that no triangle is longer than the plate is wide.
  const Part* other = as ? plate_of(*as) : nullptr;
  const auto vertices = other ? present_vertices(*as, *other) : plate_vertices(bounds, floor);
  for (const glm::vec3 vertex : vertices) add_vertex(world, vertex);
  for (std::size_t i = 1; i < vertices.size(); ++i) part.bounds.grow(vertices[i]);
  const auto index = static_cast<std::uint32_t>(world.solid_parts());
  const auto first = static_cast<std::ptrdiff_t>(world.triangles.own_size());
  world.triangle_part.insert(world.triangle_part.begin() + first, plate_corners, index);
  for (std::uint32_t i = 0; i < plate_corners; ++i)
    world.triangles.push_back(part.first_vertex +
                              glm::uvec3(0, 1 + i, 1 + (i + 1) % plate_corners));
  world.bounds.grow(part.bounds);
  world.parts.insert(world.parts.begin() + index, std::move(part));
  shift_lines(world, 1);
  world.set_placements(world.placements);
}

}  // namespace asos
