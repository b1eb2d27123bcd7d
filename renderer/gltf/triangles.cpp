#include "renderer/gltf/triangles.h"

#include "renderer/gltf/primitive.h"

namespace asos::gltf {

namespace {

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

}  // namespace

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

}  // namespace asos::gltf
