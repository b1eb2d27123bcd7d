#include "renderer/geometry/finite.h"
#include "renderer/gltf/export/gltf_writer.h"
#include "renderer/gltf/validate_light.h"
#include "renderer/scene/environment_cube.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos::exporting {

namespace {

template <typename T>
bool all_finite(const std::vector<T>& vectors) {
  return std::all_of(vectors.begin(), vectors.end(), [](const T& v) { return finite(v); });
}

bool within(double value, double lo, double hi) {
  return value >= lo && value <= hi;  // false for NaN
}

bool index_into(int index, std::size_t size) {
  return index >= 0 && static_cast<std::size_t>(index) < size;
}

constexpr double huge = std::numeric_limits<float>::max();

std::string mesh_fault(const Mesh& mesh, const Scene& scene) {
  const std::size_t count = mesh.positions.size();
  const auto fits = [count](const auto& values) {
    return values.empty() || values.size() == count;
  };
  if (!fits(mesh.normals) || !fits(mesh.tangents) || !fits(mesh.texcoords[0]) ||
      !fits(mesh.texcoords[1]) || !fits(mesh.colors)) {
    return "has attributes of different lengths";
  }
  if (!all_finite(mesh.positions) || !all_finite(mesh.normals) || !all_finite(mesh.tangents) ||
      !all_finite(mesh.texcoords[0]) || !all_finite(mesh.texcoords[1]) ||
      !all_finite(mesh.colors)) {
    return "holds a number that is not finite";
  }
  for (const glm::uvec3& t : mesh.triangles) {
    if (std::max({t.x, t.y, t.z}) >= count) return "has an index beyond its vertices";
  }
  const auto beyond = [count](std::uint32_t v) { return v >= count; };
  const bool segments_beyond =
      std::any_of(mesh.segments.begin(), mesh.segments.end(),
                  [&](glm::uvec2 s) { return beyond(s.x) || beyond(s.y); });
  if (segments_beyond || std::any_of(mesh.points.begin(), mesh.points.end(), beyond))
    return "has an index beyond its vertices";
  if (mesh.material != -1 && !index_into(mesh.material, scene.materials.size())) {
    return fmt::format("uses material {}, which does not exist", mesh.material);
  }
  return {};
}

std::string texture_fault(const TextureUse& use, const Scene& scene) {
  if (!use.used()) return {};
  if (!index_into(use.texture, scene.textures.size())) {
    return fmt::format("uses texture {}, which does not exist", use.texture);
  }
  if (use.texcoord < 0 || use.texcoord > 1) {
    return fmt::format("uses texture coordinates {}; there are 0 and 1", use.texcoord);
  }
  if (!std::isfinite(use.scale)) return "has a texture strength that is not finite";
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) {
      if (!std::isfinite(use.uv_transform[c][r])) {
        return "has a texture transform that is not finite";
      }
    }
  }
  if (!decompose(use.uv_transform)) {
    return "has a texture transform with shear, which KHR_texture_transform cannot express";
  }
  return {};
}

std::string dfr_fault(const Dfr& dfr) {
  for (const DfrCurve& curve : dfr.rgb) {
    if (!within(curve.min, 0.0, 1.0) || !within(curve.max, 0.0, 1.0))
      return "has a defocusing ratio outside 0 to 1";
    if (!within(curve.exponent, 0.0, std::numeric_limits<double>::max()))
      return "has a defocusing exponent that is no positive number";
  }
  if (!within(dfr.perturbation, 0.0, 1.0)) return "has a perturbation outside 0 to 1";
  return {};
}

std::string volume_fault(const Volume& volume) {
  if (!within(volume.thickness, 0.0, huge)) return "has a thickness that is no positive number";
  if (!(volume.attenuation_distance > 0.0f)) return "has an attenuation distance of 0 or less";
  if (!within(volume.dispersion, 0.0, huge)) return "has a dispersion that is no positive number";
  for (int i = 0; i < 3; ++i) {
    if (!within(volume.attenuation_color[i], 0.0, 1.0))
      return "has an attenuation colour outside 0 to 1";
  }
  return {};
}

std::string material_fault(const Material& m, const Scene& scene) {
  for (int i = 0; i < 4; ++i) {
    if (!within(m.base_color[i], 0.0, 1.0)) return "has a base colour outside 0 to 1";
  }
  if (!within(m.metallic, 0.0, 1.0) || !within(m.roughness, 0.0, 1.0)) {
    return "has a metallic or roughness factor outside 0 to 1";
  }
  for (int i = 0; i < 3; ++i) {
    if (!within(m.emissive[i], 0.0, huge)) return "has an emission that is no positive number";
  }
  const double brightest = std::max({m.emissive.x, m.emissive.y, m.emissive.z, 1.0f});
  if (!within(m.emissive_strength, 0.0, huge / brightest)) {
    return "has an emission that is no positive number";
  }
  if (!within(m.alpha_cutoff, 0.0, huge)) return "has an alpha cut-off that is no positive number";
  if (m.ior != 0.0f && !within(m.ior, 1.0, huge)) return "has an index of refraction below 1";
  if (!within(m.transmission, 0.0, 1.0)) return "has a transmission outside 0 to 1";
  if (!within(m.diffuse_transmission.factor, 0.0, 1.0))
    return "has a diffuse transmission outside 0 to 1";
  for (int i = 0; i < 3; ++i) {
    if (!within(m.diffuse_transmission.color[i], 0.0, 1.0))
      return "has a diffuse transmission's colour outside 0 to 1";
  }
  if (std::string fault = volume_fault(m.volume); !fault.empty()) return fault;
  if (!within(m.specular, 0.0, 1.0)) return "has a specular factor outside 0 to 1";
  for (int i = 0; i < 3; ++i) {
    if (!within(m.specular_color[i], 0.0, huge))
      return "has a specular colour that is no positive number";
  }
  if (m.dfr) {
    if (std::string fault = dfr_fault(*m.dfr); !fault.empty()) return fault;
  }
  for (const TextureUse* use : texture_uses(m)) {
    if (std::string fault = texture_fault(*use, scene); !fault.empty()) return fault;
  }
  return {};
}

std::string image_fault(const Image& image) {
  // The encoder counts bytes in an int.
  constexpr std::uint64_t most_bytes = 1u << 30;
  if (image.width <= 0 || image.height <= 0) return "is empty";
  const std::uint64_t bytes =
      4ull * static_cast<std::uint64_t>(image.width) * static_cast<std::uint64_t>(image.height);
  if (bytes > most_bytes) return "is too large to be encoded as PNG";
  if (image.rgba.size() != bytes || (!image.low.empty() && image.low.size() != bytes))
    return "does not have width times height pixels";
  return {};
}

std::string surroundings_fault(const EnvironmentCube& surroundings) {
  for (const EnvironmentCube::Side& side : surroundings.sides) {
    if (const std::string why = image_fault(side.image); !why.empty()) return why;
    if (side.image.width != side.image.height) return "is not square";
  }
  return {};
}

std::string validate_camera(const Camera& camera) {
  if (!finite(camera.world_from_camera)) return "is placed by a matrix that is not finite";
  if (camera.aspect_ratio && !within(*camera.aspect_ratio, 1e-9, 1e9)) {
    return "has an aspect ratio that is no positive number";
  }
  if (camera.type == Camera::Type::perspective) {
    const bool valid = camera.fov_y_rad > 0.0 && camera.fov_y_rad < 3.14159265358979;
    return valid ? "" : "has a field of view outside 0 to 180 degrees";
  }
  return camera.height > 0.0 && std::isfinite(camera.height) ? "" : "has no positive height";
}

/// Returns "mesh 3 'lamp' has ..." for the first element of a list with a fault.
template <typename List, typename Fault>
std::string first_fault(const char* what, const List& list, Fault fault) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (const std::string why = fault(list[i]); !why.empty()) {
      return fmt::format("{} {} '{}' {}", what, i, list[i].name, why);
    }
  }
  return {};
}

}  // namespace

std::string why_not_exportable(const Scene& scene) {
  const auto texture_fault_of = [&scene](const Texture& texture) {
    return std::string(index_into(texture.image, scene.images.size()) ? "" : "has no image");
  };
  const auto instance_fault = [&scene](const Instance& instance) -> std::string {
    if (!index_into(instance.mesh, scene.meshes.size())) return "places a mesh that does not exist";
    if (instance.shape != -1 && !index_into(instance.shape, scene.shapes.size()))
      return "places a shape that does not exist";
    if (instance.shape >= 0) {
      const Shape& shape = scene.shapes[static_cast<std::size_t>(instance.shape)];
      if (const std::string why = validate_shape(shape); !why.empty())
        return "places a shape that is none: " + why;
    }
    return finite(instance.world_from_mesh) ? "" : "is placed by a matrix that is not finite";
  };
  const auto of_scene = [&scene](auto fault) {
    return [&scene, fault](const auto& element) { return fault(element, scene); };
  };
  for (const std::string& why : {first_fault("image", scene.images, image_fault),
                                 first_fault("texture", scene.textures, texture_fault_of),
                                 first_fault("material", scene.materials, of_scene(material_fault)),
                                 first_fault("mesh", scene.meshes, of_scene(mesh_fault)),
                                 first_fault("instance", scene.instances, instance_fault),
                                 first_fault("light", scene.lights, gltf::validate_light),
                                 first_fault("camera", scene.cameras, validate_camera)}) {
    if (!why.empty()) return why;
  }
  if (!scene.surroundings) return {};
  const std::string why = surroundings_fault(*scene.surroundings);
  return why.empty() ? why : "a side of the surroundings " + why;
}

}  // namespace asos::exporting
