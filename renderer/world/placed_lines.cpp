#include "renderer/world/placed_lines.h"

#include "renderer/geometry/coordinates.h"
#include "renderer/geometry/direction.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

namespace asos {
namespace {

const Mesh* strokes_of(const Scene& scene, const Instance& instance) {
  if (instance.shape >= 0) return nullptr;
  const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
  return mesh.has_lines() ? &mesh : nullptr;
}

/// Calls `visit` with the vertices that a mesh's lines and points use.
template <typename Visit>
void each_vertex(const Mesh& mesh, Visit visit) {
  for (const glm::uvec2 s : mesh.segments) visit(s.x), visit(s.y);
  for (const std::uint32_t p : mesh.points) visit(p);
}

glm::dvec3 placed(const Instance& instance, glm::vec3 position) {
  return glm::dvec3(instance.world_from_mesh * glm::dvec4(position, 1.0));
}

/// Returns an unlit material with the same colour and emission, for lines and points without
/// normals.
Material unlit_material(const Material& material) {
  Material unlit;
  unlit.name = material.name;
  unlit.base_color = material.base_color;
  unlit.base_color_texture = material.base_color_texture;
  unlit.alpha_mode = material.alpha_mode;
  unlit.alpha_cutoff = material.alpha_cutoff;
  unlit.metallic = 0.0f;
  unlit.double_sided = true;
  unlit.unlit = true;
  unlit.stroke = !material.unlit;
  if (!unlit.stroke) return unlit;
  unlit.emissive = material.emissive;
  unlit.emissive_strength = material.emissive_strength;
  unlit.emissive_texture = material.emissive_texture;
  return unlit;
}

/// Returns a material for lines and points with normals: they have no inside, and no tangents.
Material lit_material(const Material& material) {
  Material lit = material;
  lit.stroke = true;
  lit.double_sided = true;
  lit.transmission = 0.0f;
  lit.transmission_texture = {};
  lit.volume = {};
  lit.diffuse_transmission = {};
  lit.normal_texture = {};
  lit.coat.normal_texture = {};
  lit.anisotropy = {};
  return lit;
}

class Placer {
 public:
  Placer(const Scene& scene, World& world) : scene_(scene), world_(world) {}

  std::string run() {
    world_.lines_and_points.first_part = static_cast<std::uint32_t>(world_.parts.size());
    for (const Instance& instance : scene_.instances) {
      const Mesh* mesh = strokes_of(scene_, instance);
      if (!mesh) continue;
      if (std::string fault = add(instance, *mesh); !fault.empty()) return fault;
    }
    return {};
  }

 private:
  std::string add(const Instance& instance, const Mesh& mesh) {
    bool fits = true;
    each_vertex(mesh, [&](std::uint32_t v) {
      fits = fits && within_reach(placed(instance, mesh.positions[v]) - world_.origin);
    });
    if (!fits)
      return fmt::format("instance '{}' has lines or points that single precision does not reach",
                         instance.name);
    Part part;
    part.name = instance.name.empty() ? mesh.name : instance.name;
    part.lines_and_points = true;
    part.node = instance.node;
    part.material = material(mesh.material, !mesh.normals.empty());
    const auto index = static_cast<std::uint32_t>(world_.parts.size());
    const glm::dmat3 to_world = glm::transpose(glm::inverse(glm::dmat3(instance.world_from_mesh)));
    LinesAndPoints& lines_and_points = world_.lines_and_points;
    for (const glm::uvec2 s : mesh.segments) {
      add_look(mesh, to_world, s, lines_and_points.segments.size(), lines_and_points.segment_looks);
      lines_and_points.segments.push_back(stroke(instance, mesh, s, index));
    }
    for (const std::uint32_t p : mesh.points) {
      add_look(mesh, to_world, glm::uvec2(p), lines_and_points.points.size(),
               lines_and_points.point_looks);
      lines_and_points.points.push_back(stroke(instance, mesh, glm::uvec2(p), index));
    }
    world_.parts.push_back(std::move(part));
    return {};
  }

  LineOrPoint stroke(const Instance& instance, const Mesh& mesh, glm::uvec2 ends,
                     std::uint32_t part) {
    LineOrPoint out;
    out.a = glm::vec3(placed(instance, mesh.positions[ends.x]) - world_.origin);
    out.b = glm::vec3(placed(instance, mesh.positions[ends.y]) - world_.origin);
    if (!mesh.colors.empty()) out.color_a = mesh.colors[ends.x], out.color_b = mesh.colors[ends.y];
    out.part = part;
    world_.lines_and_points.bounds.grow(out.a);
    world_.lines_and_points.bounds.grow(out.b);
    return out;
  }

  /// `stroke` is the index of the segment or point.
  void add_look(const Mesh& mesh, const glm::dmat3& to_world, glm::uvec2 ends, std::size_t stroke,
                std::vector<LineLook>& looks) {
    const bool textured = !mesh.texcoords[0].empty() || !mesh.texcoords[1].empty();
    if (looks.empty() && mesh.normals.empty() && !textured) return;
    looks.resize(stroke + 1);
    for (int end = 0; end < 2; ++end) {
      if (!mesh.normals.empty())
        looks.back().normals[end] =
            unit_or(to_world * glm::dvec3(mesh.normals[ends[end]]), glm::vec3(0.0f));
      for (int set = 0; set < 2; ++set)
        if (!mesh.texcoords[set].empty())
          looks.back().texcoords[set][end] = mesh.texcoords[set][ends[end]];
    }
  }

  /// Returns the index of the world's material for lines and points with or without normals.
  std::uint32_t material(int of_scene, bool has_normals) {
    const auto [known, is_new] = materials_.try_emplace(
        {of_scene, has_normals}, static_cast<std::uint32_t>(world_.materials.size()));
    if (is_new) {
      const std::size_t from =
          of_scene >= 0 ? static_cast<std::size_t>(of_scene) : scene_.materials.size();
      const Material source = world_.materials[from];
      world_.materials.push_back(has_normals && !source.unlit ? lit_material(source)
                                                              : unlit_material(source));
    }
    return known->second;
  }

  const Scene& scene_;
  World& world_;
  // Indices of the world's materials, by the scene's index and whether there are normals.
  std::map<std::pair<int, bool>, std::uint32_t> materials_;
};

}  // namespace

glm::dvec3 origin_of_lines(const Scene& scene) {
  glm::dvec3 lo(std::numeric_limits<double>::infinity()), hi = -lo;
  for (const Instance& instance : scene.instances) {
    const Mesh* mesh = strokes_of(scene, instance);
    if (!mesh) continue;
    each_vertex(*mesh, [&](std::uint32_t v) {
      const glm::dvec3 p = placed(instance, mesh->positions[v]);
      lo = glm::min(lo, p), hi = glm::max(hi, p);
    });
  }
  const glm::dvec3 middle = 0.5 * (lo + hi);
  const bool finite = std::isfinite(middle.x) && std::isfinite(middle.y) && std::isfinite(middle.z);
  return finite ? middle : glm::dvec3(0.0);
}

std::string add_strokes(const Scene& scene, World& world) {
  return Placer(scene, world).run();
}

}  // namespace asos
