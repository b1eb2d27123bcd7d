#include "renderer/rays/ray_layer.h"

#include "renderer/load_progress.h"
#include "renderer/rays/face_geometry.h"

#include <algorithm>
#include <utility>

namespace asos::tracing {
namespace {

/// Returns the geometry's group by its number, without surfaces.
Group group_of(unsigned id, const LayerSettings& settings) {
  const unsigned of_kind = id % Geometries::still_count;
  Group group;
  group.open = settings.open;
  group.scale = settings.scale;
  if (of_kind == group_of_ground) return group;
  group.kind = static_cast<SurfaceKind>(of_kind % 3);
  group.owned = of_kind < first_group_of_lines && of_kind % 6 >= 3;
  group.shadowless = of_kind >= first_group_of_lines;
  return group;
}

bool has_faces(unsigned id) {
  const unsigned of_kind = id % Geometries::still_count;
  return of_kind >= first_group_of_faces && of_kind < first_group_of_lines;
}

}  // namespace

Layer::~Layer() {
  if (scene_) rtcReleaseScene(scene_);
}

std::shared_ptr<const Layer> Layer::build(const std::shared_ptr<MeshDevice>& device, LayerKind kind,
                                          const LayerSource& source,
                                          const LayerSettings& settings) {
  const std::shared_ptr<Layer> layer(new Layer(device, kind, settings));
  const World& world = source.world();
  const std::int64_t before = device->bytes();
  if (kind == LayerKind::places) {
    if (!world.placements) return nullptr;
    layer->placements_ = world.placements;
    layer->count_ = world.placements->places.size();
  } else {
    layer->find_runs(source);
    if (layer->count_ == 0 && !layer->needs_faces()) return nullptr;
    layer->make_groups(world);
    layer->keep_arrays(source);
  }
  layer->make_scene(source);
  layer->bytes_ = device->bytes() - before;
  return layer;
}

void Layer::find_runs(const LayerSource& source) {
  const World& world = source.world();
  // Placed meshes have their own scenes. Worlds with placed meshes have no shapes.
  const auto surfaces = world.placements ? static_cast<std::uint32_t>(world.triangles.own_size())
                                         : world.surface_count();
  for (std::uint32_t i = 0; i < surfaces; ++i) {
    const std::uint32_t part = world.triangle_part[i];
    std::uint8_t group = source.group_of_part[part];
    if (group == no_group || layer_of(group) != kind_) continue;
    if (world.is_face(i)) group += first_group_of_faces;
    if (!source.moving.empty() && source.moving[i]) group += Geometries::still_count;
    ++count_;
    if (!runs_.empty()) {
      Run& last = runs_.back();
      if (last.part == part && last.group == group && last.first + last.count == i) {
        ++last.count;
        continue;
      }
    }
    runs_.push_back({world.parts[part].surfaces, part, i, 1, group});
  }
}

void Layer::make_groups(const World& world) {
  for (unsigned id = 0; id < groups_.size(); ++id) groups_[id] = group_of(id, settings_);
  std::array<bool, Geometries::group_count> gaps{};
  for (const Run& run : runs_) {
    Group& group = groups_[run.group];
    if (group.count == 0) group.first = run.first;
    gaps[run.group] |= group.first + group.count != run.first;
    group.count += run.count;
  }
  for (const Run& run : runs_) {
    if (!gaps[run.group]) continue;
    Group& group = groups_[run.group];
    if (group.list.empty()) group.list.reserve(group.count);
    for (std::uint32_t i = 0; i < run.count; ++i) group.list.push_back(run.first + i);
  }
  for (Group& group : groups_)
    group.first_face = static_cast<std::uint32_t>(world.triangles.size());
}

void Layer::keep_arrays(const LayerSource& source) {
  triangles_ = source.world().triangles.shared();
  vertices_ = source.world().positions.own_size();
  for (const World* pose : source.poses) {
    place_vertices(*pose);
    if (kind_ == LayerKind::solids) faces_.push_back(pose->faces);
  }
  for (Group& group : groups_) group.faces = faces_;
}

// Embree reads 16 bytes for the last vertex, but World's vertices have 12.
void Layer::place_vertices(const World& world) {
  const std::vector<glm::vec3>& positions = world.positions.own();
  if (settings_.scale == 1.0f && positions.capacity() > positions.size()) {
    positions_.push_back(world.positions.shared());
    corners_.push_back(&positions.data()->x);
    return;
  }
  std::vector<float>& vertices = copies_.emplace_back(3 * positions.size() + 4);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    for (int k = 0; k < 3; ++k)
      vertices[3 * i + static_cast<std::size_t>(k)] = positions[i][k] * settings_.scale;
  }
  corners_.push_back(vertices.data());
}

void Layer::make_scene(const LayerSource& source) {
  scene_ = rtcNewScene(device_->get());
  // Measured (tests/bench/rays_bench.cpp): the ability to use a filter in the context does not slow
  // down queries without one.
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  // Measured (tests/bench/moving.cpp, 10,000 triangles): the low quality builds in 0.55 ms instead
  // of 3.
  if (settings_.use == BvhPurpose::moment && !source.world().placements && quickly_built())
    quality_ = RTC_BUILD_QUALITY_LOW;
  rtcSetSceneBuildQuality(scene_, quality_);
  if (kind_ == LayerKind::places) add_places(source);
  for (unsigned id = 0; id < groups_.size(); ++id) {
    if (groups_[id].count > 0 || (needs_faces() && has_faces(id) && id < Geometries::still_count))
      add(id, id < Geometries::still_count ? 1 : source.poses.size());
  }
  commit(scene_, kind_ == LayerKind::places ? 0 : count_);
}

/// Returns whether Embree's quick builder may be used: for a single geometry of more than a few
/// triangles. With several geometries, it asserts that none collapses to a point, and Debian's
/// Embree keeps its assertions.
bool Layer::quickly_built() const {
  constexpr std::size_t few = 1024;
  const auto filled = [](const Group& group) { return group.count > 0; };
  const auto of_triangles = groups_.begin() + first_group_of_faces;
  const auto only = std::find_if(groups_.begin(), of_triangles, filled);
  return only != of_triangles && only->count >= few &&
         std::count_if(groups_.begin(), groups_.end(), filled) == 1;
}

void Layer::add(unsigned id, std::size_t poses) {
  Group& group = groups_[id];
  RTCGeometry geometry = nullptr;
  if (!has_faces(id)) {
    geometry = make_triangles(group, poses);
  } else {
    geometry = rtcNewGeometry(device_->get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryTimeStepCount(geometry, static_cast<unsigned>(poses));
    set_faces(geometry, group);
  }
  rtcSetGeometryUserData(geometry, &group);
  rtcSetGeometryBuildQuality(geometry, quality_);
  add_filters(geometry, group);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene_, geometry, id);
  rtcReleaseGeometry(geometry);
}

RTCGeometry Layer::make_triangles(const Group& group, std::size_t poses) const {
  const std::vector<glm::uvec3>& triangles = *triangles_;
  RTCGeometry geometry = rtcNewGeometry(device_->get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetGeometryTimeStepCount(geometry, static_cast<unsigned>(poses));
  for (unsigned i = 0; i < poses; ++i) {
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, i, RTC_FORMAT_FLOAT3, corners_[i],
                               0, 3 * sizeof(float), vertices_);
  }
  if (group.list.empty()) {
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               triangles.data(), group.first * sizeof(glm::uvec3),
                               sizeof(glm::uvec3), group.count);
    return geometry;
  }
  auto* indices = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), group.list.size()));
  for (std::size_t i = 0; indices && i < group.list.size(); ++i)
    indices[i] = triangles[group.list[i]];
  return geometry;
}

void Layer::add_filters(RTCGeometry geometry, const Group& group) const {
  if (!settings_.filtered && !group.owned && !group.shadowless && group.kind == SurfaceKind::opaque)
    return;
  rtcSetGeometryIntersectFilterFunction(geometry, closest_filter);
  rtcSetGeometryOccludedFilterFunction(geometry, shadow_filter);
}

OwnedScene Layer::scene_of_mesh(const World& mesh) const {
  static Group opaque;  // shared meshes are
  OwnedScene owned(rtcNewScene(device_->get()));
  RTCScene scene = owned.get();
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  rtcSetSceneBuildQuality(scene, quality_);
  RTCGeometry geometry = rtcNewGeometry(device_->get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  // The array has room for one more: see place_vertices.
  const std::vector<glm::vec3>& positions = mesh.positions.own();
  const std::vector<glm::uvec3>& triangles = mesh.triangles.own();
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             positions.data(), 0, sizeof(glm::vec3), positions.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, triangles.data(),
                             0, sizeof(glm::uvec3), triangles.size());
  rtcSetGeometryUserData(geometry, &opaque);
  rtcSetGeometryBuildQuality(geometry, quality_);
  add_filters(geometry, opaque);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, 0);
  rtcReleaseGeometry(geometry);
  commit(scene, triangles.size());
  return owned;
}

/// Adds a scene for each shared mesh, and its instances.
void Layer::add_places(const LayerSource& source) {
  const World& world = source.world();
  const Placements& placed = *world.placements;
  std::vector<OwnedScene> scenes;  // the instances keep them
  for (const std::shared_ptr<const World>& mesh : placed.meshes)
    scenes.push_back(
        device_->scene_of(mesh, settings_.filtered, [&] { return scene_of_mesh(*mesh); }));
  for (unsigned i = 0; i < placed.places.size(); ++i) {
    const std::uint32_t part = placed.places[i].part;
    runs_.push_back({world.parts[part].surfaces, part, i, 1, no_group});
    RTCGeometry geometry = rtcNewGeometry(device_->get(), RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, scenes[placed.places[i].mesh].get());
    set_transforms(geometry, source.poses, i);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_, geometry, Geometries::group_count + i);
    rtcReleaseGeometry(geometry);
  }
}

// A place that stands still has one matrix.
void Layer::set_transforms(RTCGeometry geometry, std::span<const World* const> poses,
                           std::size_t place) const {
  std::vector<glm::mat4> matrices;
  for (const World* pose : poses) {
    const Placements& placed = *pose->placements;
    matrices.emplace_back(static_cast<double>(settings_.scale) *
                          placed.world_from_mesh(placed.places[place]));
  }
  if (std::count(matrices.begin(), matrices.end(), matrices[0]) ==
      static_cast<std::ptrdiff_t>(matrices.size()))
    matrices.resize(1);
  rtcSetGeometryTimeStepCount(geometry, static_cast<unsigned>(matrices.size()));
  for (unsigned i = 0; i < matrices.size(); ++i)
    rtcSetGeometryTransform(geometry, i, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &matrices[i][0][0]);
}

std::size_t Layer::memory_bytes() const {
  std::size_t bytes = runs_.capacity() * sizeof(Run);
  for (const std::vector<float>& copy : copies_) bytes += copy.capacity() * sizeof(float);
  for (const Group& group : groups_) bytes += group.list.capacity() * sizeof(std::uint32_t);
  for (const auto& faces : faces_) bytes += faces.capacity() * sizeof(ShapeFace);
  return bytes + static_cast<std::size_t>(std::max<std::int64_t>(0, bytes_));
}

}  // namespace asos::tracing
