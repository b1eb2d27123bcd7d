#include "renderer/api/convert.h"
#include "renderer/api/scene_impl.h"
#include "renderer/geometry/coordinates.h"
#include "renderer/geometry/finite.h"
#include "renderer/geometry/validate_camera.h"
#include "renderer/gltf/surface.h"
#include "renderer/scene/tessellate.h"
#include "renderer/scene/validate_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace asos::api {

struct SceneBuilder::Impl {
  asos::Scene scene;
};

namespace {

Error invalid(std::string subject, std::string reason) {
  return failure(ErrorCode::invalid_argument, std::move(subject), std::move(reason));
}

bool exists(int number, std::size_t count) {
  return number >= 0 && static_cast<std::size_t>(number) < count;
}

/// The first factor of a material that is out of range; empty: none.
std::string material_fault(const Material& m) {
  struct Factor {
    const char* name;
    float value;
    float lo = 0.0f;
    float hi = 1.0f;
  };
  constexpr float most = std::numeric_limits<float>::max();
  for (const Factor& f :
       {Factor{"base_color", m.base_color[0]}, Factor{"base_color", m.base_color[1]},
        Factor{"base_color", m.base_color[2]}, Factor{"base_color", m.base_color[3]},
        Factor{"metallic", m.metallic}, Factor{"roughness", m.roughness},
        Factor{"emissive", m.emissive[0], 0.0f, most},
        Factor{"emissive", m.emissive[1], 0.0f, most},
        Factor{"emissive", m.emissive[2], 0.0f, most}, Factor{"ior", m.ior, 1.0f, most},
        Factor{"transmission", m.transmission}, Factor{"thickness", m.thickness, 0.0f, most}})
    if (!(f.value >= f.lo && f.value <= f.hi))
      return f.hi == most ? fmt::format("{} {} is not {} or more", f.name, f.value, f.lo)
                          : fmt::format("{} {} is not from {} to {}", f.name, f.value, f.lo, f.hi);
  return {};
}

/// `values` as vectors; none where their number or a value is wrong.
template <int n>
std::optional<std::vector<glm::vec<n, float>>> vectors_of(std::span<const float> values) {
  if (values.size() % n != 0) return std::nullopt;
  std::vector<glm::vec<n, float>> vectors(values.size() / n);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) return std::nullopt;
    vectors[i / n][static_cast<int>(i % n)] = values[i];
  }
  return vectors;
}

/// Reads one attribute into `to`. Returns its fault; empty: none.
template <int n>
std::string read_attribute(const char* name, std::span<const float> from, std::size_t vertices,
                           std::vector<glm::vec<n, float>>& to) {
  auto vectors = vectors_of<n>(from);
  if (!vectors)
    return fmt::format("{} are not {} finite values for each vertex", name, static_cast<int>(n));
  if (!vectors->empty() && vectors->size() != vertices)
    return fmt::format("{} are of {} vertices, positions of {}", name, vectors->size(), vertices);
  to = *std::move(vectors);
  return {};
}

std::string read_normals(const MeshData& data, gltf::VertexData& vertices) {
  std::string fault =
      read_attribute<3>("normals", data.normals, vertices.positions.size(), vertices.normals);
  for (glm::vec3& normal : vertices.normals) {
    const double length = glm::length(glm::dvec3(normal));
    if (!(length > 0.0)) return "a normal has length 0";
    normal = glm::vec3(glm::dvec3(normal) / length);
  }
  return fault;
}

std::string read_colors(const MeshData& data, gltf::VertexData& vertices) {
  std::string fault =
      read_attribute<4>("colors", data.colors, vertices.positions.size(), vertices.colors);
  for (const float value : data.colors)
    if (fault.empty() && !(value >= 0.0f && value <= 1.0f))
      fault = fmt::format("colors have a value {}, which is not from 0 to 1", value);
  return fault;
}

/// Reads the vertices and triangles of a mesh. Returns their fault; empty: none.
std::string read_mesh(const MeshData& data, gltf::VertexData& vertices,
                      std::vector<glm::uvec3>& triangles) {
  auto positions = vectors_of<3>(data.positions);
  if (!positions) return "positions are not three finite values for each vertex";
  if (positions->size() > largest_vertex_count) return "there are too many vertices";
  vertices.positions = *std::move(positions);
  const std::size_t count = vertices.positions.size();
  for (const glm::vec3& p : vertices.positions)
    if (!within_reach(p))
      return fmt::format("a position is farther away than {:g}", largest_coordinate);
  if (std::string fault = read_normals(data, vertices); !fault.empty()) return fault;
  if (std::string fault =
          read_attribute<2>("texcoords", data.texcoords, count, vertices.texcoords[0]);
      !fault.empty())
    return fault;
  if (std::string fault = read_colors(data, vertices); !fault.empty()) return fault;
  if (data.triangles.empty() || data.triangles.size() % 3 != 0)
    return "triangles are not three vertices each";
  for (std::size_t i = 0; i < data.triangles.size(); i += 3) {
    const glm::uvec3 t(data.triangles[i], data.triangles[i + 1], data.triangles[i + 2]);
    if (t.x >= count || t.y >= count || t.z >= count)
      return fmt::format("triangle {} has a vertex that does not exist", i / 3);
    triangles.push_back(t);
  }
  return {};
}

Result<asos::Shape> shape_of(const Shape& shape) {
  using Type = asos::Shape::Type;
  constexpr std::array types{Type::sphere, Type::disk, Type::box, Type::cylinder};
  const auto number = static_cast<std::size_t>(shape.type);
  if (number >= types.size()) return invalid("shape", "has an unknown type");
  asos::Shape of;
  of.type = types[number];
  of.radius = shape.radius;
  of.size = vector_of(shape.size);
  of.height = shape.height;
  of.radius_bottom = shape.radius_bottom;
  of.radius_top = shape.radius_top;
  if (std::string fault = validate_shape(of); !fault.empty())
    return invalid("shape", std::move(fault));
  return of;
}

}  // namespace

SceneBuilder::SceneBuilder(std::string name) : impl_(std::make_unique<Impl>()) {
  impl_->scene.source = name;
  impl_->scene.name = std::move(name);
}
SceneBuilder::SceneBuilder(SceneBuilder&&) noexcept = default;
SceneBuilder& SceneBuilder::operator=(SceneBuilder&&) noexcept = default;
SceneBuilder::~SceneBuilder() = default;

Result<int> SceneBuilder::add_image(int width, int height, std::span<const std::uint8_t> rgba) {
  return guarded("image", [&]() -> Result<int> {
    if (width < 1 || height < 1 ||
        rgba.size() / 4 / static_cast<std::size_t>(width) != static_cast<std::size_t>(height) ||
        rgba.size() % (4 * static_cast<std::size_t>(width)) != 0)
      return invalid("image", fmt::format("{} bytes are not 4 for each of {}x{} pixels",
                                          rgba.size(), width, height));
    asos::Scene& scene = impl_->scene;
    Texture texture;
    texture.image = static_cast<int>(scene.images.size());
    scene.images.push_back({fmt::format("image {}", scene.images.size()), width, height,
                            SharedBytes(std::vector<std::uint8_t>(rgba.begin(), rgba.end()))});
    scene.textures.push_back(texture);
    return texture.image;
  });
}

Result<int> SceneBuilder::add_material(const Material& m) {
  return guarded("material", [&]() -> Result<int> {
    asos::Scene& scene = impl_->scene;
    std::string fault = material_fault(m);
    if (m.base_color_image != -1 && !exists(m.base_color_image, scene.images.size()))
      fault = fmt::format("image {} does not exist", m.base_color_image);
    if (!fault.empty()) return invalid("material '" + m.name + "'", std::move(fault));
    asos::Material of;
    of.name = m.name;
    of.base_color = {m.base_color[0], m.base_color[1], m.base_color[2], m.base_color[3]};
    of.base_color_texture.texture = m.base_color_image;
    of.metallic = m.metallic;
    of.roughness = m.roughness;
    of.emissive = vector_of(m.emissive);
    of.ior = m.ior;
    of.transmission = m.transmission;
    of.volume.thickness = m.thickness;
    of.alpha_mode = m.blended ? AlphaMode::blend : AlphaMode::opaque;
    of.double_sided = m.double_sided;
    of.unlit = m.unlit;
    scene.materials.push_back(std::move(of));
    return static_cast<int>(scene.materials.size()) - 1;
  });
}

Result<int> SceneBuilder::add_mesh(const MeshData& data, int material) {
  return guarded("mesh", [&]() -> Result<int> {
    asos::Scene& scene = impl_->scene;
    gltf::VertexData vertices;
    std::vector<glm::uvec3> triangles;
    std::string fault = exists(material, scene.materials.size())
                            ? read_mesh(data, vertices, triangles)
                            : fmt::format("material {} does not exist", material);
    if (!fault.empty()) return invalid("mesh '" + data.name + "'", std::move(fault));
    gltf::Warnings none;
    if (vertices.normals.empty()) gltf::complete_normals(vertices, triangles, data.name, none);
    Mesh mesh;
    mesh.name = data.name;
    mesh.positions = std::move(vertices.positions);
    mesh.normals = std::move(vertices.normals);
    mesh.texcoords[0] = std::move(vertices.texcoords[0]);
    mesh.colors = std::move(vertices.colors);
    mesh.triangles = std::move(triangles);
    mesh.material = material;
    scene.meshes.push_back(std::move(mesh));
    return static_cast<int>(scene.meshes.size()) - 1;
  });
}

Result<void> SceneBuilder::place_mesh(int mesh, const Matrix4& world_from_mesh,
                                      const std::string& name) {
  return guarded("mesh", [&]() -> Result<void> {
    asos::Scene& scene = impl_->scene;
    if (!exists(mesh, scene.meshes.size()))
      return invalid(fmt::format("mesh {}", mesh), "does not exist");
    const std::string& called =
        name.empty() ? scene.meshes[static_cast<std::size_t>(mesh)].name : name;
    if (!is_affine(world_from_mesh))
      return invalid("mesh '" + called + "'", "its matrix is not affine");
    scene.instances.push_back({called, mesh, matrix_of(world_from_mesh)});
    return {};
  });
}

Result<void> SceneBuilder::place_shape(const Shape& shape, int material,
                                       const Matrix4& world_from_shape, const std::string& name) {
  return guarded("shape", [&]() -> Result<void> {
    asos::Scene& scene = impl_->scene;
    Result<asos::Shape> converted = shape_of(shape);
    if (!converted) return converted.error();
    if (!exists(material, scene.materials.size()))
      return invalid("shape '" + name + "'", fmt::format("material {} does not exist", material));
    if (!is_affine(world_from_shape))
      return invalid("shape '" + name + "'", "its matrix is not affine");
    Mesh mesh = tessellated(*converted);
    mesh.name = name;
    mesh.material = material;
    Instance instance{name, static_cast<int>(scene.meshes.size()), matrix_of(world_from_shape)};
    instance.shape = static_cast<int>(scene.shapes.size());
    scene.meshes.push_back(std::move(mesh));
    scene.shapes.push_back(*converted);
    scene.instances.push_back(std::move(instance));
    return {};
  });
}

Result<void> SceneBuilder::add_light(const Light& light) {
  return guarded("light", [&]() -> Result<void> {
    Result<asos::Light> converted = light_of(light);
    if (!converted) return converted.error();
    impl_->scene.lights.push_back(*std::move(converted));
    return {};
  });
}

Result<void> SceneBuilder::add_camera(const Camera& camera) {
  return guarded("camera", [&]() -> Result<void> {
    asos::Camera converted = camera_of(camera, glm::dvec3(0.0));
    if (std::string fault = validate_camera(converted); !fault.empty())
      return invalid("camera '" + camera.name + "'", std::move(fault));
    impl_->scene.cameras.push_back(std::move(converted));
    return {};
  });
}

Result<Scene> SceneBuilder::build() const {
  return guarded("scene", [&]() -> Result<Scene> {
    if (std::string fault = validate_scene(impl_->scene); !fault.empty())
      return invalid(impl_->scene.name, std::move(fault));
    auto prepared = prepare(impl_->scene);
    if (!prepared) return failure(ErrorCode::invalid_argument, prepared.error());
    return Scene(std::make_shared<const Scene::Impl>(Scene::Impl{*std::move(prepared)}));
  });
}

}  // namespace asos::api
