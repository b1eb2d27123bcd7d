#include "renderer/rays/ray_scene.h"

#include "renderer/rays/surface_kind.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace asos {
namespace {

// Embree hands out no more light than this once it is below what a display can show even at +8
// stops; traversal may then stop.
constexpr float opaque_enough = 1.0f / (256.0f * 256.0f);

/// The triangles of one kind; `triangles` maps Embree's primitive to World's triangle and is empty
/// where the kind holds all of them in order.
struct Group {
  const World* world = nullptr;
  AlphaAt alpha = nullptr;
  std::vector<std::uint32_t> triangles;

  [[nodiscard]] std::uint32_t triangle(unsigned primitive) const {
    return triangles.empty() ? primitive : triangles[primitive];
  }
};

/// Embree's context, extended by what the occlusion filter of blended surfaces multiplies.
struct Context {
  RTCIntersectContext base;
  float transmittance = 1.0f;

  explicit Context(RTCIntersectContextFlags flags) {
    rtcInitIntersectContext(&base);
    base.flags = flags;
  }
};
static_assert(offsetof(Context, base) == 0, "the filter casts Embree's context back");

float opacity(const RTCFilterFunctionNArguments& args, const Group& group, unsigned i) {
  const unsigned primitive = RTCHitN_primID(args.hit, args.N, i);
  const float u = RTCHitN_u(args.hit, args.N, i);
  const float v = RTCHitN_v(args.hit, args.N, i);
  return group.alpha(*group.world, group.triangle(primitive), u, v);
}

void cut_out_filter(const RTCFilterFunctionNArguments* args) {
  const Group& group = *static_cast<const Group*>(args->geometryUserPtr);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] != -1) continue;
    const unsigned primitive = RTCHitN_primID(args->hit, args->N, i);
    const float cutoff = group.world->material_of(group.triangle(primitive)).alpha_cutoff;
    if (opacity(*args, group, i) < cutoff) args->valid[i] = 0;
  }
}

// Only single rays are asked for their transmittance, so the context's product belongs to ray 0.
void attenuate_filter(const RTCFilterFunctionNArguments* args) {
  const Group& group = *static_cast<const Group*>(args->geometryUserPtr);
  auto& context = *reinterpret_cast<Context*>(args->context);
  if (args->valid[0] != -1) return;
  context.transmittance *= 1.0f - opacity(*args, group, 0);
  if (context.transmittance > opaque_enough) args->valid[0] = 0;
}

bool traceable(const Ray& ray) {
  // A sum is finite only if all its terms are (huge ones that overflow are no use either), and
  // saves five of six tests in the hot path.
  const glm::vec3 d = ray.direction;
  const float sum = ray.origin.x + ray.origin.y + ray.origin.z + d.x + d.y + d.z;
  return std::isfinite(sum) && !std::isnan(ray.t_near) && !std::isnan(ray.t_far) &&
         (d.x != 0.0f || d.y != 0.0f || d.z != 0.0f);
}

template <int width>
struct Packet;
template <>
struct Packet<4> {
  using RayHit = RTCRayHit4;
  static constexpr auto intersect = rtcIntersect4;
};
template <>
struct Packet<8> {
  using RayHit = RTCRayHit8;
  static constexpr auto intersect = rtcIntersect8;
};
template <>
struct Packet<16> {
  using RayHit = RTCRayHit16;
  static constexpr auto intersect = rtcIntersect16;
};

struct DeviceErrors {
  std::mutex mutex;
  std::string first;

  static void note(void* self, RTCError code, const char* text) {
    auto& errors = *static_cast<DeviceErrors*>(self);
    const std::lock_guard lock(errors.mutex);
    if (!errors.first.empty()) return;
    const std::string words = code == RTC_ERROR_OUT_OF_MEMORY ? "out of memory" : "";
    errors.first =
        fmt::format("{}{}{}", words, words.empty() || !text ? "" : ": ", text ? text : "");
    if (errors.first.empty()) errors.first = fmt::format("error {}", static_cast<int>(code));
  }
};

Error embree_error(std::string reason) {
  return {"ray tracing", std::move(reason)};
}

}  // namespace

struct RayScene::Impl {
  std::array<Group, 3> groups;  // by SurfaceKind, which is Embree's geometry id as well
  // Embree reads 16 bytes for the last vertex, so it cannot share World's array of 12-byte ones.
  std::vector<float> vertices;
  DeviceErrors errors;
  std::atomic<std::int64_t> device_bytes{0};
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  int width = 1;

  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }

  void add_group(SurfaceKind kind, const World& world);
  void choose_width();

  [[nodiscard]] Hit hit_of(unsigned geometry, unsigned primitive, float t, float u, float v) const {
    if (geometry == RTC_INVALID_GEOMETRY_ID) return {};
    return {groups[geometry].triangle(primitive), t, u, v};
  }

  template <int width>
  void closest_packets(std::span<const Ray> rays, std::span<Hit> hits) const;
};

void RayScene::Impl::add_group(SurfaceKind kind, const World& world) {
  Group& group = groups[static_cast<std::size_t>(kind)];
  const bool all = group.triangles.size() == world.triangles.size();
  if (group.triangles.empty()) return;

  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             vertices.data(), 0, 3 * sizeof(float), world.positions.size());
  if (all) {
    group.triangles = std::vector<std::uint32_t>();
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               world.triangles.data(), 0, sizeof(glm::uvec3),
                               world.triangles.size());
  } else {
    auto* indices = static_cast<glm::uvec3*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                sizeof(glm::uvec3), group.triangles.size()));
    if (indices) {
      for (std::size_t i = 0; i < group.triangles.size(); ++i) {
        indices[i] = world.triangles[group.triangles[i]];
      }
    }
  }
  rtcSetGeometryUserData(geometry, &group);
  rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_MEDIUM);
  if (kind == SurfaceKind::masked) {
    rtcSetGeometryIntersectFilterFunction(geometry, cut_out_filter);
    rtcSetGeometryOccludedFilterFunction(geometry, cut_out_filter);
  } else if (kind == SurfaceKind::blended) {
    rtcSetGeometryOccludedFilterFunction(geometry, attenuate_filter);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, static_cast<unsigned>(kind));
  rtcReleaseGeometry(geometry);
}

void RayScene::Impl::choose_width() {
  // Measured (tests/bench/rays_bench.cpp): the widest packets that the processor has are the
  // fastest ones for eye rays; packets that Embree has to emulate lose.
  if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)) {
    width = 16;
  } else if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED)) {
    width = 8;
  } else if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY4_SUPPORTED)) {
    width = 4;
  }
}

RayScene::RayScene() = default;
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

Result<RayScene> RayScene::build(const World& world, AlphaAt alpha) {
  RayScene built;
  built.impl_ = std::make_unique<Impl>();
  Impl& impl = *built.impl_;

  impl.device = rtcNewDevice(nullptr);
  if (!impl.device) {
    return unexpected(embree_error(fmt::format("Embree does not start (error {})",
                                               static_cast<int>(rtcGetDeviceError(nullptr)))));
  }
  rtcSetDeviceErrorFunction(impl.device, DeviceErrors::note, &impl.errors);
  rtcSetDeviceMemoryMonitorFunction(
      impl.device,
      [](void* counter, ssize_t bytes, bool) {
        static_cast<std::atomic<std::int64_t>*>(counter)->fetch_add(bytes,
                                                                    std::memory_order_relaxed);
        return true;
      },
      &impl.device_bytes);

  // Sort the triangles by kind.
  for (Group& group : impl.groups) group = {&world, alpha, {}};
  for (std::uint32_t i = 0; i < world.triangles.size(); ++i) {
    const SurfaceKind kind = surface_kind(world.material_of(i));
    impl.groups[static_cast<std::size_t>(kind)].triangles.push_back(i);
  }
  impl.vertices.resize(3 * world.positions.size() + 4);
  for (std::size_t i = 0; i < world.positions.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      impl.vertices[3 * i + static_cast<std::size_t>(k)] = world.positions[i][k];
    }
  }

  impl.scene = rtcNewScene(impl.device);
  rtcSetSceneFlags(impl.scene, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(impl.scene, RTC_BUILD_QUALITY_MEDIUM);
  for (const SurfaceKind kind : {SurfaceKind::opaque, SurfaceKind::masked, SurfaceKind::blended}) {
    impl.add_group(kind, world);
  }
  rtcCommitScene(impl.scene);
  impl.choose_width();
  if (!impl.errors.first.empty()) return unexpected(embree_error(impl.errors.first));
  return built;
}

Hit RayScene::closest(const Ray& ray) const {
  if (!impl_ || !traceable(ray)) return {};
  RTCRayHit query{};
  query.ray.org_x = ray.origin.x;
  query.ray.org_y = ray.origin.y;
  query.ray.org_z = ray.origin.z;
  query.ray.tnear = ray.t_near;
  query.ray.dir_x = ray.direction.x;
  query.ray.dir_y = ray.direction.y;
  query.ray.dir_z = ray.direction.z;
  query.ray.tfar = ray.t_far;
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  Context context(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
  rtcIntersect1(impl_->scene, &context.base, &query);
  return impl_->hit_of(query.hit.geomID, query.hit.primID, query.ray.tfar, query.hit.u,
                       query.hit.v);
}

template <int width>
void RayScene::Impl::closest_packets(std::span<const Ray> rays, std::span<Hit> hits) const {
  constexpr std::size_t lanes = width;
  Context context(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
  for (std::size_t first = 0; first < rays.size(); first += lanes) {
    const std::size_t count = std::min(lanes, rays.size() - first);
    alignas(64) std::array<int, lanes> valid{};
    alignas(64) typename Packet<width>::RayHit query{};
    for (std::size_t i = 0; i < count; ++i) {
      const Ray& ray = rays[first + i];
      valid[i] = traceable(ray) ? -1 : 0;
      query.ray.org_x[i] = ray.origin.x;
      query.ray.org_y[i] = ray.origin.y;
      query.ray.org_z[i] = ray.origin.z;
      query.ray.tnear[i] = ray.t_near;
      query.ray.dir_x[i] = ray.direction.x;
      query.ray.dir_y[i] = ray.direction.y;
      query.ray.dir_z[i] = ray.direction.z;
      query.ray.tfar[i] = ray.t_far;
      query.ray.mask[i] = ~0u;
      query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    Packet<width>::intersect(valid.data(), scene, &context.base, &query);
    for (std::size_t i = 0; i < count; ++i) {
      hits[first + i] = valid[i] ? hit_of(query.hit.geomID[i], query.hit.primID[i],
                                          query.ray.tfar[i], query.hit.u[i], query.hit.v[i])
                                 : Hit{};
    }
  }
}

void RayScene::closest(std::span<const Ray> rays, std::span<Hit> hits) const {
  if (!impl_) {
    std::fill(hits.begin(), hits.end(), Hit{});
  } else if (impl_->width == 1 || rays.size() == 1) {
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = closest(rays[i]);
  } else if (impl_->width == 16) {
    impl_->closest_packets<16>(rays, hits);
  } else if (impl_->width == 8) {
    impl_->closest_packets<8>(rays, hits);
  } else {
    impl_->closest_packets<4>(rays, hits);
  }
}

float RayScene::transmittance(const Ray& ray) const {
  if (!impl_ || !traceable(ray)) return 1.0f;
  RTCRay query{};
  query.org_x = ray.origin.x;
  query.org_y = ray.origin.y;
  query.org_z = ray.origin.z;
  query.tnear = ray.t_near;
  query.dir_x = ray.direction.x;
  query.dir_y = ray.direction.y;
  query.dir_z = ray.direction.z;
  query.tfar = ray.t_far;
  query.mask = ~0u;
  Context context(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
  rtcOccluded1(impl_->scene, &context.base, &query);
  // Embree marks a blocked ray with a far end of minus infinity.
  return query.tfar < query.tnear && std::isinf(query.tfar) ? 0.0f : context.transmittance;
}

std::size_t RayScene::memory_bytes() const {
  if (!impl_) return 0;
  std::size_t bytes = impl_->vertices.capacity() * sizeof(float);
  for (const Group& group : impl_->groups) {
    bytes += group.triangles.capacity() * sizeof(std::uint32_t);
  }
  return bytes + static_cast<std::size_t>(std::max<std::int64_t>(0, impl_->device_bytes));
}

int RayScene::packet_width() const {
  return impl_ ? impl_->width : 1;
}

void RayScene::set_packet_width(int width) {
  if (impl_ && (width == 1 || width == 4 || width == 8 || width == 16)) impl_->width = width;
}

}  // namespace asos
