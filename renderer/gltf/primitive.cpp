#include "renderer/gltf/primitive.h"

#include "renderer/geometry/direction.h"
#include "renderer/geometry/finite.h"
#include "renderer/gltf/skin.h"
#include "renderer/gltf/surface.h"
#include "renderer/gltf/values.h"
#include "renderer/gltf/vertices.h"
#include "renderer/load_progress.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <vector>

namespace asos::gltf {
namespace {

/// Returns whether a primitive's mode is points or lines.
[[nodiscard]] constexpr bool is_line_or_point(int mode) {
  return mode >= 0 && mode <= 3;
}

std::vector<glm::uvec3> strokes_of(int mode, const std::vector<std::uint32_t>& indices) {
  std::vector<glm::uvec3> lines_and_points;
  const std::size_t n = indices.size();
  lines_and_points.reserve(drawn_count(mode, n));
  const auto join = [&](std::size_t i, std::size_t k) {
    lines_and_points.emplace_back(indices[i], indices[k], indices[k]);
  };
  if (mode == TINYGLTF_MODE_POINTS) {
    for (std::size_t i = 0; i < n; ++i) join(i, i);
  } else if (mode == TINYGLTF_MODE_LINE) {
    for (std::size_t i = 0; i + 1 < n; i += 2) join(i, i + 1);
  } else {
    for (std::size_t i = 0; i + 1 < n; ++i) join(i, i + 1);
    if (mode == TINYGLTF_MODE_LINE_LOOP && n > 1) join(n - 1, 0);
  }
  return lines_and_points;
}

// Returns the triangles of glTF's modes 4 to 6 (triangles, strip, fan) over `indices`, all with
// the winding of the specification. Extra vertices are ignored. In modes 0 to 3 (points, lines,
// loop, strip), a segment is a triangle whose last two corners are equal, and a point is one whose
// three corners are equal.
std::vector<glm::uvec3> triangles_of(int mode, const std::vector<std::uint32_t>& indices) {
  if (is_line_or_point(mode)) return strokes_of(mode, indices);
  std::vector<glm::uvec3> triangles;
  const std::size_t n = indices.size();
  if (n < 3) return triangles;
  triangles.reserve(drawn_count(mode, n));
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    for (std::size_t i = 0; i + 2 < n; i += 3) {
      triangles.emplace_back(indices[i], indices[i + 1], indices[i + 2]);
    }
  } else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
    // Every second triangle of a strip has the opposite winding.
    for (std::size_t i = 0; i + 2 < n; ++i) {
      triangles.emplace_back(indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]);
    }
  } else {
    for (std::size_t i = 0; i + 2 < n; ++i) {
      triangles.emplace_back(indices[i + 1], indices[i + 2], indices[0]);
    }
  }
  return triangles;
}

constexpr std::size_t most_vertices = 0xfffffffeu;

const tinygltf::Value* draco_extension(const tinygltf::Primitive& primitive) {
  return extension(primitive.extensions, "KHR_draco_mesh_compression");
}

std::optional<int> attribute(const tinygltf::Primitive& primitive, const char* name) {
  const auto found = primitive.attributes.find(name);
  if (found == primitive.attributes.end()) return std::nullopt;
  return found->second;
}

/// Decodes the primitive's Draco stream, if it has one. If the file also has the plain data, a
/// stream that does not decode only gives a warning.
Checked<std::optional<DracoPrimitive>> decode_draco(const PrimitiveRequest& request,
                                                    Accessors& accessors, Warnings& warnings) {
  const tinygltf::Value* ext = draco_extension(request.primitive);
  if (!ext) return std::optional<DracoPrimitive>();
  const Checked<std::uint64_t> elements = element_count(request.primitive, accessors);
  if (!elements) return fault(elements.error());
  // Without indices, the number of faces of a strip is not declared; it is at most one per vertex.
  Checked<DracoPrimitive> decoded =
      DracoPrimitive::decode(*ext, accessors, drawn_count(request.primitive.mode, *elements) * 3);
  if (decoded) return std::optional<DracoPrimitive>(std::move(*decoded));
  const std::optional<int> positions = attribute(request.primitive, "POSITION");
  if (!positions || !accessors.has_data(*positions)) return fault(decoded.error());
  warnings.add(
      fmt::format("{}: {}; its uncompressed data is used", request.place, decoded.error()));
  return std::optional<DracoPrimitive>();
}

/// Returns the name of a mode's elements.
const char* pieces_of(int mode) {
  if (mode == TINYGLTF_MODE_POINTS) return "points";
  return is_line_or_point(mode) ? "line segments" : "triangles";
}

/// Returns triangles; segments and points are encoded as in `triangles_of`.
Checked<std::vector<glm::uvec3>> read_triangles(const PrimitiveRequest& request,
                                                const std::optional<DracoPrimitive>& draco,
                                                Accessors& accessors, std::size_t vertices,
                                                Warnings& warnings) {
  if (draco) return triangles_of(TINYGLTF_MODE_TRIANGLES, draco->indices());
  std::vector<std::uint32_t> indices;
  if (const auto accessor = attribute(request.primitive, Document::indices_attribute)) {
    Checked<std::vector<std::uint32_t>> read = accessors.integers(*accessor, 1);
    if (!read) return fault("its indices: " + read.error());
    indices = std::move(*read);
    const std::uint32_t reserved = accessors.largest_integer(*accessor);
    if (std::find(indices.begin(), indices.end(), reserved) != indices.end()) {
      warnings.add(
          fmt::format("{}: it uses index {}, which glTF reserves", request.place, reserved));
    }
  } else {
    indices.resize(vertices);
    std::iota(indices.begin(), indices.end(), 0u);
  }
  if (request.primitive.mode == TINYGLTF_MODE_TRIANGLES && indices.size() % 3 != 0) {
    warnings.add(fmt::format("{}: {} vertices are left over from its last triangle", request.place,
                             indices.size() % 3));
  }
  if (request.primitive.mode == TINYGLTF_MODE_LINE && indices.size() % 2 != 0)
    warnings.add(fmt::format("{}: a vertex is left over from its last line", request.place));
  return triangles_of(request.primitive.mode, indices);
}

/// Normalizes the normals of lines and points, or sets them to 0 if they have no direction, since
/// there is no surface to compute them from.
void unify_normals(VertexData& data, const std::string& place, Warnings& warnings) {
  std::size_t broken = 0;
  for (glm::vec3& n : data.normals) {
    n = finite(n) ? unit_or(glm::dvec3(n), glm::vec3(0.0f)) : glm::vec3(0.0f);
    broken += n == glm::vec3(0.0f) ? 1 : 0;
  }
  if (broken > 0)
    warnings.add(
        fmt::format("{}: {} normals are zero or not finite; they face the viewer", place, broken));
}

/// Returns a mesh of lines or points, which have no tangents.
Mesh line_mesh(int mode, VertexData&& data, const std::vector<glm::uvec3>& lines_and_points) {
  Mesh mesh;
  mesh.positions = std::move(data.positions);
  mesh.normals = std::move(data.normals);
  mesh.texcoords[0] = std::move(data.texcoords[0]);
  mesh.texcoords[1] = std::move(data.texcoords[1]);
  mesh.colors = std::move(data.colors);
  for (const glm::uvec3 s : lines_and_points) {
    if (mode == TINYGLTF_MODE_POINTS)
      mesh.points.push_back(s.x);
    else
      mesh.segments.emplace_back(s.x, s.y);
  }
  return mesh;
}

/// Selects the vertices that triangles use, if these are far fewer than all: files often share one
/// large buffer among thousands of primitives.
Selection select_used(std::vector<glm::uvec3>& triangles, std::size_t vertices) {
  if (triangles.size() >= vertices / 6) return std::nullopt;
  std::vector<std::uint32_t> used;
  used.reserve(triangles.size() * 3);
  for (const glm::uvec3 t : triangles) used.insert(used.end(), {t.x, t.y, t.z});
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  const auto place_of = [&](std::uint32_t v) {
    return static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
  };
  for (glm::uvec3& t : triangles) t = {place_of(t.x), place_of(t.y), place_of(t.z)};
  return used;
}

void check_texcoords(const PrimitiveRequest& request, const VertexData& data, Warnings& warnings) {
  if (!request.material) return;
  for (const TextureUse* use : texture_uses(*request.material)) {
    // Without coordinates a normal map has no directions, either; the check of tangents reports
    // that.
    if (use == &request.material->normal_texture || use == &request.material->coat.normal_texture ||
        use == &request.material->anisotropy.texture)
      continue;
    if (!use->used() || !data.texcoords[use->texcoord].empty()) continue;
    warnings.add(fmt::format("{}: its textures need TEXCOORD_{}, which is missing", request.place,
                             use->texcoord));
  }
}

}  // namespace

std::uint64_t drawn_count(int mode, std::uint64_t elements) {
  switch (mode) {
    case TINYGLTF_MODE_POINTS:
      return elements;
    case TINYGLTF_MODE_LINE:
      return elements / 2;
    case TINYGLTF_MODE_LINE_LOOP:
      return elements < 2 ? 0 : elements;
    case TINYGLTF_MODE_LINE_STRIP:
      return elements < 2 ? 0 : elements - 1;
    case TINYGLTF_MODE_TRIANGLES:
      return elements / 3;
    default:
      return elements < 3 ? 0 : elements - 2;
  }
}

Checked<std::uint64_t> element_count(const tinygltf::Primitive& primitive, Accessors& accessors) {
  std::optional<int> accessor = attribute(primitive, Document::indices_attribute);
  if (!accessor) accessor = attribute(primitive, "POSITION");
  if (!accessor) return fault("it has no positions");
  // A Draco stream replaces the accessor's data, so only the declared number counts.
  if (draco_extension(primitive)) return accessors.declared_count(*accessor);
  return accessors.count(*accessor);
}

std::string declared_faults(const tinygltf::Primitive& primitive, Accessors& accessors) {
  if (draco_extension(primitive)) return {};
  if (const auto elements = element_count(primitive, accessors); !elements) {
    return elements.error();
  }
  std::map<std::size_t, std::string> lengths;
  const auto add = [&](const std::string& name, int accessor) -> std::string {
    if (name == Document::indices_attribute) return {};
    const Checked<std::size_t> count = accessors.count(accessor);
    if (count) lengths.emplace(*count, name);
    return count ? std::string() : fmt::format("{}: {}", name, count.error());
  };
  for (const auto& [name, accessor] : primitive.attributes) {
    if (std::string text = add(name, accessor); !text.empty()) return text;
  }
  for (const auto& target : primitive.targets) {
    for (const auto& [name, accessor] : target) {
      if (std::string text = add("morphed " + name, accessor); !text.empty()) return text;
    }
  }
  if (lengths.size() > 1) return "its attributes differ in length";
  return {};
}

Checked<LoadedMesh> load_primitive(const PrimitiveRequest& request, Accessors& accessors,
                                   Warnings& warnings) {
  if (is_line_or_point(request.primitive.mode) && draco_extension(request.primitive))
    return fault("it is compressed by Draco, which knows triangles only");
  const auto draco = decode_draco(request, accessors, warnings);
  if (!draco) return fault(draco.error());
  AttributeSource source(request, *draco ? &**draco : nullptr, accessors, warnings);
  const Checked<std::size_t> vertices = source.vertex_count();
  if (!vertices) return fault(vertices.error());
  if (*vertices > most_vertices) return fault("it has more vertices than 32 bits count");

  // Triangles come first, since they select the vertices.
  auto triangles = read_triangles(request, *draco, accessors, *vertices, warnings);
  if (!triangles) return fault(triangles.error());
  const std::size_t declared = triangles->size();
  std::erase_if(*triangles, [&](glm::uvec3 t) {
    return t.x >= *vertices || t.y >= *vertices || t.z >= *vertices;
  });
  if (triangles->size() < declared) {
    warnings.add_loss(fmt::format("{}: {} of {} {} use vertices that do not exist; dropped",
                                  request.place, declared - triangles->size(), declared,
                                  pieces_of(request.primitive.mode)));
  }
  const Selection used = select_used(*triangles, *vertices);
  Checked<VertexData> data = source.read(used);
  if (!data) return fault(data.error());

  LoadedMesh loaded;
  if (request.skin) loaded.offset = apply_skin(*data, *triangles, request, warnings);
  if (const std::size_t dropped = drop_infinite(*data, *triangles); dropped > 0) {
    warnings.add_loss(
        fmt::format("{}: {} of {} {} have positions that are not finite; "
                    "dropped",
                    request.place, dropped, declared, pieces_of(request.primitive.mode)));
  }
  if (is_line_or_point(request.primitive.mode)) {
    unify_normals(*data, request.place, warnings);
    check_texcoords(request, *data, warnings);
    loaded.mesh = line_mesh(request.primitive.mode, std::move(*data), *triangles);
    return loaded;
  }
  stop_point();
  complete_normals(*data, *triangles, request.place, warnings);
  stop_point();
  check_texcoords(request, *data, warnings);
  if (request.material && needs_tangents(*request.material)) {
    complete_tangents(*data, *triangles, *request.material, request.place, warnings);
  } else {
    data->tangents.clear();
  }
  Mesh& mesh = loaded.mesh;
  mesh.positions = std::move(data->positions);
  mesh.normals = std::move(data->normals);
  mesh.tangents = std::move(data->tangents);
  mesh.texcoords[0] = std::move(data->texcoords[0]);
  mesh.texcoords[1] = std::move(data->texcoords[1]);
  mesh.colors = std::move(data->colors);
  mesh.triangles = std::move(*triangles);
  return loaded;
}

}  // namespace asos::gltf
