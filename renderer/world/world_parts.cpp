#include "renderer/world/world.h"

#include <utility>

namespace asos {
namespace {

template <typename Values>
std::size_t bytes_of(const Values& values) {
  return values.capacity() * sizeof(typename Values::value_type);
}

}  // namespace

void World::set_placements(std::shared_ptr<const Placements> placed) {
  if (placed) {
    auto behind = std::make_shared<Placements>(*placed);
    behind->own_triangles = static_cast<std::uint32_t>(triangles.own().size());
    behind->own_vertices = static_cast<std::uint32_t>(positions.own().size());
    for (const Placement& place : behind->places) {
      parts[place.part].first_triangle = behind->own_triangles + place.first_triangle;
      parts[place.part].first_vertex = behind->own_vertices + place.first_vertex;
    }
    placed = std::move(behind);
  }
  const std::size_t vertices = placed ? placed->vertex_count : 0;
  const std::size_t more_triangles = placed ? placed->triangle_count : 0;
  positions.set_placed(placed, vertices, placed_position);
  normals.set_placed(placed, vertices, placed_normal);
  tangents.set_placed(placed, placed && placed->has_tangents ? vertices : 0, placed_tangent);
  texcoords[0].set_placed(placed, placed && placed->has_texcoords[0] ? vertices : 0,
                          placed_texcoord_0);
  texcoords[1].set_placed(placed, placed && placed->has_texcoords[1] ? vertices : 0,
                          placed_texcoord_1);
  colors.set_placed(placed, placed && placed->has_colors ? vertices : 0, placed_color);
  triangles.set_placed(placed, more_triangles, placed_triangle);
  triangle_part.set_placed(placed, more_triangles, placed_part);
  placements = std::move(placed);
}

MaterialDfrs dfrs_of(const World& world) {
  MaterialDfrs dfrs;
  for (const Material& material : world.materials) dfrs.push_back(material.dfr);
  return dfrs;
}

World without_placements(const World& world) {
  World own = world;
  own.set_placements(nullptr);
  if (!world.placements) return own;
  for (const Placement& place : world.placements->places) {
    Part& part = own.parts[place.part];
    part.first_triangle = part.triangle_count = part.first_vertex = part.vertex_count = 0;
  }
  return own;
}

std::size_t geometry_bytes(const World& world) {
  std::size_t bytes = bytes_of(world.positions.own()) + bytes_of(world.normals.own()) +
                      bytes_of(world.tangents.own()) + bytes_of(world.texcoords[0].own()) +
                      bytes_of(world.texcoords[1].own()) + bytes_of(world.colors.own()) +
                      bytes_of(world.triangles.own()) + bytes_of(world.triangle_part.own()) +
                      bytes_of(world.parts);
  return bytes + (world.placements ? world.placements->memory_bytes() : 0);
}

}  // namespace asos
