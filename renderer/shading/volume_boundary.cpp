#include "renderer/shading/volume_boundary.h"

#include "renderer/rays/back_face.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

const Material& material_of(const World& world, std::uint32_t part) {
  return world.materials[world.parts[part].material];
}

// Returns the volume of a part's box, by which nested volumes are sorted; infinite if unknown.
double size_of(const World& world, std::uint32_t part) {
  const Box& box = world.parts[part].bounds;
  if (box.empty()) return std::numeric_limits<double>::infinity();
  const glm::dvec3 size = glm::dvec3(box.hi) - glm::dvec3(box.lo);
  return size.x * size.y * size.z;
}

// Returns whether a box contains a point, within the rounding error of single precision.
bool holds(const World& world, std::uint32_t part, glm::vec3 p) {
  constexpr float rounding = 1e-5f;
  const Box& box = world.parts[part].bounds;
  if (box.empty()) return true;
  const glm::vec3 room =
      rounding * glm::max(box.hi - box.lo, glm::max(glm::abs(box.lo), glm::abs(box.hi)));
  return glm::all(glm::lessThanEqual(box.lo - room, p)) &&
         glm::all(glm::lessThanEqual(p, box.hi + room));
}

void remove(NestedVolumes& volumes, std::uint32_t part) {
  auto& parts = volumes.parts;
  const auto end = std::remove(parts.begin(), parts.end(), part);
  std::fill(end, parts.end(), NestedVolumes::nothing);
}

void add(NestedVolumes& volumes, const World& world, std::uint32_t part) {
  remove(volumes, part);
  auto& parts = volumes.parts;
  const double size = size_of(world, part);
  const auto later = [&](std::uint32_t other) {
    if (other == NestedVolumes::nothing) return true;
    const double its = size_of(world, other);
    return its > size || (its == size && other > part);
  };
  const auto at = std::find_if(parts.begin(), parts.end(), later);
  if (at == parts.end()) return;
  std::copy_backward(at, parts.end() - 1, parts.end());
  *at = part;
}

// Returns the volume that a ray leaves at the inner side of a part's boundary.
std::uint32_t left_by(const NestedVolumes& volumes, const World& world, std::uint32_t part) {
  const auto& parts = volumes.parts;
  if (std::find(parts.begin(), parts.end(), part) != parts.end()) return part;
  const std::uint32_t material = world.parts[part].material;
  const auto same = std::find_if(parts.begin(), parts.end(), [&](std::uint32_t other) {
    return other != NestedVolumes::nothing && world.parts[other].material == material;
  });
  return same != parts.end() ? *same : part;
}

glm::vec3 indices_in(const NestedVolumes& volumes, const World& world) {
  if (volumes.medium() == NestedVolumes::nothing) return glm::vec3(1.0f);
  return indices_of(material_of(world, volumes.medium()));
}

/// The material of a volume's boundary at total reflection.
SurfaceMaterial total_reflector(SurfaceMaterial material) {
  material.f0 = glm::vec3(1.0f);
  material.f90 = material.dielectric_f0 = material.dielectric_f90 = 1.0f;
  material.film.factor = 0.0f;
  return material;
}

float reflectance_between(float n1, float n2) {
  const float root = (n1 - n2) / (n1 + n2);
  return root * root;
}

}  // namespace

glm::vec3 indices_of(const Material& material) {
  const float n = material.ior;
  if (!(n >= 1.0f)) return glm::vec3(1.0f);
  // The dispersion is 20 / V.
  const float half = (n - 1.0f) * 0.025f * material.volume.dispersion;
  return glm::max(glm::vec3(n - half, n, n + half), 1.0f);
}

std::optional<VolumeBoundary> VolumeBoundary::met(const World& world, const Hit& hit,
                                                  const Ray& ray, const VolumePath& passage) {
  const Material& material = world.material_of(hit.triangle);
  if (!bounds_volume(material)) return std::nullopt;
  VolumeBoundary met;
  met.world = &world;
  met.material = &material;
  met.part = world.triangle_part[hit.triangle];
  met.entering = !meets_back(world, hit, ray.direction);
  const glm::vec3 position = ray.origin + hit.t * ray.direction;
  for (const std::uint32_t part : passage.around.parts) {
    if (part != NestedVolumes::nothing && holds(world, part, position))
      add(met.before, world, part);
  }
  if (met.entering) {
    remove(met.before, met.part);
    met.behind = met.before;
    add(met.behind, world, met.part);
  } else {
    const std::uint32_t left = left_by(met.before, world, met.part);
    add(met.before, world, left);
    met.behind = met.before;
    remove(met.behind, left);
  }
  met.ratio = indices_in(met.before, world) / indices_in(met.behind, world);
  return met;
}

std::optional<float> VolumeBoundary::fresnel_cosine(float n_dot_v,
                                                    const VolumePath& passage) const {
  const float n = ratio_of(passage);
  if (n <= 1.0f || passage.straight) return n_dot_v;
  const float squared = 1.0f - n * n * (1.0f - n_dot_v * n_dot_v);
  return squared > 0.0f ? std::optional(std::sqrt(squared)) : std::nullopt;
}

void VolumeBoundary::set_reflectance(SurfaceMaterial& seen) const {
  const NestedVolumes& outside = entering ? before : behind;
  if (outside.medium() == NestedVolumes::nothing || !(material->ior >= 1.0f)) return;
  const float to_air = reflectance_between(material->ior, 1.0f);
  const float n1 = indices_in(before, *world).y, n2 = indices_in(behind, *world).y;
  const float between = reflectance_between(n1, n2);
  const float scale = to_air > 0.0f ? between / to_air : 0.0f;
  // Metals reflect the same in any medium.
  const float dielectric = 1.0f - seen.metallic;
  seen.f0 *= 1.0f - dielectric * (1.0f - scale);
  seen.dielectric_f0 *= scale;
  if (to_air == 0.0f) {
    seen.f0 += dielectric * between * seen.dielectric_f90;
    seen.dielectric_f0 = between * seen.dielectric_f90;
  }
  // A boundary between equal indices is invisible.
  if (n1 == n2) seen.f90 *= 1.0f - dielectric, seen.dielectric_f90 = 0.0f;
}

ViewedMaterial VolumeBoundary::viewed(const SurfaceMaterial& seen, float n_dot_v,
                                      const VolumePath& passage) const {
  const auto cosine = fresnel_cosine(n_dot_v, passage);
  return cosine ? asos::viewed(seen, *cosine) : asos::viewed(total_reflector(seen), n_dot_v);
}

VolumePath VolumeBoundary::in(const VolumePath& passage, const NestedVolumes& volumes) const {
  VolumePath next = passage;
  next.around = volumes;
  const Volume medium = volumes.medium() == NestedVolumes::nothing
                            ? Volume{}
                            : material_of(*world, volumes.medium()).volume;
  next.attenuation_color = medium.attenuation_color;
  next.attenuation_distance = medium.attenuation_distance;
  return next;
}

VolumePath VolumeBoundary::leaving(const VolumePath& passage, const NestedVolumes& volumes,
                                   bool inner_side) const {
  VolumePath next = in(passage, volumes);
  next.part = part;
  next.inside = inner_side;
  next.straight = next.in_medium() && passage.straight;
  return next;
}

}  // namespace asos
