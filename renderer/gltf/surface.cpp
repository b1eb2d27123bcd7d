#include "renderer/gltf/surface.h"

#include "renderer/geometry/direction.h"
#include "renderer/geometry/finite.h"
#include "renderer/load_progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asos::gltf {

namespace {

glm::dvec3 face_normal(const VertexData& data, glm::uvec3 t) {
  const glm::dvec3 a(data.positions[t.x]), b(data.positions[t.y]), c(data.positions[t.z]);
  return glm::cross(b - a, c - a);
}

template <typename T>
void gather(std::vector<T>& values, const std::vector<glm::uvec3>& triangles) {
  if (values.empty()) return;
  std::vector<T> out;
  out.reserve(triangles.size() * 3);
  for (const glm::uvec3 t : triangles)
    out.insert(out.end(), {values[t.x], values[t.y], values[t.z]});
  values = std::move(out);
}

void make_flat(VertexData& data, std::vector<glm::uvec3>& triangles) {
  data.tangents.clear();
  gather(data.positions, triangles);
  gather(data.texcoords[0], triangles);
  gather(data.texcoords[1], triangles);
  gather(data.colors, triangles);
  data.normals.clear();
  data.normals.reserve(data.positions.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto first = static_cast<std::uint32_t>(3 * i);
    triangles[i] = {first, first + 1, first + 2};
    data.normals.insert(data.normals.end(), 3,
                        unit_or(face_normal(data, triangles[i]), glm::vec3(0, 0, 1)));
  }
}

/// Derivatives of the position along the texture's u and against its v (glTF's bitangent points up
/// in the picture, while v points down).
struct UvFrame {
  glm::dvec3 along_u{0.0}, against_v{0.0};
};

UvFrame uv_frame(const VertexData& data, const std::vector<glm::vec2>& uv, const glm::mat3& to_map,
                 glm::uvec3 t) {
  const auto map = [&](std::uint32_t v) { return glm::dvec2(to_map * glm::vec3(uv[v], 1.0f)); };
  const glm::dvec3 p0(data.positions[t.x]);
  const glm::dvec3 e1 = glm::dvec3(data.positions[t.y]) - p0;
  const glm::dvec3 e2 = glm::dvec3(data.positions[t.z]) - p0;
  const glm::dvec2 d1 = map(t.y) - map(t.x), d2 = map(t.z) - map(t.x);
  // The inverse of [d1 d2] without the determinant's absolute value, so that each triangle is
  // weighted by area.
  const double sign = d1.x * d2.y - d1.y * d2.x < 0.0 ? -1.0 : 1.0;
  if (d1.x * d2.y - d1.y * d2.x == 0.0) return {};
  return {sign * (d2.y * e1 - d1.y * e2), -sign * (d1.x * e2 - d2.x * e1)};
}

/// Returns the texture use whose u defines a material's tangents.
const TextureUse& tangents_use(const Material& material) {
  if (material.normal_texture.used()) return material.normal_texture;
  if (material.coat.normal_texture.used()) return material.coat.normal_texture;
  return material.anisotropy.texture;
}

void make_tangents(VertexData& data, const std::vector<glm::uvec3>& triangles,
                   const TextureUse& use) {
  const std::vector<glm::vec2>& uv = data.texcoords[use.texcoord];
  std::vector<UvFrame> frames(data.positions.size());
  constexpr std::size_t between_stops = std::size_t{1} << 14;
  for (std::size_t i = 0; i < triangles.size() && !uv.empty(); ++i) {
    if (i % between_stops == 0) stop_point();
    const glm::uvec3 t = triangles[i];
    const UvFrame face = uv_frame(data, uv, use.uv_transform, t);
    for (const std::uint32_t v : {t.x, t.y, t.z}) {
      frames[v].along_u += face.along_u;
      frames[v].against_v += face.against_v;
    }
  }
  data.tangents.clear();
  data.tangents.reserve(frames.size());
  for (std::size_t v = 0; v < frames.size(); ++v) {
    if (v % between_stops == 0) stop_point();
    const glm::dvec3 n(data.normals[v]);
    const glm::dvec3 t = frames[v].along_u - n * glm::dot(n, frames[v].along_u);
    const double side = glm::dot(glm::cross(n, t), frames[v].against_v);
    data.tangents.emplace_back(unit_or(t, any_perpendicular(data.normals[v])),
                               side < 0.0 ? -1.0f : 1.0f);
  }
}

}  // namespace

std::size_t drop_infinite(VertexData& data, std::vector<glm::uvec3>& triangles) {
  std::vector<bool> bad;
  for (std::size_t v = 0; v < data.positions.size(); ++v) {
    if (finite(data.positions[v])) continue;
    bad.resize(data.positions.size(), false);
    bad[v] = true;
    data.positions[v] = glm::vec3(0.0f);
  }
  if (bad.empty()) return 0;
  return std::erase_if(triangles, [&](glm::uvec3 t) { return bad[t.x] || bad[t.y] || bad[t.z]; });
}

void complete_normals(VertexData& data, std::vector<glm::uvec3>& triangles,
                      const std::string& place, Warnings& warnings) {
  if (data.normals.empty()) {
    make_flat(data, triangles);
    return;
  }
  std::vector<std::size_t> broken;
  std::size_t far_from_unit = 0;
  for (std::size_t v = 0; v < data.normals.size(); ++v) {
    glm::vec3& n = data.normals[v];
    const float length = glm::length(n);
    if (!finite(n) || !(length > 1e-12f)) {
      broken.push_back(v);
    } else {
      if (std::abs(length - 1.0f) > 0.05f) ++far_from_unit;
      n = unit_or(glm::dvec3(n), n);
    }
  }
  if (far_from_unit > 0) {
    warnings.add(fmt::format("{}: {} normals were not normalised", place, far_from_unit));
  }
  if (broken.empty()) return;
  warnings.add(
      fmt::format("{}: {} normals are zero or not finite; made anew", place, broken.size()));
  std::vector<glm::dvec3> sums(data.normals.size(), glm::dvec3(0.0));
  for (const glm::uvec3 t : triangles) {
    const glm::dvec3 n = face_normal(data, t);
    sums[t.x] += n, sums[t.y] += n, sums[t.z] += n;
  }
  for (const std::size_t v : broken) data.normals[v] = unit_or(sums[v], glm::vec3(0, 0, 1));
}

void complete_tangents(VertexData& data, const std::vector<glm::uvec3>& triangles,
                       const Material& material, const std::string& place, Warnings& warnings) {
  const TextureUse& use = tangents_use(material);
  const bool no_texcoords = data.texcoords[use.texcoord].empty();
  if (no_texcoords && has_normal_map(material)) {
    warnings.add(
        fmt::format("{}: its normal map needs TEXCOORD_{}, which is missing", place, use.texcoord));
  } else if (no_texcoords && data.tangents.empty()) {
    warnings.add(
        fmt::format("{}: its anisotropy needs tangents or TEXCOORD_{}, and both are missing; "
                    "highlights are round",
                    place, use.texcoord));
    return;
  }
  const auto broken = [](glm::vec4 t) {
    return !finite(glm::vec3(t)) || glm::length(glm::vec3(t)) < 1e-12f || std::abs(t.w) != 1.0f;
  };
  if (data.tangents.empty()) {
    make_tangents(data, triangles, use);
  } else if (std::any_of(data.tangents.begin(), data.tangents.end(), broken)) {
    warnings.add(place + ": it has tangents that are not valid; all are made anew");
    make_tangents(data, triangles, use);
  }
  for (glm::vec4& t : data.tangents) t = glm::vec4(glm::normalize(glm::vec3(t)), t.w);
}

}  // namespace asos::gltf
