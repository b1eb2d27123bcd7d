#pragma once

#include "renderer/kernels/light_kernel.h"
#include "renderer/shading/viewed_point.h"
#include "tests/support/random_space.h"
#include "tests/support/sample_lights.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace asos::test {

struct NamedLight {
  std::string name;
  PreparedLight prepared;
};

[[nodiscard]] inline Light two_sided(Light light) {
  light.two_sided = true;
  return light;
}

/// All shapes, with size and distance scaled by `scale` and shifted by `offset`.
[[nodiscard]] inline std::vector<NamedLight> lights(double scale, glm::dvec3 offset) {
  std::vector<NamedLight> all;
  const auto add = [&](const std::string& name, const Light& light,
                       LightRule rule = LightRule::physical) {
    Light placed = scaled(light, scale);
    placed.position += offset;
    for (auto& outline : placed.outlines) {
      for (glm::dvec3& corner : outline) corner += offset;
    }
    all.push_back({name, prepare_light(placed, rule)});
  };
  add("point", point_light());
  add("spot", spot_light());
  add("distant", distant_light());
  add("sun", sun_light());
  add("small sun", sun_light(0.0093));
  add("ball", ball_light());
  add("huge ball", ball_light(2.5));
  add("segment", linear_light());
  add("published segment", linear_light(), LightRule::published);
  add("capsule", capsule_light());
  add("rectangle", rectangle_light());
  add("two-sided rectangle", two_sided(rectangle_light()));
  Light small = rectangle_light();
  small.half_u *= 1e-3;
  small.half_v *= 1e-3;
  add("small rectangle", small);
  add("disk", disk_light());
  add("polygon", polygon_light());
  return all;
}

/// The data that a LightingQuery refers to.
struct LitSubject {
  std::unique_ptr<SurfacePoint> point = std::make_unique<SurfacePoint>();
  ViewedMaterial material{};
  std::unique_ptr<ViewedPoint> view;
  MirroredLights mirrored = MirroredLights::none;
  glm::vec3 share{1.0f};

  [[nodiscard]] LightingQuery lit() const { return {{}, *view, material, mirrored, share}; }
};

[[nodiscard]] inline LitSubject subject(RandomSpace& space, int kind, double scale,
                                        glm::dvec3 offset) {
  const glm::dvec3 place(space.between(-2, 2), space.between(-1, 2.5), space.between(-2, 2));
  const Receiver at = space.receiver(place, {0, 2, 0}, kind);
  LitSubject s;
  s.point->position = glm::vec3(scale * place + offset);
  s.point->error = 3e-7f * glm::abs(s.point->position);
  s.point->extent = static_cast<float>(scale);
  if (kind % 3 == 0) s.point->to_edge = 0.0f;
  s.point->shading_normal = glm::vec3(at.normal);
  s.point->geometric_normal = glm::vec3(at.geometric);
  glm::dvec3 to_viewer = space.direction();
  if (glm::dot(to_viewer, at.geometric) < 0.0) to_viewer = -to_viewer;
  const auto n_dot_v =
      std::max(glm::dot(s.point->shading_normal, glm::vec3(to_viewer)), grazing_cosine);
  s.view = std::make_unique<ViewedPoint>(ViewedPoint{*s.point, glm::vec3(to_viewer), n_dot_v});
  const auto unit = [&] { return static_cast<float>(space.between(0, 1)); };
  // Rougher than a mirror: near a mirror's reflection the last bits of a direction decide.
  s.material.diffuse = {unit(), unit(), unit()};
  s.material.lobe.f0 = glm::vec3(unit());
  s.material.lobe.roughness = 0.3f + 0.7f * unit();
  s.material.lobe.f90 = glm::vec3(unit());
  s.material.falloff = unit();
  if (kind % 7 == 0) {
    s.material.lobe.roughness = 1.0f;
    s.material.lobe.sheen = 0.2f + 0.8f * unit();
  }
  s.mirrored = kind % 5 == 0 ? MirroredLights::all : MirroredLights::none;
  s.share = {unit(), unit(), unit()};
  if (kind % 2 == 0) {
    const auto edge = [&](double length) {
      return static_cast<float>(length * space.between(0.1, 1)) * glm::vec3(space.direction());
    };
    s.view->patch = {edge(0.02 * scale), edge(0.02 * scale)};
    s.view->distance = static_cast<float>(3.0 * scale);
    if (kind % 4 == 0) s.point->spread = {edge(0.2), edge(0.2), 0.01f * unit()};
  }
  return s;
}

/// A batch whose size is not a multiple of any vector width, with its points.
struct LitSubjects {
  std::vector<LitSubject> subjects;
  ShadingPoints points;
  LightPointBatch places;

  LitSubjects(std::uint64_t seed, double scale, glm::dvec3 offset) {
    RandomSpace space(seed);
    for (int i = 0; i < 251; ++i) {
      subjects.push_back(subject(space, i, scale, offset));
      points.add(subjects.back().lit(), glm::vec3(1.0f));
      const auto bits = [&] {
        return static_cast<std::uint32_t>(space.between(0.0, 4294967295.0));
      };
      places.u[static_cast<std::size_t>(i)] = i == 7 ? 0u : i == 8 ? 0xffffffffu : bits();
      places.v[static_cast<std::size_t>(i)] = i == 8 ? 0u : bits();
    }
  }
  [[nodiscard]] glm::dvec2 at(std::size_t i) const {
    constexpr double per_turn = 1.0 / 4294967296.0;
    return per_turn * glm::dvec2(places.u[i], places.v[i]);
  }
};

/// Scenes of size about 1, tiny and huge ones, and one far from the origin.
struct Scale {
  double scale;
  glm::dvec3 offset;
};
inline constexpr Scale scales[] = {
    {1.0, {0, 0, 0}}, {1e-6, {0, 0, 0}}, {1e6, {0, 0, 0}}, {1.0, {300, -200, 500}}};

}  // namespace asos::test
