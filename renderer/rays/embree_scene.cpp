#include "renderer/rays/embree_scene.h"

#include "renderer/load_progress.h"
#include "renderer/rays/coplanar.h"
#include "renderer/rays/face_geometry.h"
#include "renderer/tasks.h"
#include "renderer/work_counts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asos::tracing {
namespace {

Error embree_error(std::string reason) {
  return {"ray tracing", std::move(reason)};
}

Result<void> check_own_parts(const World& world, std::span<const Light> lights) {
  for (const Light& light : lights) {
    if (light.own_part < -1 ||
        (light.own_part >= 0 && static_cast<std::size_t>(light.own_part) >= world.parts.size())) {
      return unexpected(Error{fmt::format("light '{}'", light.name),
                              fmt::format("its own part {} does not exist", light.own_part)});
    }
  }
  return {};
}

bool all_filtered(const RenderFeatures& forced) {
  return forced.alpha_mask || forced.alpha_blend;
}

/// Counts Embree's allocations, on any of its threads.
bool count_bytes(void* counter, ssize_t bytes, bool) {
  const TaskOrder::Task task;
  static_cast<std::atomic<std::int64_t>*>(counter)->fetch_add(bytes, std::memory_order_relaxed);
  return true;
}

/// Lets a stop of the load end Embree's build. `progress`: a LoadProgress.
bool goes_on(void* progress, double) {
  return static_cast<LoadProgress*>(progress)->goes_on();
}

void watch_for_stops(RTCScene scene) {
  if (LoadProgress* progress = LoadProgress::current())
    rtcSetSceneProgressMonitorFunction(scene, goes_on, progress);
}

/// Builds a scene's hierarchy. Throws LoadStopped.
void commit(RTCScene scene) {
  watch_for_stops(scene);
  {
    const TaskOrder::Sending sending;
    rtcCommitScene(scene);
  }
  rtcSetSceneProgressMonitorFunction(scene, nullptr, nullptr);
  stop_point();
}

constexpr unsigned first_group_of_faces = 6;
constexpr unsigned first_group_of_lines = 12;

}  // namespace

void EmbreeScene::Errors::note(void* self, RTCError code, const char* text) {
  auto& errors = *static_cast<Errors*>(self);
  const std::lock_guard lock(errors.mutex);
  if (!errors.first.empty()) return;
  const std::string words = code == RTC_ERROR_OUT_OF_MEMORY ? "out of memory" : "";
  errors.first = fmt::format("{}{}{}", words, words.empty() || !text ? "" : ": ", text ? text : "");
  if (errors.first.empty()) errors.first = fmt::format("error {}", static_cast<int>(code));
}

EmbreeScene::~EmbreeScene() {
  if (scene_) rtcReleaseScene(scene_);
  if (device_) rtcReleaseDevice(device_);
}

Result<void> EmbreeScene::build(const World& world, const Transparency& open,
                                std::span<const Light> lights, const RenderFeatures& forced,
                                BvhPurpose use) {
  if (auto checked = check_own_parts(world, lights); !checked) return checked;
  device_ = rtcNewDevice(nullptr);
  if (!device_) {
    return unexpected(embree_error(fmt::format("Embree does not start (error {})",
                                               static_cast<int>(rtcGetDeviceError(nullptr)))));
  }
  rtcSetDeviceErrorFunction(device_, Errors::note, &errors_);
  rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, &device_bytes_);

  choose_scale(world);
  sort_surfaces(world, open, lights);
  see_through_ |= all_filtered(forced);
  sides_.any_single_sided |= forced.culling;
  place_vertices(world);
  scene_ = rtcNewScene(device_);
  // Measured (tests/bench/rays_bench.cpp): the ability to use a filter in the context does not slow
  // down queries without one.
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  // Measured (tests/bench/moving.cpp, 10,000 triangles): the low quality builds in 0.55 ms instead
  // of 3.
  const RTCBuildQuality quality = use == BvhPurpose::moment && !world.placements && quickly_built()
                                      ? RTC_BUILD_QUALITY_LOW
                                      : RTC_BUILD_QUALITY_MEDIUM;
  rtcSetSceneBuildQuality(scene_, quality);
  const auto build_hierarchy = [&] {
    for (unsigned id = 0; id < groups_.size(); ++id) add(id, world, forced, quality);
    if (world.placements) add_places(world, forced, quality);
    commit(scene_);
  };
  // The search takes about as long as the hierarchy where many parts touch. A thread for it would
  // leave some memory to Embree, a task does not.
  in_tasks(2, [&, progress = LoadProgress::current()](std::size_t task) {
    const LoadProgress::Scope scope(progress);
    if (task == 0)
      build_hierarchy();
    else
      coplanar_ = find_coplanar(world);
  });
  WorkDone::add(Work::coplanar_pairs, coplanar_.compared);
  if (!errors_.first.empty()) return unexpected(embree_error(errors_.first));
  return {};
}

void EmbreeScene::sort_surfaces(const World& world, const Transparency& open,
                                std::span<const Light> lights) {
  std::vector<std::uint8_t> owned(world.parts.size(), 0);
  for (const Light& light : lights) {
    if (light.own_part >= 0) owned[static_cast<std::size_t>(light.own_part)] = 1;
  }
  for (std::size_t id = 0; id < groups_.size(); ++id) {
    groups_[id] = {&world, open,   static_cast<SurfaceKind>(id % 3), id % 6 >= 3,
                   {},     scale_, id >= first_group_of_lines};
  }
  // Placed meshes have their own scenes. Worlds with placed meshes have no shapes.
  const auto count = world.placements ? static_cast<std::uint32_t>(world.triangles.own().size())
                                      : world.surface_count();
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto kind = static_cast<std::size_t>(surface_kind(world.material_of(i)));
    const bool own = owned[world.triangle_part[i]] != 0;
    const std::size_t first = world.lines_and_points.has_triangle(i) ? first_group_of_lines
                              : world.is_face(i)                     ? first_group_of_faces
                                                                     : 0;
    groups_[first + kind + (own ? 3u : 0u)].triangles.push_back(i);
  }
  for (const Part& part : world.parts) {
    const Material& m = world.materials[part.material];
    volumes_ |= bounds_volume(m) && std::isfinite(m.volume.attenuation_distance) &&
                m.volume.attenuation_color != glm::vec3(1.0f);
  }
  for (const Group& group : groups_) {
    see_through_ |=
        group.kind != SurfaceKind::opaque && !group.shadowless && !group.triangles.empty();
  }

  sides_.world = &world;
  for (const Part& part : world.parts) {
    const bool single = !shows_both_sides(world.materials[part.material]);
    sides_.single_sided.push_back(single);
    sides_.any_single_sided |= single && !part.shows_nothing();
  }
}

void EmbreeScene::choose_scale(const World& world) {
  const glm::vec3 size = world.bounds.hi - world.bounds.lo;
  const float extent = world.bounds.empty() ? 1.0f : std::max({size.x, size.y, size.z});
  constexpr float smallest = 1.0f / 1024.0f;
  if (extent > 0.0f && extent < smallest)
    scale_ = std::ldexp(1.0f, std::min(100, -std::ilogb(extent)));
  // Embree's test multiplies three lengths; lengths of 1e13 exceed single precision.
  constexpr float largest = 1e11f;
  constexpr int left = 20;
  if (extent > largest) scale_ = std::ldexp(1.0f, left - std::ilogb(extent));
}

// Embree reads 16 bytes for the last vertex, but World's vertices have 12.
void EmbreeScene::place_vertices(const World& world) {
  const std::vector<glm::vec3>& positions = world.positions.own();
  if (scale_ == 1.0f && positions.capacity() > positions.size()) {
    corners_ = &positions.data()->x;
    return;
  }
  vertices_.resize(3 * positions.size() + 4);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      vertices_[3 * i + static_cast<std::size_t>(k)] = positions[i][k] * scale_;
    }
  }
  corners_ = vertices_.data();
}

RTCGeometry EmbreeScene::make_triangles(Group& group, const World& world) {
  const std::vector<glm::uvec3>& triangles = world.triangles.own();
  const bool all = group.triangles.size() == triangles.size();
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, corners_, 0,
                             3 * sizeof(float), world.positions.own().size());
  if (all) {
    group.triangles = std::vector<std::uint32_t>();
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               triangles.data(), 0, sizeof(glm::uvec3), triangles.size());
  } else {
    auto* indices = static_cast<glm::uvec3*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                sizeof(glm::uvec3), group.triangles.size()));
    if (indices) {
      for (std::size_t i = 0; i < group.triangles.size(); ++i) {
        indices[i] = triangles[group.triangles[i]];
      }
    }
  }
  rtcSetGeometryUserData(geometry, &group);
  return geometry;
}

bool EmbreeScene::quickly_built() const {
  constexpr std::size_t few = 1024;
  const auto filled = [](const Group& group) { return !group.triangles.empty(); };
  const auto of_triangles = groups_.begin() + first_group_of_faces;
  const auto only = std::find_if(groups_.begin(), of_triangles, filled);
  return only != of_triangles && only->triangles.size() >= few &&
         std::count_if(groups_.begin(), groups_.end(), filled) == 1;
}

void EmbreeScene::add(unsigned id, const World& world, const RenderFeatures& forced,
                      RTCBuildQuality quality) {
  Group& group = groups_[id];
  const bool faces = id >= first_group_of_faces && id < first_group_of_lines;
  if (group.triangles.empty() && !(faces && forced.shapes)) return;
  RTCGeometry geometry = nullptr;
  if (!faces) {
    geometry = make_triangles(group, world);
  } else {
    geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    set_faces(geometry, group);
  }
  rtcSetGeometryBuildQuality(geometry, quality);
  add_filters(geometry, group, forced);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene_, geometry, id);
  rtcReleaseGeometry(geometry);
}

void EmbreeScene::add_filters(RTCGeometry geometry, const Group& group,
                              const RenderFeatures& forced) const {
  if (!all_filtered(forced) && !group.owned && !group.shadowless &&
      group.kind == SurfaceKind::opaque)
    return;
  rtcSetGeometryIntersectFilterFunction(geometry, closest_filter);
  rtcSetGeometryOccludedFilterFunction(geometry, shadow_filter);
}

EmbreeScene::OwnedScene EmbreeScene::scene_of_mesh(const World& mesh, Group& group,
                                                   const RenderFeatures& forced,
                                                   RTCBuildQuality quality) {
  OwnedScene owned(rtcNewScene(device_));
  RTCScene scene = owned.get();
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  rtcSetSceneBuildQuality(scene, quality);
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  // The array has room for one more: see place_vertices.
  const std::vector<glm::vec3>& positions = mesh.positions.own();
  const std::vector<glm::uvec3>& triangles = mesh.triangles.own();
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             positions.data(), 0, sizeof(glm::vec3), positions.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, triangles.data(),
                             0, sizeof(glm::uvec3), triangles.size());
  rtcSetGeometryUserData(geometry, &group);
  rtcSetGeometryBuildQuality(geometry, quality);
  add_filters(geometry, group, forced);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, 0);
  rtcReleaseGeometry(geometry);
  commit(scene);
  return owned;
}

void EmbreeScene::add_places(const World& world, const RenderFeatures& forced,
                             RTCBuildQuality quality) {
  const Placements& placed = *world.placements;
  for (std::size_t i = 0; i < placed.meshes.size(); ++i) {
    mesh_groups_.emplace_back().world = &world;
    mesh_groups_.back().scale = scale_;
  }
  std::vector<OwnedScene> scenes;  // the instances keep them
  for (std::size_t i = 0; i < placed.meshes.size(); ++i)
    scenes.push_back(scene_of_mesh(*placed.meshes[i], mesh_groups_[i], forced, quality));
  unsigned id = Geometries::group_count;
  for (const Placement& place : placed.places) {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, scenes[place.mesh].get());
    const glm::mat4 matrix(static_cast<double>(scale_) * placed.world_from_mesh(place));
    rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &matrix[0][0]);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_, geometry, id++);
    rtcReleaseGeometry(geometry);
  }
}

int EmbreeScene::native_width() const {
  const auto has = [this](RTCDeviceProperty p) { return rtcGetDeviceProperty(device_, p) != 0; };
  if (has(RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)) return 16;
  if (has(RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED)) return 8;
  return has(RTC_DEVICE_PROPERTY_NATIVE_RAY4_SUPPORTED) ? 4 : 1;
}

std::size_t EmbreeScene::memory_bytes() const {
  std::size_t bytes = vertices_.capacity() * sizeof(float) + sides_.single_sided.capacity() +
                      coplanar_.by_triangle.capacity() + coplanar_.by_place.capacity();
  for (const Group& group : groups_) bytes += group.triangles.capacity() * sizeof(std::uint32_t);
  return bytes + static_cast<std::size_t>(std::max<std::int64_t>(0, device_bytes_));
}

}  // namespace asos::tracing
