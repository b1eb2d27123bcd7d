#include "renderer/rays/ray_scene.h"

#include "renderer/rays/coplanar.h"
#include "renderer/rays/embree_scene.h"
#include "renderer/rays/packets.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace asos {

using tracing::Context;
using tracing::Lanes;

struct RayScene::Impl {
  /// What rays meet: the surfaces as a world numbers them, at the rays' times, 0 to 1; empty: 0.
  struct Seen {
    const World& world;
    std::span<const float> times;

    [[nodiscard]] Seen of(std::size_t ray) const {
      return {world, times.empty() ? times : times.subspan(ray, 1)};
    }
  };

  tracing::EmbreeScene embree;
  int width = 1;

  // Measured (tests/bench/rays_bench.cpp): packets of eye rays, and of shadow rays with nearest
  // hits, are up to three times as fast with Embree's coherent flag. Occlusion queries in large
  // scenes are faster without it.
  [[nodiscard]] Context nearest(std::size_t rays, std::int32_t ignored_part = -1) const {
    return context(flags_for(rays), still(), ignored_part);
  }
  [[nodiscard]] Context nearest(std::size_t rays, Seen seen) const {
    return context(flags_for(rays), seen, -1);
  }
  [[nodiscard]] static RTCIntersectContextFlags flags_for(std::size_t rays) {
    return rays == 1 ? RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT : RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  }
  [[nodiscard]] Context context(RTCIntersectContextFlags flags, Seen seen,
                                std::int32_t ignored_part) const {
    return Context(flags, embree.geometries(seen.world), embree.sides(seen.world), ignored_part,
                   embree.scale(), seen.times, embree.hides());
  }
  [[nodiscard]] Seen still() const { return {embree.world(), {}}; }

  template <typename Store>
  void intersect(Context& context, std::span<const Ray> rays, Store store) const {
    tracing::with_width(width, rays.size(), [&](auto lanes) {
      tracing::intersect_packets<lanes()>(embree.scenes(), context, rays, store);
    });
  }

  /// `rays`: a span of rays, or arrays by member.
  template <typename Rays>
  void transmittance(const Rays& rays, std::size_t count, std::span<glm::vec3> shares,
                     std::int32_t ignored_part) const {
    Lanes left;
    left.volumes = embree.volumes();
    Context occluding = context(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT, still(), ignored_part);
    occluding.of_shadows = true;
    occluding.lanes = &left;
    tracing::with_width(width, count, [&](auto lanes) {
      tracing::occlude_packets<lanes()>(
          embree.scenes(), occluding, rays, [&](std::size_t i, std::size_t lane, bool blocked) {
            shares[i] = blocked ? glm::vec3(0.0f) : left.left(lane, way_of(rays, i));
          });
    });
  }
  void closest(std::span<const Ray> rays, Seen seen, std::span<Hit> hits, Culling faces) const;
  void pass_backs(std::span<const Ray> rays, Seen seen, std::span<Hit> hits) const;
  [[nodiscard]] bool is_coplanar(const World& world, const Hit& hit) const {
    return hit.valid() && embree.coplanar().marks(world, hit.triangle);
  }
  void in_place(const Ray& ray, Seen seen, const Hit& hit, Culling faces,
                std::vector<Hit>& met) const;
  void choose_in_place(std::span<const Ray> rays, Seen seen, std::span<Hit> hits,
                       Culling faces) const;

  /// Returns the length of a ray.
  [[nodiscard]] static float way_of(std::span<const Ray> rays, std::size_t i) {
    return rays[i].t_far * glm::length(rays[i].direction);
  }
  [[nodiscard]] static float way_of(const RayArrays& rays, std::size_t i) { return rays.t_far[i]; }
};

RayScene::RayScene() = default;
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

Result<RayScene> RayScene::build(const World& world, AlphaAt alpha, std::span<const Light> lights,
                                 const RenderFeatures& forced, TransmissionAt passage,
                                 BvhPurpose use, const RayScene* known) {
  const World* const pose = &world;
  return build_from({&pose, 1}, {alpha, passage}, lights, forced, use, known);
}

Result<RayScene> RayScene::build_moving(std::span<const World* const> poses, AlphaAt alpha,
                                        std::span<const Light> lights, const RenderFeatures& forced,
                                        TransmissionAt passage, BvhPurpose use) {
  return build_from(poses, {alpha, passage}, lights, forced, use, nullptr);
}

Result<RayScene> RayScene::build_from(std::span<const World* const> poses,
                                      const tracing::Transparency& open,
                                      std::span<const Light> lights, const RenderFeatures& forced,
                                      BvhPurpose use, const RayScene* known) {
  RayScene built;
  built.impl_ = std::make_unique<Impl>();
  const tracing::EmbreeScene* const before =
      known && known->impl_ ? &known->impl_->embree : nullptr;
  if (auto done = built.impl_->embree.build(poses, open, lights, forced, use, before); !done)
    return unexpected(done.error());
  // Measured (tests/bench/rays_bench.cpp): the processor's widest packets are the fastest for eye
  // rays and for shadow rays; packets that Embree has to emulate are slower.
  built.impl_->width = built.impl_->embree.native_width();
  return built;
}

/// Traces the rays that hit a back again, now through all backs. These are few rays, so this costs
/// less than a filter for all rays. A filter also finds a front at the same place as a back, which
/// a restart behind the back would miss.
void RayScene::Impl::pass_backs(std::span<const Ray> rays, Seen seen, std::span<Hit> hits) const {
  const tracing::Sides sides = embree.sides(seen.world);
  const auto culled = [&](std::size_t i) {
    return hits[i].valid() && sides.culled(hits[i], rays[i].direction);
  };
  std::size_t i = 0;
  while (i < rays.size() && !culled(i)) ++i;
  if (i == rays.size()) return;

  std::array<Ray, tracing::most_lanes> again;
  std::array<float, tracing::most_lanes> times{};
  std::array<std::size_t, tracing::most_lanes> places;
  std::size_t count = 0;
  const auto trace = [&] {
    const Seen those{seen.world, std::span(times).first(seen.times.empty() ? 0 : count)};
    Context filtering = nearest(count, those);
    filtering.base.filter = tracing::back_filter;
    intersect(filtering, std::span(again).first(count),
              [&](std::size_t k, std::size_t, const Hit& hit) { hits[places[k]] = hit; });
    count = 0;
  };
  for (; i < rays.size(); ++i) {
    if (!culled(i)) continue;
    again[count] = rays[i];
    if (!seen.times.empty()) times[count] = seen.times[i];
    places[count++] = i;
    if (count == again.size()) trace();
  }
  if (count > 0) trace();
}

void RayScene::Impl::in_place(const Ray& ray, Seen seen, const Hit& hit, Culling faces,
                              std::vector<Hit>& met) const {
  const float reach = tracing::reach_of_hit(seen.world, ray, hit);
  Ray near = ray;
  near.t_near = std::max(ray.t_near, hit.t - reach);
  near.t_far = std::min(ray.t_far, hit.t + reach);
  Context collecting = nearest(1, seen);
  collecting.base.filter = tracing::collecting_filter;
  collecting.met = &met;
  collecting.culls = faces == Culling::as_material_says;
  intersect(collecting, std::span(&near, 1), [](std::size_t, std::size_t, const Hit&) {});
  std::erase_if(met, [&](const Hit& other) {
    return other.triangle == hit.triangle || !is_coplanar(seen.world, other);
  });
  met.push_back(hit);
  std::sort(met.begin(), met.end(),
            [&](const Hit& a, const Hit& b) { return tracing::in_front(seen.world, a, b); });
}

/// Selects the front one of several surfaces at the same place.
void RayScene::Impl::choose_in_place(std::span<const Ray> rays, Seen seen, std::span<Hit> hits,
                                     Culling faces) const {
  std::vector<Hit> met;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!is_coplanar(seen.world, hits[i])) continue;
    met.clear();
    in_place(rays[i], seen.of(i), hits[i], faces, met);
    hits[i] = met.front();
  }
}

void RayScene::Impl::closest(std::span<const Ray> rays, Seen seen, std::span<Hit> hits,
                             Culling faces) const {
  Context context = nearest(rays.size(), seen);
  intersect(context, rays, [hits](std::size_t i, std::size_t, const Hit& hit) { hits[i] = hit; });
  if (faces == Culling::as_material_says && context.sides.any_single_sided)
    pass_backs(rays, seen, hits);
  if (!embree.coplanar().empty()) choose_in_place(rays, seen, hits, faces);
}

void RayScene::closest(std::span<const Ray> rays, std::span<Hit> hits, Culling faces) const {
  if (!impl_) {
    std::fill(hits.begin(), hits.end(), Hit{});
    return;
  }
  impl_->closest(rays, impl_->still(), hits, faces);
}

void RayScene::closest(std::span<const Ray> rays, std::span<const float> times, const World& pose,
                       std::span<Hit> hits, Culling faces) const {
  impl_->closest(rays, {pose, times}, hits, faces);
}

bool RayScene::is_coplanar(const Hit& hit) const {
  return impl_ && impl_->is_coplanar(impl_->embree.world(), hit);
}

void RayScene::in_place(const Ray& ray, const Hit& hit, Culling faces,
                        std::vector<Hit>& met) const {
  met.clear();
  if (impl_) impl_->in_place(ray, impl_->still(), hit, faces, met);
}

Hit RayScene::closest(const Ray& ray, Culling faces) const {
  Hit hit;
  closest(std::span(&ray, 1), std::span(&hit, 1), faces);
  return hit;
}

void RayScene::transmittance(std::span<const Ray> rays, std::span<glm::vec3> shares,
                             std::int32_t ignored_part) const {
  if (!impl_) {
    std::fill(shares.begin(), shares.end(), glm::vec3(1.0f));
    return;
  }
  impl_->transmittance(rays, rays.size(), shares, ignored_part);
}

void RayScene::transmittance(const RayArrays& rays, std::span<glm::vec3> shares,
                             std::int32_t ignored_part) const {
  if (!impl_) {
    std::fill(shares.begin(), shares.end(), glm::vec3(1.0f));
    return;
  }
  impl_->transmittance(rays, rays.count, shares, ignored_part);
}

glm::vec3 RayScene::transmittance(const Ray& ray, std::int32_t ignored_part) const {
  glm::vec3 share(1.0f);
  transmittance(std::span(&ray, 1), std::span(&share, 1), ignored_part);
  return share;
}

void RayScene::blockers(std::span<const Ray> rays, std::span<Blocker> blockers,
                        std::int32_t ignored_part, std::span<const std::uint8_t> outlined) const {
  if (!impl_) {
    std::fill(blockers.begin(), blockers.end(), Blocker{});
    return;
  }
  Context context = impl_->nearest(rays.size(), ignored_part);
  context.of_shadows = true;
  if (!impl_->embree.see_through()) {
    impl_->intersect(context, rays, [blockers](std::size_t i, std::size_t, const Hit& hit) {
      blockers[i] = {hit, glm::vec3(hit.valid() ? 0.0f : 1.0f), false, false};
    });
    return;
  }
  Lanes met;
  met.volumes = impl_->embree.volumes();
  context.lanes = &met;
  context.outlined = outlined;
  impl_->intersect(context, rays, [&](std::size_t i, std::size_t lane, const Hit& hit) {
    // A ray that nothing blocks has passed all blended surfaces on its way, in any order.
    const bool blocked =
        hit.valid() || tracing::most(met.transmittance[lane]) <= tracing::opaque_enough;
    const auto before = [&](float t) { return t < hit.t || (hit.valid() && t == hit.t); };
    const glm::vec3 left = blocked ? glm::vec3(0.0f) : met.left(lane, Impl::way_of(rays, i));
    blockers[i] = {hit, left, before(met.touched[lane] / context.scale),
                   before(met.masked[lane] / context.scale)};
  });
}

std::size_t RayScene::memory_bytes() const {
  return impl_ ? impl_->embree.memory_bytes() : 0;
}

int RayScene::packet_width() const {
  return impl_ ? impl_->width : 1;
}

void RayScene::set_packet_width(int width) {
  // Packets of 16 that Embree splits into two of 8 end the program if some lanes are unused.
  if (!impl_ || width > impl_->embree.native_width()) return;
  if (width == 1 || width == 4 || width == 8 || width == 16) impl_->width = width;
}

}  // namespace asos
