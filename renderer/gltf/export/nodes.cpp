#include "renderer/gltf/export/gltf_writer.h"

#include <algorithm>

namespace asos::exporting {

using nlohmann::json;

namespace {

constexpr int float_type = 5126, uint_type = 5125;
constexpr int points_mode = 0, lines_mode = 1;
constexpr int vertex_target = 34962, index_target = 34963;

/// Writes doubles with all their digits, so that nothing is rounded.
json matrix_json(const glm::dmat4& m) {
  json out = json::array();
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) out.push_back(m[column][row]);
  }
  return out;
}

int write_positions(const Mesh& mesh, GltfDocument& document) {
  glm::vec3 lo = mesh.positions[0], hi = lo;
  for (const glm::vec3& p : mesh.positions) lo = glm::min(lo, p), hi = glm::max(hi, p);
  const int accessor = document.add_accessor(mesh.positions, "VEC3", float_type, vertex_target);
  json& out = document.root["accessors"][static_cast<std::size_t>(accessor)];
  out["min"] = {lo.x, lo.y, lo.z};
  out["max"] = {hi.x, hi.y, hi.z};
  return accessor;
}

json mesh_json(const Mesh& mesh, GltfDocument& document) {
  json primitive;
  json& attributes = primitive["attributes"];
  const auto attribute = [&](const char* name, const auto& values, const char* type) {
    if (values.empty()) return;
    attributes[name] = document.add_accessor(values, type, float_type, vertex_target);
  };
  attributes["POSITION"] = write_positions(mesh, document);
  attribute("NORMAL", mesh.normals, "VEC3");
  attribute("TANGENT", mesh.tangents, "VEC4");
  attribute("TEXCOORD_0", mesh.texcoords[0], "VEC2");
  attribute("TEXCOORD_1", mesh.texcoords[1], "VEC2");
  attribute("COLOR_0", mesh.colors, "VEC4");
  // Write the indices as plain numbers, for triangles, lines or points.
  std::vector<std::uint32_t> indices = mesh.points;
  indices.reserve(3 * mesh.triangles.size());
  for (const glm::uvec3& t : mesh.triangles) indices.insert(indices.end(), {t.x, t.y, t.z});
  for (const glm::uvec2& s : mesh.segments) indices.insert(indices.end(), {s.x, s.y});
  if (!mesh.points.empty()) primitive["mode"] = points_mode;
  if (!mesh.segments.empty()) primitive["mode"] = lines_mode;
  primitive["indices"] = document.add_accessor(indices, "SCALAR", uint_type, index_target);
  if (mesh.material >= 0) primitive["material"] = mesh.material;
  json out{{"primitives", json::array({primitive})}};
  if (!mesh.name.empty()) out["name"] = mesh.name;
  return out;
}

json lens_json(const Lens& lens) {
  json out{{"aperture", lens.radius}};
  if (lens.focus) out["focus"] = *lens.focus;
  if (lens.blades > 0) out["blades"] = lens.blades;
  if (lens.turn_rad != 0.0) out["blade_turn"] = lens.turn_rad;
  return out;
}

json camera_json(const Camera& camera) {
  json out;
  if (!camera.name.empty()) out["name"] = camera.name;
  if (camera.type == Camera::Type::perspective) {
    // glTF asks for a near plane.
    double near = camera.near_depth.value_or(0.0);
    if (near <= 0.0) near = std::min(0.01, 0.5 * camera.far_depth.value_or(1.0));
    out["type"] = "perspective";
    out["perspective"] = {{"yfov", camera.fov_y_rad}, {"znear", near}};
    if (camera.far_depth) out["perspective"]["zfar"] = *camera.far_depth;
    if (camera.aspect_ratio) out["perspective"]["aspectRatio"] = *camera.aspect_ratio;
    if (camera.lens.blurs()) out["extras"]["asos_lens"] = lens_json(camera.lens);
  } else {
    const double half = 0.5 * camera.height;
    out["type"] = "orthographic";
    out["orthographic"] = {{"xmag", half * camera.aspect_ratio.value_or(1.0)},
                           {"ymag", half},
                           {"znear", camera.near_depth.value_or(0.0)},
                           {"zfar", camera.far_depth.value_or(1e6)}};
  }
  return out;
}

/// Returns the sizes of a shape by their names in KHR_implicit_shapes and in extras.
json sizes_json(const Shape& shape) {
  switch (shape.type) {
    case Shape::Type::sphere:
    case Shape::Type::disk:
      return {{"radius", shape.radius}};
    case Shape::Type::box:
      return {{"size", {shape.size.x, shape.size.y, shape.size.z}}};
    case Shape::Type::cylinder:
      break;
  }
  return {{"height", shape.height},
          {"radiusBottom", shape.radius_bottom},
          {"radiusTop", shape.radius_top}};
}

const char* type_name(Shape::Type type) {
  switch (type) {
    case Shape::Type::sphere:
      return "sphere";
    case Shape::Type::disk:
      return "disk";
    case Shape::Type::box:
      return "box";
    case Shape::Type::cylinder:
      break;
  }
  return "cylinder";
}

/// Writes the shapes that KHR_implicit_shapes supports. Returns each shape's index there, or -1.
std::vector<int> write_shapes(const Scene& scene, GltfDocument& document) {
  std::vector<int> index_of;
  for (const Shape& shape : scene.shapes) {
    index_of.push_back(-1);
    if (shape.type == Shape::Type::disk) continue;
    document.use_extension("KHR_implicit_shapes");
    document.use_extension("ASOS_implicit_shape");
    json& shapes = document.root["extensions"]["KHR_implicit_shapes"]["shapes"];
    const char* type = type_name(shape.type);
    shapes.push_back({{"type", type}, {type, sizes_json(shape)}});
    index_of.back() = static_cast<int>(shapes.size()) - 1;
  }
  return index_of;
}

}  // namespace

json named_node(const std::string& name) {
  return name.empty() ? json::object() : json{{"name", name}};
}

void write_meshes(const Scene& scene, GltfDocument& document) {
  // glTF has no empty meshes: a mesh without content is omitted, and its instances stay as nodes.
  std::vector<int> mesh_of(scene.meshes.size(), -1);
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    if (scene.meshes[i].triangles.empty() && !scene.meshes[i].has_lines()) continue;
    mesh_of[i] = document.add("meshes", mesh_json(scene.meshes[i], document));
  }
  const std::vector<int> shape_of = write_shapes(scene, document);
  for (const Instance& instance : scene.instances) {
    json node = named_node(instance.name);
    const int mesh = mesh_of[static_cast<std::size_t>(instance.mesh)];
    if (mesh >= 0) node["mesh"] = mesh;
    if (instance.world_from_mesh != glm::dmat4(1.0)) {
      node["matrix"] = matrix_json(instance.world_from_mesh);
    }
    if (instance.shows_light) node["extras"]["asos_light_fallback"] = true;
    if (instance.shape >= 0) {
      const auto number = static_cast<std::size_t>(instance.shape);
      const Shape& shape = scene.shapes[number];
      if (shape_of[number] >= 0)
        node["extensions"]["ASOS_implicit_shape"]["shape"] = shape_of[number];
      json& extras = node["extras"]["asos_shape"];
      extras = sizes_json(shape);
      extras["type"] = type_name(shape.type);
    }
    document.add_root_node(std::move(node));
  }
}

void write_cameras(const Scene& scene, GltfDocument& document) {
  for (const Camera& camera : scene.cameras) {
    json node = named_node(camera.name);
    node["camera"] = document.add("cameras", camera_json(camera));
    node["matrix"] = matrix_json(camera.world_from_camera);
    document.add_root_node(std::move(node));
  }
}

}  // namespace asos::exporting
