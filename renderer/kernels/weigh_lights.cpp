#include "renderer/kernels/weigh_lights.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/kernels/weigh_lights.cpp"
#include <hwy/foreach_target.h>  // this file again, once for each instruction set
// Include after foreach_target.h, whose definitions these use.
#include "renderer/kernels/lanes.h"
#include "renderer/shading/ggx.h"
#include "renderer/shading/patch_lobe.h"
#include "renderer/shading/viewed_point.h"

#include <algorithm>
#include <hwy/highway.h>
#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
namespace {

HWY_INLINE Lane square(Lane x) {
  return x * x;
}
HWY_INLINE Lane square(const Vectors& v) {
  return dot(v, v);
}
HWY_INLINE Lane absolute(Lane x) {
  return max(x, -x);
}

/// One light in all lanes.
struct OneLight {
  const LightBounds& light;

  [[nodiscard]] HWY_INLINE Lane operator()(float LightBounds::*field) const { return light.*field; }
  [[nodiscard]] HWY_INLINE Vectors operator()(glm::vec3 LightBounds::*field) const {
    return light.*field;
  }
};
/// A light in each lane: the first of `lights`, and the last again if there are fewer than lanes.
class EachLight {
 public:
  HWY_INLINE explicit EachLight(std::span<const LightBounds> lights)
      : first_(lights.data()),
        places_(hn::Mul(hn::Min(hn::Iota(IntTag(), 0),
                                hn::Set(IntTag(), static_cast<std::int32_t>(lights.size() - 1))),
                        hn::Set(IntTag(), sizeof(LightBounds) / sizeof(float)))) {}

  [[nodiscard]] HWY_INLINE Lane operator()(float LightBounds::*field) const {
    return gathered(first_->*field);
  }
  [[nodiscard]] HWY_INLINE Vectors operator()(glm::vec3 LightBounds::*field) const {
    const glm::vec3& v = first_->*field;
    return {gathered(v.x), gathered(v.y), gathered(v.z)};
  }

 private:
  using IntTag = hn::RebindToSigned<FloatTag>;

  [[nodiscard]] HWY_INLINE Lane gathered(const float& of_first) const {
    return hn::GatherIndex(FloatTag(), &of_first, places_);
  }

  const LightBounds* first_;
  hn::Vec<IntTag> places_;
};

/// One point in all lanes.
struct OnePoint {
  const ShadingPoints& points;
  std::size_t i;

  [[nodiscard]] HWY_INLINE Lane operator()(const ShadingPoints::Floats& of) const { return of[i]; }
  [[nodiscard]] HWY_INLINE Vectors operator()(const ShadingPoints::Vectors& of) const {
    return of.at(i);
  }
};
/// The points from i on.
struct EachPoint {
  const ShadingPoints& points;
  std::size_t i;

  [[nodiscard]] HWY_INLINE Lane operator()(const ShadingPoints::Floats& of) const {
    return loaded(of, i);
  }
  [[nodiscard]] HWY_INLINE Vectors operator()(const ShadingPoints::Vectors& of) const {
    return loaded(of, i);
  }
};

/// Returns alpha^2 of the points' lobes, or of isotropic lobes about as wide as the patches' lobes.
template <class Point>
HWY_INLINE Lane alpha2_of(const Point& point) {
  const ShadingPoints& of = point.points;
  const Lane zero(0), one(1);
  const Lane alpha2 = square(point(of.alpha));
  const auto turns = point(of.turns) > 0.0f;
  if (none(turns)) return min(1.0f, alpha2);
  const Lane both = square(point(of.spread_right)) + square(point(of.spread_down));
  const Lane by_normals = both / 24.0f + point(of.spread_variance);
  const Lane added =
      alpha2 + min(by_normals, PatchLobe::most_added) + 0.5f * square(point(of.stretch));
  const auto sheen = point(of.sheen) > 0.0f;
  return min(1.0f, selected(turns, selected(sheen, 1.0f, added), alpha2));
}

/// Points as OnePoint or EachPoint.
struct PointLanes {
  Vectors position, geometric, normal, to_viewer;
  Vectors tangent, bitangent;  ///< about the normal
  Vectors diffuse, f0, f90_less_f0;
  Lane falloff, n_dot_v, alpha2, shows_lights;
  LaneMask shines;  ///< points with highlights

  template <class Point>
  HWY_INLINE explicit PointLanes(const Point& point)
      : position(point(point.points.position)),
        geometric(point(point.points.geometric)),
        normal(point(point.points.normal)),
        to_viewer(point(point.points.to_viewer)),
        diffuse(point(point.points.diffuse)),
        f0(point(point.points.f0)),
        f90_less_f0(point(point.points.f90_less_f0)),
        falloff(point(point.points.falloff)),
        n_dot_v(point(point.points.n_dot_v)),
        alpha2(alpha2_of(point)),
        shows_lights(point(point.points.shows_lights)) {
    const auto axes = axes_about<Lane>(normal.x, normal.y, normal.z);
    tangent = {axes.right.x, axes.right.y, axes.right.z};
    bitangent = {axes.up.x, axes.up.y, axes.up.z};
    const Vectors f90 = f0 + f90_less_f0;
    shines = max(f90.x, max(f90.y, f90.z)) > 0.0f;
  }
};

/// Returns the cosine to the centre of a light, or to the centre of its part above the horizon.
/// `reach` is the light's extent along the normal at a distance of 1. The result is above 0 unless
/// the whole light is below the horizon.
HWY_INLINE Lane cosine_above(Lane cosine, Lane reach) {
  return max(0.0f, max(cosine, 0.5f * (cosine + reach)));
}

/// Lights at points.
struct Seen {
  Vectors direction;  ///< to the centre, or to the centre of the part above the horizon
  Lane nearness, n_dot_l;
  Lane form;  ///< irradiance for a power of 1
};
template <class Light>
HWY_INLINE Seen seen(const Light& light, const PointLanes& at) {
  const Lane zero(0), one(1);
  const Vectors u = light(&LightBounds::half_u), v = light(&LightBounds::half_v);
  const auto nearness_of = [](Lane distance) HWY_ATTR { return 1.0f / max(distance, 1e-30f); };
  const Vectors offset = light(&LightBounds::centre) - light(&LightBounds::finite) * at.position;
  const Lane distance = sqrt(square(offset)), nearness = nearness_of(distance);
  const Vectors direction = nearness * offset;
  // The nearest point of the light or of its bounding rectangle.
  const auto along = [&](const Vectors& half, Lane per_square) HWY_ATTR {
    return min(1.0f, max(-1.0f, -dot(offset, half) * per_square)) * half;
  };
  const Vectors nearest =
      offset + (along(u, light(&LightBounds::per_u2)) + along(v, light(&LightBounds::per_v2)));
  const Lane least = sqrt(square(nearest)), most_near = nearness_of(least);
  const Lane round = light(&LightBounds::round);
  const auto reach_along = [&](const Vectors& normal) HWY_ATTR {
    return round + absolute(dot(u, normal)) + absolute(dot(v, normal));
  };
  // An extent beyond twice the distance has no further effect.
  const auto seen_reach = [&](Lane reach) HWY_ATTR { return min(2.0f, reach * nearness); };
  const Lane reach = reach_along(at.normal), cosine = dot(direction, at.normal);
  const Lane n_dot_l =
      max(cosine_above(cosine, seen_reach(reach)),
          cosine_above(most_near * dot(nearest, at.normal), min(1.0f, reach * most_near)));

  const Vectors towards = light(&LightBounds::towards);
  const Lane height = -most_near * dot(nearest, towards);
  const Lane by_face =
      max(light(&LightBounds::all_round),
          max(light(&LightBounds::front) * height, -light(&LightBounds::back) * height));
  const Lane cone =
      dot(direction, towards) * light(&LightBounds::cone_scale) + light(&LightBounds::cone_offset);
  const Lane r2 = square(min(1.0f, distance * light(&LightBounds::inverse_range)));
  const Lane left = square(min(1.0f, max(0.0f, cone))) * (1.0f - square(r2));
  const Lane fall =
      max(least * (distance + light(&LightBounds::near_linear)), light(&LightBounds::near_square));
  const auto above = dot(direction, at.geometric) + seen_reach(reach_along(at.geometric)) > 0.0f;
  const Lane form = light(&LightBounds::extent) * (left / fall) * (n_dot_l * by_face);
  return {direction + (n_dot_l - cosine) * at.normal, nearness, n_dot_l, where(above, form)};
}

/// The highlight: the lobe in the direction of the light's centre, widened by the light's spread of
/// half vectors.
struct EstimatedShine {
  Lane lobe, fresnel;
};
template <class Light>
HWY_INLINE EstimatedShine shine(const Light& light, const PointLanes& at, const Seen& seen) {
  const Lane one(1);
  const Vectors sum = seen.direction + at.to_viewer;
  const Lane length = sqrt(max(square(sum), 1e-12f));
  const Lane per_sum = 1.0f / length;
  const Lane spread = seen.nearness * per_sum;
  // The half vector turns in the tangent plane from the light's centre to the ends of its edges.
  struct Turn {
    Lane x, y;
  };
  const auto turn_to_end = [&](const Vectors& half) HWY_ATTR {
    const Vectors across = half - dot(seen.direction, half) * seen.direction;
    return Turn{spread * dot(at.tangent, across), spread * dot(at.bitangent, across)};
  };
  const Turn u = turn_to_end(light(&LightBounds::half_u));
  const Turn v = turn_to_end(light(&LightBounds::half_v));
  const Lane round2 = square(light(&LightBounds::round) * spread);
  const Lane x2 = round2 + u.x * u.x + v.x * v.x, y2 = round2 + u.y * u.y + v.y * v.y;
  // No lobe is broader than a uniform one.
  const Lane part = 1.0f / max(1.0f, x2 + y2);
  const GgxSlopes<Lane> slopes{at.alpha2 + part * x2, part * (u.x * u.y + v.x * v.y),
                               at.alpha2 + part * y2};
  const Lane det = max(slopes.determinant(), square(at.alpha2));
  const auto half_along = [&](const Vectors& axis) HWY_ATTR { return per_sum * dot(axis, sum); };
  const Lane stretched = slopes.stretched(half_along(at.tangent), half_along(at.bitangent),
                                          half_along(at.normal), det);
  const Lane shadowing = smith_without_roots(max(seen.n_dot_l, grazing_cosine), at.n_dot_v,
                                             min(1.0f, sqrt(sqrt(det))));
  return {ggx_over(GgxSlopes<Lane>::alpha2(det), stretched, shadowing),
          schlick_weight(0.5f * length)};
}

template <class Light>
HWY_INLINE Lane weight(const Light& light, const PointLanes& at) {
  const Lane zero(0), one(1);
  const Seen middle = seen(light, at);
  if (none(middle.form > 0.0f)) return 0.0f;
  EstimatedShine shown{0.0f, 0.0f};
  if (!none(at.shines)) {
    shown = shine(light, at, middle);
    const auto mirrors = light(&LightBounds::shown_from) > at.shows_lights;
    shown.lobe = where(mirrors && at.shines, shown.lobe);
    shown.fresnel = where(at.shines, shown.fresnel);
  }
  const Lane scatters = 1.0f - at.falloff * shown.fresnel;
  const auto channel = [&](Lane by, Lane diffuse, Lane f0, Lane rest) HWY_ATTR {
    return by * (diffuse * scatters + (f0 + rest * shown.fresnel) * shown.lobe);
  };
  const Vectors power = light(&LightBounds::power);
  const Lane most = max(channel(power.x, at.diffuse.x, at.f0.x, at.f90_less_f0.x),
                        max(channel(power.y, at.diffuse.y, at.f0.y, at.f90_less_f0.y),
                            channel(power.z, at.diffuse.z, at.f0.z, at.f90_less_f0.z)));
  const Lane all = middle.form * most;
  // The comparison is false for NaN.
  return where(all > 0.0f, min(all, 1e30f));
}

void weigh(std::span<const LightBounds> lights, const ShadingPoints& points,
           std::span<ShadingPoints::Floats> weights) {
  for (std::size_t i = 0; i < points.count; i += Lane::count()) {
    const PointLanes at(EachPoint{points, i});
    for (std::size_t k = 0; k < lights.size(); ++k)
      store(weight(OneLight{lights[k]}, at), weights[k], i);
  }
}

void weigh_at(std::span<const LightBounds> lights, const ShadingPoints& points, std::size_t i,
              std::span<float> weights) {
  const PointLanes at(OnePoint{points, i});
  for (std::size_t k = 0; k < lights.size(); k += Lane::count())
    weight(EachLight(lights.subspan(k)), at).store(&weights[k]);
}

}  // namespace
}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asos {

HWY_EXPORT(weigh);
HWY_EXPORT(weigh_at);

LightBounds::LightBounds(const LightConstants& light)
    : centre(light.position + light.position_rest),
      towards(light.towards),
      power(light.power),
      half_u(light.half_u),
      half_v(light.half_v),
      inverse_range(light.inverse_range),
      cone_scale(light.cone_scale),
      cone_offset(light.cone_offset),
      shown_from(light.shown_from) {
  constexpr float pi = std::numbers::pi_v<float>;
  const LightTraits& traits = traits_of(light.shape);
  const auto per_square = [](glm::vec3 v) {
    const float square = glm::dot(v, v);
    return square > 0.0f ? 1.0f / square : 0.0f;
  };
  per_u2 = per_square(half_u);
  per_v2 = per_square(half_v);
  if (traits.infinite) {
    centre = towards;
    finite = 0.0f;
  }
  if (!traits.flat) near_linear = light.u_length;
  if (traits.line) extent = 2.0f * light.u_length;
  if (traits.has_area()) {
    round = traits.flat ? 0.0f : light.radius;
    extent = traits.infinite     ? 2.0f * pi * light.one_less_cosine
             : light.area > 0.0f ? light.area
                                 : pi * round * round;
    if (!traits.infinite) near_square = traits.flat ? extent / pi : round * round;
  }
  if (traits.flat) {
    all_round = 0.0f;
    front = 1.0f;
    back = light.two_sided ? 1.0f : 0.0f;
  }
}

void weigh_lights(std::span<const LightBounds> lights, const ShadingPoints& points,
                  std::span<ShadingPoints::Floats> weights) {
  HWY_DYNAMIC_DISPATCH(weigh)(lights, points, weights);
}
void weigh_lights(std::span<const LightBounds> lights, const ShadingPoints& points, std::size_t i,
                  std::span<float> weights) {
  HWY_DYNAMIC_DISPATCH(weigh_at)(lights, points, i, weights);
}

}  // namespace asos
#endif
