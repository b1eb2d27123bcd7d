#include "renderer/scene/validate_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace asos {
namespace {

bool in_range(int index, std::size_t size) {
  return index >= -1 && (index < 0 || static_cast<std::size_t>(index) < size);
}

bool valid_mesh(const Mesh& mesh) {
  const std::size_t n = mesh.positions.size();
  const auto fits = [n](std::size_t size) { return size == 0 || size == n; };
  if (n > largest_vertex_count || !fits(mesh.normals.size()) || !fits(mesh.tangents.size()) ||
      !fits(mesh.texcoords[0].size()) || !fits(mesh.texcoords[1].size()) ||
      !fits(mesh.colors.size())) {
    return false;
  }
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [n](glm::uvec3 t) { return t.x < n && t.y < n && t.z < n; }) &&
         std::all_of(mesh.segments.begin(), mesh.segments.end(),
                     [n](glm::uvec2 s) { return s.x < n && s.y < n; }) &&
         std::all_of(mesh.points.begin(), mesh.points.end(),
                     [n](std::uint32_t p) { return p < n; });
}

bool valid_textures(const Scene& scene, const Material& m) {
  for (const TextureUse* use : texture_uses(m)) {
    if (!in_range(use->texture, scene.textures.size()) || use->texcoord < 0 || use->texcoord > 1) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::string validate_scene(const Scene& scene) {
  for (const Mesh& mesh : scene.meshes) {
    if (!valid_mesh(mesh)) return fmt::format("mesh '{}' has mismatched arrays", mesh.name);
    if (!in_range(mesh.material, scene.materials.size())) {
      return fmt::format("mesh '{}' has a material that does not exist", mesh.name);
    }
  }
  for (const Instance& instance : scene.instances) {
    if (instance.mesh < 0 || !in_range(instance.mesh, scene.meshes.size())) {
      return fmt::format("instance '{}' has a mesh that does not exist", instance.name);
    }
    if (!in_range(instance.shape, scene.shapes.size())) {
      return fmt::format("instance '{}' has a shape that does not exist", instance.name);
    }
  }
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    if (const std::string fault = validate_shape(scene.shapes[i]); !fault.empty())
      return fmt::format("shape {} is none: {}", i, fault);
  }
  for (const Material& material : scene.materials) {
    if (!valid_textures(scene, material)) {
      return fmt::format("material '{}' has a texture that does not exist", material.name);
    }
  }
  for (const Texture& texture : scene.textures) {
    if (!in_range(texture.image, scene.images.size())) {
      return fmt::format("texture '{}' has an image that does not exist", texture.name);
    }
  }
  return {};
}

}  // namespace asos
