#include "renderer/world/world.h"

#include <atomic>
#include <utility>

namespace asos {
namespace {

template <typename Values>
std::size_t bytes_of(const Values& values) {
  return values.capacity() * sizeof(typename Values::value_type);
}

/// Copies some parts of a world, without placements.
class PartCopier {
 public:
  explicit PartCopier(const World& world) : from_(world) {
    to_.origin = world.origin;
    to_.flat = world.flat;
    to_.materials = world.materials;
    to_.textures = world.textures;
    to_.images = world.images;
    to_.cameras = world.cameras;
    to_.lines_and_points = world.lines_and_points;
  }

  void add(const Part& part) {
    Part copy = part;
    const bool placed = part.triangle_count > 0 && from_.is_placed(part.first_triangle);
    copy.first_vertex = static_cast<std::uint32_t>(to_.positions.own_size());
    copy.first_triangle = static_cast<std::uint32_t>(to_.triangles.own_size());
    if (!placed) add_own(part);
    to_.bounds.grow(part.bounds);
    to_.parts.push_back(std::move(copy));
  }

  /// `number_now`: the numbers of the parts, by those before.
  [[nodiscard]] World take(std::span<const std::uint32_t> number_now) {
    for (const ShapeFace& face : from_.faces) {
      if (number_now[face.part] == left_out) continue;
      to_.faces.push_back(face);
      to_.faces.back().part = number_now[face.part];
      to_.triangle_part.push_back(number_now[face.part]);
    }
    LinesAndPoints& lines = to_.lines_and_points;
    if (!lines.empty()) lines.first_part = number_now[lines.first_part];
    for (std::vector<LineOrPoint>* some : {&lines.segments, &lines.points})
      for (LineOrPoint& line : *some) line.part = number_now[line.part];
    to_.positions.reserve(to_.positions.own_size() + 1);  // see World::positions
    to_.set_placements(places(number_now));
    return std::move(to_);
  }
  static constexpr std::uint32_t left_out = ~0u;

 private:
  template <typename T>
  static void add(const Attribute<T>& from, Attribute<T>& to, const Part& part) {
    const std::vector<T>& own = from.own();
    if (own.empty()) return;
    const auto first = own.begin() + part.first_vertex;
    to.own().insert(to.end(), first, first + part.vertex_count);
  }

  void add_own(const Part& part) {
    const auto shift = static_cast<std::uint32_t>(to_.positions.own_size()) - part.first_vertex;
    add(from_.positions, to_.positions, part);
    add(from_.normals, to_.normals, part);
    add(from_.tangents, to_.tangents, part);
    add(from_.texcoords[0], to_.texcoords[0], part);
    add(from_.texcoords[1], to_.texcoords[1], part);
    add(from_.colors, to_.colors, part);
    for (std::uint32_t i = 0; i < part.triangle_count; ++i) {
      to_.triangles.push_back(from_.triangles.own()[part.first_triangle + i] + shift);
      to_.triangle_part.push_back(static_cast<std::uint32_t>(to_.parts.size()));
    }
  }

  [[nodiscard]] std::shared_ptr<const Placements> places(
      std::span<const std::uint32_t> number_now) const {
    if (!from_.placements) return nullptr;
    Placements left = *from_.placements;
    std::erase_if(left.places,
                  [&](const Placement& place) { return number_now[place.part] == left_out; });
    if (left.places.empty()) return nullptr;
    for (Placement& place : left.places) place.part = number_now[place.part];
    left.triangle_count = left.vertex_count = 0;
    number_places(left, to_.parts);
    return std::make_shared<const Placements>(std::move(left));
  }

  const World& from_;
  World to_;
};

}  // namespace

std::uint64_t new_surfaces_id() {
  static std::atomic<std::uint64_t> last{0};
  return last.fetch_add(1, std::memory_order_relaxed) + 1;
}

void World::set_placements(std::shared_ptr<const Placements> placed) {
  if (placed) {
    auto behind = std::make_shared<Placements>(*placed);
    behind->own_triangles = static_cast<std::uint32_t>(triangles.own_size());
    behind->own_vertices = static_cast<std::uint32_t>(positions.own_size());
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

void number_places(Placements& placed, const std::vector<Part>& parts) {
  std::vector<std::uint32_t> triangles, vertices;
  for (Placement& place : placed.places) {
    triangles.push_back(place.first_triangle = placed.triangle_count);
    vertices.push_back(place.first_vertex = placed.vertex_count);
    placed.triangle_count += parts[place.part].triangle_count;
    placed.vertex_count += parts[place.part].vertex_count;
  }
  placed.by_triangle = RangeIndex(std::move(triangles), placed.triangle_count);
  placed.by_vertex = RangeIndex(std::move(vertices), placed.vertex_count);
}

World without_parts(const World& world, std::span<const std::uint8_t> hidden) {
  PartCopier copier(world);
  std::vector<std::uint32_t> number_now;
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < world.parts.size(); ++i) {
    const bool left_out = i < hidden.size() && hidden[i] != 0;
    number_now.push_back(left_out ? PartCopier::left_out : count++);
    if (!left_out) copier.add(world.parts[i]);
  }
  return copier.take(number_now);
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
