#include "renderer/rays/embree_scene.h"

#include "renderer/load_progress.h"
#include "renderer/rays/coplanar.h"
#include "renderer/tasks.h"
#include "renderer/work_counts.h"
#include "renderer/world/ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
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

static_assert(RayScene::most_poses == RTC_MAX_TIME_STEP_COUNT);

/// Returns the number of the first surface of each part, by part. Parts of faces have no number of
/// their own.
std::vector<std::uint32_t> first_surfaces(const World& world) {
  std::vector<std::uint32_t> first;
  for (const Part& part : world.parts) first.push_back(part.first_triangle);
  for (std::size_t i = world.faces.size(); i-- > 0;)
    first[world.faces[i].part] = static_cast<std::uint32_t>(world.triangles.size() + i);
  return first;
}

std::uint32_t surfaces_of(const Part& part) {
  return part.triangle_count + part.face_count;
}

}  // namespace

Result<void> EmbreeScene::build(std::span<const World* const> poses, const Transparency& open,
                                std::span<const Light> lights, const RenderFeatures& forced,
                                BvhPurpose use, const EmbreeScene* known) {
  poses_.assign(poses.begin(), poses.end());
  const World& world = *poses_.front();
  if (auto checked = check_own_parts(world, lights); !checked) return checked;
  const bool shares = use == BvhPurpose::moment || poses_.size() > 1;
  owner_ = known ? known->owner_ : shares ? MeshDevice::common() : std::make_shared<MeshDevice>();
  if (!owner_->get()) {
    return unexpected(embree_error(fmt::format("Embree does not start (error {})",
                                               static_cast<int>(rtcGetDeviceError(nullptr)))));
  }
  settings_ = {open, known ? known->scale() : scale_of(world), all_filtered(forced), forced.shapes,
               use};
  sort_parts(world, lights);
  find_sides(world);
  see_through_ |= all_filtered(forced);
  any_single_sided_ |= forced.culling;
  // The search takes about as long as the hierarchy where many parts touch. A thread for it would
  // leave some memory to Embree, a task does not.
  in_tasks(2, [&, progress = LoadProgress::current()](std::size_t task) {
    const LoadProgress::Scope scope(progress);
    if (task == 0)
      add_layers(settings_, known);
    else
      coplanar_ = find_coplanar(world, known ? &known->world() : nullptr,
                                known ? &known->coplanar_ : nullptr);
  });
  WorkDone::add(Work::coplanar_pairs, coplanar_.compared);
  if (std::string error = owner_->take_error(); !error.empty())
    return unexpected(embree_error(std::move(error)));
  return {};
}

void EmbreeScene::sort_parts(const World& world, std::span<const Light> lights) {
  std::vector<std::uint8_t> owned(world.parts.size(), 0);
  for (const Light& light : lights) {
    if (light.own_part >= 0) owned[static_cast<std::size_t>(light.own_part)] = 1;
  }
  const bool has_ground = ground_of(world) != Ground::off;
  for (std::size_t i = 0; i < world.parts.size(); ++i) {
    const Part& part = world.parts[i];
    const Material& m = world.materials[part.material];
    const auto kind = static_cast<unsigned>(surface_kind(m));
    unsigned group = kind + (owned[i] ? 3u : 0u);
    if (part.lines_and_points)
      group = first_group_of_lines + kind;
    else if (has_ground && i + 1 == world.solid_parts())
      group = group_of_ground;
    const bool placed = part.triangle_count > 0 && world.is_placed(part.first_triangle);
    const bool none = placed || surfaces_of(part) == 0;
    group_of_part_.push_back(none ? no_group : static_cast<std::uint8_t>(group));
    see_through_ |= !none && !part.lines_and_points && surface_kind(m) != SurfaceKind::opaque;
    volumes_ |= bounds_volume(m) && std::isfinite(m.volume.attenuation_distance) &&
                m.volume.attenuation_color != glm::vec3(1.0f);
  }
}

void EmbreeScene::find_sides(const World& world) {
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

float EmbreeScene::scale_of(const World& world) {
  const glm::vec3 size = world.bounds.hi - world.bounds.lo;
  const float extent = world.bounds.empty() ? 1.0f : std::max({size.x, size.y, size.z});
  constexpr float smallest = 1.0f / 1024.0f;
  if (extent > 0.0f && extent < smallest)
    return std::ldexp(1.0f, std::min(100, -std::ilogb(extent)));
  // Embree's test multiplies three lengths; lengths of 1e13 exceed single precision.
  constexpr float largest = 1e11f;
  constexpr int left = 20;
  return extent > largest ? std::ldexp(1.0f, left - std::ilogb(extent)) : 1.0f;
}

void EmbreeScene::add_layers(const LayerSettings& settings, const EmbreeScene* known) {
  const std::vector<std::uint8_t> moving = moving_surfaces();
  const LayerSource source{poses_, group_of_part_, moving};
  const bool comparable =
      known && poses_.size() == 1 && known->poses_.size() == 1 && known->settings_ == settings;
  for (std::size_t k = 0; k < layer_kinds; ++k) {
    const auto kind = static_cast<LayerKind>(k);
    std::shared_ptr<const Layer> layer;
    for (std::size_t i = 0; comparable && i < known->layers_.size() && !layer; ++i)
      if (known->layers_[i]->kind() == kind && use_again(*known->layers_[i]))
        layer = known->layers_[i];
    if (!layer) {
      layer = Layer::build(owner_, kind, source, settings);
      if (layer) number_as_built(*layer);
    }
    if (!layer) continue;
    scenes_.push_back(layer->scene());
    layers_.push_back(std::move(layer));
  }
}

void EmbreeScene::number_as_built(const Layer& layer) {
  for (unsigned id = 0; id < numbers_.size(); ++id)
    if (layer.group(id).count > 0) numbers_[id] = layer.group(id).numbers();
}

/// Numbers the surfaces of a layer as the world does, and returns true; returns false if the layer
/// lacks some. Those that the world lacks are hidden.
bool EmbreeScene::use_again(const Layer& layer) {
  const World& world = *poses_.front();
  const std::vector<std::uint32_t> first = first_surfaces(world);
  std::unordered_map<std::uint64_t, std::uint32_t> part_of;
  std::size_t wanted = 0;
  for (std::uint32_t i = 0; i < world.parts.size(); ++i) {
    const std::uint8_t group = group_of_part_[i];
    const bool placed = group == no_group && world.parts[i].triangle_count > 0;
    const bool here = layer.kind() == LayerKind::places
                          ? placed
                          : group != no_group && layer_of(group) == layer.kind();
    if (!here) continue;
    if (world.parts[i].surfaces == 0) return false;
    part_of.emplace(world.parts[i].surfaces, i);
    ++wanted;
  }
  // Instances are numbered by their places, so these have to be the same.
  if (layer.kind() == LayerKind::places)
    return world.placements && layer.runs().size() == wanted &&
           std::equal(layer.runs().begin(), layer.runs().end(), world.placements->places.begin(),
                      world.placements->places.end(), [&](const Layer::Run& run, const auto& at) {
                        return run.surfaces == world.parts[at.part].surfaces;
                      });
  std::size_t found = 0, moved = 0;
  for (const Layer::Run& run : layer.runs()) {
    const auto part = part_of.find(run.surfaces);
    if (part == part_of.end()) continue;
    const Part& now = world.parts[part->second];
    const unsigned group =
        group_of_part_[part->second] + (now.face_count > 0 ? first_group_of_faces : 0);
    if (group != run.group || surfaces_of(now) != run.count) return false;
    ++found;
    moved += first[part->second] != run.first ? 1 : 0;
  }
  if (wanted == 0 || found != wanted) return false;
  if (found == layer.runs().size() && moved == 0) {
    number_as_built(layer);
    return true;
  }
  for (const Layer::Run& run : layer.runs()) {
    const auto part = part_of.find(run.surfaces);
    std::vector<std::uint32_t>& list = lists_[run.group];
    for (std::uint32_t i = 0; i < run.count; ++i)
      list.push_back(part == part_of.end() ? Hit::none : first[part->second] + i);
    hides_ |= part == part_of.end();
  }
  for (unsigned id = 0; id < numbers_.size(); ++id)
    if (!lists_[id].empty()) numbers_[id] = {lists_[id].data(), 0};
  return true;
}

int EmbreeScene::native_width() const {
  const auto has = [this](RTCDeviceProperty p) {
    return rtcGetDeviceProperty(owner_->get(), p) != 0;
  };
  if (has(RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)) return 16;
  if (has(RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED)) return 8;
  return has(RTC_DEVICE_PROPERTY_NATIVE_RAY4_SUPPORTED) ? 4 : 1;
}

std::size_t EmbreeScene::memory_bytes() const {
  std::size_t bytes =
      single_sided_.capacity() + coplanar_.by_triangle.capacity() + coplanar_.by_place.capacity();
  for (const auto& layer : layers_) bytes += layer->memory_bytes();
  for (const auto& list : lists_) bytes += list.capacity() * sizeof(std::uint32_t);
  return bytes;
}

}  // namespace asos::tracing
