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
static_assert(RayScene::most_poses == RTC_MAX_TIME_STEP_COUNT);

}  // namespace

MeshDevice::MeshDevice() : device_(rtcNewDevice(nullptr)) {
  if (!device_) return;
  rtcSetDeviceErrorFunction(device_, Errors::note, &errors_);
  rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, &bytes_);
}

std::string MeshDevice::take_error() {
  const std::lock_guard lock(errors_.mutex);
  return std::exchange(errors_.first, {});
}

MeshDevice::~MeshDevice() {
  for (const Known& known : scenes_) rtcReleaseScene(known.scene);
  if (device_) rtcReleaseDevice(device_);
}

std::shared_ptr<MeshDevice> MeshDevice::common() {
  static std::mutex mutex;
  static std::weak_ptr<MeshDevice> newest;
  const std::lock_guard lock(mutex);
  std::shared_ptr<MeshDevice> device = newest.lock();
  if (!device) newest = device = std::make_shared<MeshDevice>();
  return device;
}

OwnedScene MeshDevice::scene_of(const std::shared_ptr<const World>& mesh, bool filtered,
                                const std::function<OwnedScene()>& build) {
  const std::lock_guard lock(mutex_);
  std::erase_if(scenes_, [](const Known& known) {
    if (!known.mesh.expired()) return false;
    rtcReleaseScene(known.scene);
    return true;
  });
  auto found = std::find_if(scenes_.begin(), scenes_.end(), [&](const Known& known) {
    return known.filtered == filtered && known.mesh.lock() == mesh;
  });
  if (found == scenes_.end()) {
    OwnedScene built = build();
    found = scenes_.insert(scenes_.end(), {mesh, filtered, built.release()});
  }
  rtcRetainScene(found->scene);
  return OwnedScene(found->scene);
}

void MeshDevice::Errors::note(void* self, RTCError code, const char* text) {
  if (code == RTC_ERROR_CANCELLED) return;  // LoadStopped says so
  auto& errors = *static_cast<Errors*>(self);
  const std::lock_guard lock(errors.mutex);
  if (!errors.first.empty()) return;
  const std::string words = code == RTC_ERROR_OUT_OF_MEMORY ? "out of memory" : "";
  errors.first = fmt::format("{}{}{}", words, words.empty() || !text ? "" : ": ", text ? text : "");
  if (errors.first.empty()) errors.first = fmt::format("error {}", static_cast<int>(code));
}

EmbreeScene::~EmbreeScene() {
  if (scene_) rtcReleaseScene(scene_);
}

Result<void> EmbreeScene::build(std::span<const World* const> poses, const Transparency& open,
                                std::span<const Light> lights, const RenderFeatures& forced,
                                BvhPurpose use) {
  poses_.assign(poses.begin(), poses.end());
  const World& world = *poses_.front();
  if (auto checked = check_own_parts(world, lights); !checked) return checked;
  const bool shares = use == BvhPurpose::moment || poses_.size() > 1;
  owner_ = shares ? MeshDevice::common() : std::make_shared<MeshDevice>();
  device_ = owner_->get();
  const std::int64_t before = owner_->bytes();
  if (!device_) {
    return unexpected(embree_error(fmt::format("Embree does not start (error {})",
                                               static_cast<int>(rtcGetDeviceError(nullptr)))));
  }
  choose_scale(world);
  sort_surfaces(world, open, lights);
  see_through_ |= all_filtered(forced);
  any_single_sided_ |= forced.culling;
  for (const World* pose : poses_) place_vertices(*pose);
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
  device_bytes_ = owner_->bytes() - (shares ? before : 0);
  if (std::string error = owner_->take_error(); !error.empty())
    return unexpected(embree_error(std::move(error)));
  return {};
}

void EmbreeScene::sort_surfaces(const World& world, const Transparency& open,
                                std::span<const Light> lights) {
  std::vector<std::uint8_t> owned(world.parts.size(), 0);
  for (const Light& light : lights) {
    if (light.own_part >= 0) owned[static_cast<std::size_t>(light.own_part)] = 1;
  }
  for (std::size_t id = 0; id < groups_.size(); ++id) {
    const std::size_t of_kind = id % Geometries::still_count;
    groups_[id] = {poses_, open,   static_cast<SurfaceKind>(of_kind % 3), of_kind % 6 >= 3,
                   {},     scale_, of_kind >= first_group_of_lines};
  }
  const std::vector<std::uint8_t> moving = moving_surfaces();
  // Placed meshes have their own scenes. Worlds with placed meshes have no shapes.
  const auto count = world.placements ? static_cast<std::uint32_t>(world.triangles.own().size())
                                      : world.surface_count();
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto kind = static_cast<std::size_t>(surface_kind(world.material_of(i)));
    const bool own = owned[world.triangle_part[i]] != 0;
    const std::size_t first = world.lines_and_points.has_triangle(i) ? first_group_of_lines
                              : world.is_face(i)                     ? first_group_of_faces
                                                                     : 0;
    const std::size_t moves = !moving.empty() && moving[i] ? Geometries::still_count : 0;
    groups_[first + kind + (own ? 3u : 0u) + moves].triangles.push_back(i);
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

  for (const Part& part : world.parts) {
    const bool single = !shows_both_sides(world.materials[part.material]);
    single_sided_.push_back(single);
    any_single_sided_ |= single && !part.shows_nothing();
  }
}

std::vector<std::uint8_t> EmbreeScene::moving_surfaces() const {
  if (poses_.size() == 1) return {};
  const World& first = *poses_.front();
  const std::vector<glm::vec3>& at = first.positions.own();
  const std::vector<glm::uvec3>& triangles = first.triangles.own();
  std::vector<std::uint8_t> vertices(at.size(), 0);
  std::vector<std::uint8_t> surfaces(triangles.size() + first.faces.size(), 0);
  for (const World* pose : poses_) {
    for (std::size_t i = 0; i < at.size(); ++i) vertices[i] |= pose->positions.own()[i] != at[i];
    for (std::size_t i = 0; i < first.faces.size(); ++i)
      surfaces[triangles.size() + i] |= !(pose->faces[i] == first.faces[i]);
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const glm::uvec3 t = triangles[i];
    surfaces[i] = vertices[t.x] | vertices[t.y] | vertices[t.z];
  }
  return surfaces;
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
    corners_.push_back(&positions.data()->x);
    return;
  }
  std::vector<float>& vertices = vertices_.emplace_back(3 * positions.size() + 4);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      vertices[3 * i + static_cast<std::size_t>(k)] = positions[i][k] * scale_;
    }
  }
  corners_.push_back(vertices.data());
}

RTCGeometry EmbreeScene::make_triangles(Group& group, const World& world, std::size_t poses) {
  const std::vector<glm::uvec3>& triangles = world.triangles.own();
  const bool all = group.triangles.size() == triangles.size();
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetGeometryTimeStepCount(geometry, static_cast<unsigned>(poses));
  for (unsigned i = 0; i < poses; ++i)
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, i, RTC_FORMAT_FLOAT3, corners_[i],
                               0, 3 * sizeof(float), world.positions.own().size());
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
  const unsigned of_kind = id % Geometries::still_count;
  const bool faces = of_kind >= first_group_of_faces && of_kind < first_group_of_lines;
  const std::size_t poses = id < Geometries::still_count ? 1 : poses_.size();
  const bool forced_empty = faces && forced.shapes && id < Geometries::still_count;
  if (group.triangles.empty() && !forced_empty) return;
  RTCGeometry geometry = nullptr;
  if (!faces) {
    geometry = make_triangles(group, world, poses);
  } else {
    geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryTimeStepCount(geometry, static_cast<unsigned>(poses));
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

OwnedScene EmbreeScene::scene_of_mesh(const World& mesh, const RenderFeatures& forced,
                                      RTCBuildQuality quality) const {
  static Group opaque;  // shared meshes are
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
  rtcSetGeometryUserData(geometry, &opaque);
  rtcSetGeometryBuildQuality(geometry, quality);
  add_filters(geometry, opaque, forced);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, 0);
  rtcReleaseGeometry(geometry);
  commit(scene);
  return owned;
}

void EmbreeScene::add_places(const World& world, const RenderFeatures& forced,
                             RTCBuildQuality quality) {
  const Placements& placed = *world.placements;
  std::vector<OwnedScene> scenes;  // the instances keep them
  for (const std::shared_ptr<const World>& mesh : placed.meshes)
    scenes.push_back(owner_->scene_of(mesh, all_filtered(forced),
                                      [&] { return scene_of_mesh(*mesh, forced, quality); }));
  for (unsigned i = 0; i < placed.places.size(); ++i) {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, scenes[placed.places[i].mesh].get());
    set_transforms(geometry, i);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_, geometry, Geometries::group_count + i);
    rtcReleaseGeometry(geometry);
  }
}

// A place that stands still has one matrix.
void EmbreeScene::set_transforms(RTCGeometry geometry, std::size_t place) const {
  std::vector<glm::mat4> matrices;
  for (const World* pose : poses_) {
    const Placements& placed = *pose->placements;
    matrices.emplace_back(static_cast<double>(scale_) *
                          placed.world_from_mesh(placed.places[place]));
  }
  if (std::count(matrices.begin(), matrices.end(), matrices[0]) ==
      static_cast<std::ptrdiff_t>(matrices.size()))
    matrices.resize(1);
  rtcSetGeometryTimeStepCount(geometry, static_cast<unsigned>(matrices.size()));
  for (unsigned i = 0; i < matrices.size(); ++i)
    rtcSetGeometryTransform(geometry, i, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &matrices[i][0][0]);
}

int EmbreeScene::native_width() const {
  const auto has = [this](RTCDeviceProperty p) { return rtcGetDeviceProperty(device_, p) != 0; };
  if (has(RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)) return 16;
  if (has(RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED)) return 8;
  return has(RTC_DEVICE_PROPERTY_NATIVE_RAY4_SUPPORTED) ? 4 : 1;
}

std::size_t EmbreeScene::memory_bytes() const {
  std::size_t bytes =
      single_sided_.capacity() + coplanar_.by_triangle.capacity() + coplanar_.by_place.capacity();
  for (const std::vector<float>& copy : vertices_) bytes += copy.capacity() * sizeof(float);
  for (const Group& group : groups_) bytes += group.triangles.capacity() * sizeof(std::uint32_t);
  return bytes + static_cast<std::size_t>(std::max<std::int64_t>(0, device_bytes_));
}

}  // namespace asos::tracing
