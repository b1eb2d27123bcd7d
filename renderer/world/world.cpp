#include "renderer/world/world.h"

#include "renderer/geometry/coordinates.h"
#include "renderer/geometry/direction.h"
#include "renderer/geometry/finite.h"
#include "renderer/load_progress.h"
#include "renderer/scene/tessellate.h"
#include "renderer/scene/validate_scene.h"
#include "renderer/world/origin.h"
#include "renderer/world/placed_lines.h"
#include "renderer/world/placed_mesh.h"
#include "renderer/world/shared_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <span>

namespace asos {

namespace {

unexpected<Error> refuse(const Scene& scene, std::string reason) {
  return unexpected(
      Error{scene.source.empty() ? std::string("scene") : scene.source, std::move(reason)});
}

class Flattener {
 public:
  Flattener(const Scene& scene, std::optional<glm::dvec3> origin, std::uint64_t fewest_copied)
      : scene_(scene), given_origin_(origin), fewest_copied_(fewest_copied) {}
  Flattener(const Scene& scene, glm::dvec3 origin, MeshStore& meshes)
      : scene_(scene), given_origin_(origin), meshes_(&meshes) {}

  Result<FlattenedScene> run(std::uint64_t max_triangles) {
    if (std::string fault = validate_scene(scene_); !fault.empty()) return refuse(scene_, fault);
    if (scene_.instanced_triangles() > max_triangles) {
      return refuse(scene_, fmt::format("has {} triangles; the limit is {}",
                                        scene_.instanced_triangles(), max_triangles));
    }
    choose_meshes();
    std::uint64_t vertices = 0;
    for (const Instance& instance : scene_.instances) {
      if (const PlacedMesh& placed = mesh_of(instance); placed.mesh)
        vertices += placed.vertex_count();
    }
    if (vertices > largest_vertex_count) {
      return refuse(scene_, fmt::format("has {} vertices, more than 32 bits count", vertices));
    }
    if (std::string fault = find_origin(); !fault.empty()) return refuse(scene_, fault);
    reserve();
    for (const Instance& instance : scene_.instances) {
      stop_point();
      add(instance);
    }
    if (!placements_.places.empty()) world_.set_placements(finished(std::move(placements_)));
    // Face numbers follow triangle numbers.
    for (const ShapeFace& face : world_.faces) world_.triangle_part.push_back(face.part);
    add_rest();
    if (std::string fault = add_strokes(scene_, world_); !fault.empty())
      return refuse(scene_, fault);
    std::vector<Light> lights = placed_lights(world_.origin);
    return FlattenedScene{std::move(world_), std::move(lights)};
  }

 private:
  [[nodiscard]] std::size_t index_of(const Instance& instance) const {
    return static_cast<std::size_t>(&instance - scene_.instances.data());
  }
  [[nodiscard]] const PlacedMesh& mesh_of(const Instance& instance) const {
    static const PlacedMesh none;
    if (!faces_[index_of(instance)].empty()) return none;
    return instance.shape >= 0 ? shape_meshes_.at(index_of(instance))
                               : placed_[static_cast<std::size_t>(instance.mesh)];
  }

  void choose_meshes() {
    choose_shapes();
    std::vector<bool> shown(scene_.meshes.size(), false);
    for (const Instance& instance : scene_.instances) {
      if (instance.shape >= 0) continue;
      const auto mesh = static_cast<std::size_t>(instance.mesh);
      shown[mesh] = !scene_.meshes[mesh].triangles.empty();
    }
    placed_.resize(scene_.meshes.size());
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      if (shown[i]) placed_[i] = place(scene_.meshes[i]);
    }
    keep_ = find_attributes(scene_, shown);
    if (meshes_) meshes_->compare(scene_);
    shared_ =
        meshes_ ? shared_instances(scene_, *meshes_) : shared_instances(scene_, fewest_copied_);
  }

  /// Decides whether a shape becomes faces or triangles. Emitters need triangles.
  void choose_shapes() {
    faces_.resize(scene_.instances.size());
    for (const Instance& instance : scene_.instances) {
      if (instance.shape < 0) continue;
      const Shape& shape = scene_.shapes[static_cast<std::size_t>(instance.shape)];
      const std::size_t i = index_of(instance);
      if (!shines(instance)) faces_[i] = place_shape(shape, instance.world_from_mesh);
      if (!faces_[i].empty()) continue;
      Mesh& mesh = *own_meshes_.emplace_back(std::make_unique<Mesh>(tessellated(shape)));
      mesh.material = scene_.meshes[static_cast<std::size_t>(instance.mesh)].material;
      shape_meshes_.emplace(i, place(mesh));
    }
  }

  [[nodiscard]] bool shines(const Instance& instance) const {
    const int material = scene_.meshes[static_cast<std::size_t>(instance.mesh)].material;
    if (material < 0) return false;
    const Material& m = scene_.materials[static_cast<std::size_t>(material)];
    return m.emissive != glm::vec3(0.0f) && m.emissive_strength > 0.0f && !m.unlit;
  }

  /// Finds the origin, near enough to all positions for their floats: see choose_origin.
  std::string find_origin() {
    std::vector<PlacedBox> boxes;
    PlacedBox all;
    for (const Instance& instance : scene_.instances) {
      stop_point();
      const PlacedMesh& placed = mesh_of(instance);
      const std::vector<ShapeFace>& faces = faces_[index_of(instance)];
      if (!placed.mesh && faces.empty()) continue;
      PlacedBox box;
      for (const ShapeFace& face : faces) {
        const FaceBounds bounds = bounds_of(face);
        if (!finite(bounds.lo) || !finite(bounds.hi)) {
          return fmt::format("instance '{}' has a shape that is not finite", instance.name);
        }
        box.grow(bounds.lo);
        box.grow(bounds.hi);
      }
      for (std::size_t i = 0; placed.mesh && i < placed.vertex_count(); ++i) {
        const glm::dvec3 p = glm::dvec3(instance.world_from_mesh *
                                        glm::dvec4(placed.mesh->positions[placed.vertex(i)], 1.0));
        if (!finite(p)) {
          return fmt::format("instance '{}' has positions that are not finite", instance.name);
        }
        box.grow(p);
      }
      all.grow(box.lo);
      all.grow(box.hi);
      boxes.push_back(box);
      if (is_shared(instance)) shared_boxes_.push_back(box);
    }
    if (given_origin_) world_.origin = *given_origin_;
    if (boxes.empty() && !given_origin_) world_.origin = origin_of_lines(scene_);
    if (boxes.empty()) return {};
    given_origin_ ? all.grow(*given_origin_)
                  : void(world_.origin = choose_origin(boxes, all.middle()));
    const double extent = all.extent();
    if (!(extent <= largest_coordinate)) {
      return fmt::format("is {:g} units across, too large for single precision; the limit is {:g}",
                         extent, largest_coordinate);
    }
    return {};
  }

  [[nodiscard]] bool is_shared(const Instance& instance) const {
    return !shared_.empty() && shared_[index_of(instance)] != 0;
  }

  void reserve() {
    std::size_t vertices = 0, triangles = 0;
    for (const Instance& instance : scene_.instances) {
      const PlacedMesh& placed = mesh_of(instance);
      if (!placed.mesh || is_shared(instance)) continue;
      vertices += placed.vertex_count();
      triangles += placed.triangles().size();
    }
    // A ground may follow.
    constexpr std::size_t more = Attribute<glm::vec3>::room_to_grow;
    vertices += more, triangles += more;
    world_.positions.reserve(vertices);
    world_.normals.reserve(vertices);
    if (keep_.tangents) world_.tangents.reserve(vertices);
    for (int set = 0; set < 2; ++set) {
      if (keep_.texcoords[set]) world_.texcoords[set].reserve(vertices);
    }
    if (keep_.colors) world_.colors.reserve(vertices);
    world_.triangles.reserve(triangles);
    world_.triangle_part.reserve(triangles);
  }

  void add(const Instance& instance) {
    if (!faces_[index_of(instance)].empty()) return add_faces(instance);
    const PlacedMesh& placed = mesh_of(instance);
    if (!placed.mesh) return;
    const glm::dmat3 linear = linear_part(instance.world_from_mesh);
    const bool mirrored = glm::determinant(linear) < 0.0;

    Part part = empty_part(instance);
    part.triangle_count = static_cast<std::uint32_t>(placed.triangles().size());
    part.vertex_count = static_cast<std::uint32_t>(placed.vertex_count());
    part.coloured = keep_.colors && is_coloured(*placed.mesh);
    if (is_shared(instance)) return add_place(instance, std::move(part));

    part.bounds = add_positions(placed, instance.world_from_mesh);

    world_.bounds.grow(part.bounds);
    for (glm::uvec3 t : placed.triangles()) {
      t += part.first_vertex;
      // Mirroring turns triangles inside out; glTF keeps their front side, so the winding is
      // reversed.
      if (mirrored) std::swap(t.y, t.z);
      world_.triangles.push_back(t);
      world_.triangle_part.push_back(static_cast<std::uint32_t>(world_.parts.size()));
    }
    if (placed.flat) {
      add_flat_normals(part);
    } else {
      add_normals(placed, linear, mirrored, part);
    }
    add_attributes(placed, linear, mirrored, part);
    world_.parts.push_back(std::move(part));
  }

  [[nodiscard]] std::uint32_t world_material(int material) const {
    return static_cast<std::uint32_t>(material >= 0 ? static_cast<std::size_t>(material)
                                                    : scene_.materials.size());
  }

  [[nodiscard]] Part empty_part(const Instance& instance) const {
    const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(instance.mesh)];
    Part part;
    part.name = instance.name.empty() ? mesh.name : instance.name;
    part.first_triangle = static_cast<std::uint32_t>(world_.triangles.own_size());
    part.first_vertex = static_cast<std::uint32_t>(world_.positions.own_size());
    part.material = world_material(mesh.material);
    part.shows_light = instance.shows_light;
    part.node = instance.node;
    part.surfaces = new_surfaces_id();
    return part;
  }

  /// Adds a part of a mesh that is stored once. Its bounds are those of its vertices, with the same
  /// rounding.
  void add_place(const Instance& instance, Part part) {
    const PlacedBox& box = shared_boxes_[placements_.places.size()];
    part.bounds.grow(glm::vec3(box.lo - world_.origin));
    part.bounds.grow(glm::vec3(box.hi - world_.origin));
    world_.bounds.grow(part.bounds);
    const auto [mesh, added] = mesh_numbers_.try_emplace(instance.mesh, placements_.meshes.size());
    if (added)
      placements_.meshes.push_back(meshes_ ? meshes_->world_of(scene_, instance.mesh)
                                           : shared_mesh(scene_, instance.mesh));
    Placement place = placement_of(instance.world_from_mesh);
    place.mesh = static_cast<std::uint32_t>(mesh->second);
    place.part = static_cast<std::uint32_t>(world_.parts.size());
    placements_.places.push_back(place);
    world_.parts.push_back(std::move(part));
  }

  [[nodiscard]] std::shared_ptr<const Placements> finished(Placements placed) const {
    number_places(placed, world_.parts);
    placed.origin = world_.origin;
    placed.has_tangents = keep_.tangents;
    placed.has_colors = keep_.colors;
    std::copy_n(keep_.texcoords, 2, placed.has_texcoords);
    return std::make_shared<const Placements>(std::move(placed));
  }

  void add_faces(const Instance& instance) {
    Part part = empty_part(instance);
    for (ShapeFace face : faces_[index_of(instance)]) {
      face.origin -= world_.origin;
      face.part = static_cast<std::uint32_t>(world_.parts.size());
      const FaceBounds box = bounds_of(face);
      part.bounds.grow(glm::vec3(box.lo));
      part.bounds.grow(glm::vec3(box.hi));
      world_.faces.push_back(face);
      ++part.face_count;
    }
    world_.bounds.grow(part.bounds);
    world_.parts.push_back(std::move(part));
  }

  Box add_positions(const PlacedMesh& placed, const glm::dmat4& world_from_mesh) {
    Box bounds;
    for (std::size_t i = 0; i < placed.vertex_count(); ++i) {
      const glm::dvec4 p(placed.mesh->positions[placed.vertex(i)], 1.0);
      const glm::vec3 q(glm::dvec3(world_from_mesh * p) - world_.origin);
      world_.positions.push_back(q);
      bounds.grow(q);
    }
    return bounds;
  }

  void add_normals(const PlacedMesh& placed, const glm::dmat3& linear, bool mirrored,
                   const Part& part) {
    const glm::dmat3 cofactors = cofactors_of(linear, mirrored);
    bool all_known = true;
    for (std::size_t i = 0; i < placed.vertex_count(); ++i) {
      const glm::vec3 n = placed.mesh->normals[placed.vertex(i)];
      // After a singular matrix, the normal may have no direction; the author's own is the best
      // guess.
      const glm::vec3 unit =
          unit_or(cofactors * glm::dvec3(n), unit_or(glm::dvec3(n), glm::vec3(0.0f)));
      all_known &= unit != glm::vec3(0.0f);
      world_.normals.push_back(unit);
    }
    if (!all_known) replace_unknown_normals(part);
  }

  /// Replaces vertex normals that are zero or not finite by those of their triangles, weighted by
  /// area.
  void replace_unknown_normals(const Part& part) {
    std::vector<glm::dvec3> sums(part.vertex_count, glm::dvec3(0.0));
    for (std::uint32_t t = 0; t < part.triangle_count; ++t) {
      const glm::uvec3 v = world_.triangles[part.first_triangle + t];
      const glm::dvec3 a(world_.positions[v.x]), b(world_.positions[v.y]), c(world_.positions[v.z]);
      const glm::dvec3 cross = glm::cross(b - a, c - a);
      for (int k = 0; k < 3; ++k) sums[v[k] - part.first_vertex] += cross;
    }
    for (std::uint32_t i = 0; i < part.vertex_count; ++i) {
      glm::vec3& n = world_.normals[part.first_vertex + i];
      if (n == glm::vec3(0.0f)) n = unit_or(sums[i], glm::vec3(0, 0, 1));
    }
  }

  void add_flat_normals(const Part& part) {
    for (std::uint32_t t = 0; t < part.triangle_count; ++t) {
      const glm::uvec3 v = world_.triangles[part.first_triangle + t];
      const glm::dvec3 a(world_.positions[v.x]), b(world_.positions[v.y]), c(world_.positions[v.z]);
      const glm::vec3 n = unit_or(glm::cross(b - a, c - a), glm::vec3(0, 0, 1));
      world_.normals.insert(world_.normals.end(), 3, n);
    }
  }

  void add_attributes(const PlacedMesh& placed, const glm::dmat3& linear, bool mirrored,
                      const Part& part) {
    const Mesh& mesh = *placed.mesh;
    const std::size_t n = placed.vertex_count();
    for (std::size_t i = 0; keep_.tangents && i < n; ++i) {
      glm::vec4 t(0.0f);
      if (!mesh.tangents.empty()) {
        const glm::vec3 across = any_perpendicular(world_.normals[part.first_vertex + i]);
        const glm::vec4 s = mesh.tangents[placed.vertex(i)];
        t = glm::vec4(unit_or(linear * glm::dvec3(s), across), mirrored ? -s.w : s.w);
      }
      world_.tangents.push_back(t);
    }
    for (int set = 0; set < 2; ++set) {
      const std::vector<glm::vec2>& uv = mesh.texcoords[set];
      for (std::size_t i = 0; keep_.texcoords[set] && i < n; ++i) {
        world_.texcoords[set].push_back(uv.empty() ? glm::vec2(0.0f) : uv[placed.vertex(i)]);
      }
    }
    for (std::size_t i = 0; keep_.colors && i < n; ++i) {
      world_.colors.push_back(mesh.colors.empty() ? glm::vec4(1.0f)
                                                  : mesh.colors[placed.vertex(i)]);
    }
  }

  void add_rest() {
    world_.materials = scene_.materials;
    world_.materials.emplace_back();
    world_.materials.back().name = "default";
    world_.textures = scene_.textures;
    world_.images = scene_.images;
    world_.cameras = scene_.cameras;
    for (Camera& camera : world_.cameras) {
      camera.world_from_camera[3] -= glm::dvec4(world_.origin, 0.0);
    }
  }

  [[nodiscard]] std::vector<Light> placed_lights(glm::dvec3 origin) const {
    std::vector<Light> lights = scene_.lights;
    for (Light& light : lights) {
      light.position -= origin;
      for (std::vector<glm::dvec3>& outline : light.outlines) {
        for (glm::dvec3& corner : outline) corner -= origin;
      }
    }
    return lights;
  }

  const Scene& scene_;
  const std::optional<glm::dvec3> given_origin_;
  const std::uint64_t fewest_copied_ = never_shared;
  MeshStore* const meshes_ = nullptr;
  World world_;
  std::vector<std::uint8_t> shared_;         // by instance, 1: its mesh is stored once; or empty
  std::vector<PlacedBox> shared_boxes_;      // bounding boxes of the shared instances
  std::map<int, std::size_t> mesh_numbers_;  // index in placements_, by mesh
  Placements placements_;
  std::vector<std::vector<ShapeFace>> faces_;       // one per instance; empty: drawn as triangles
  std::vector<std::unique_ptr<Mesh>> own_meshes_;   // of shapes drawn as triangles
  std::map<std::size_t, PlacedMesh> shape_meshes_;  // by instance
  std::vector<PlacedMesh> placed_;  // one per mesh; `mesh` is null where no instance is visible
  Attributes keep_;
};

}  // namespace

Result<FlattenedScene> flatten(const Scene& scene, std::uint64_t max_triangles,
                               std::optional<glm::dvec3> origin, std::uint64_t fewest_copied) {
  return Flattener(scene, origin, fewest_copied).run(max_triangles);
}

Result<FlattenedScene> flatten(const Scene& scene, std::uint64_t max_triangles, glm::dvec3 origin,
                               MeshStore& meshes) {
  return Flattener(scene, origin, meshes).run(max_triangles);
}

}  // namespace asos
