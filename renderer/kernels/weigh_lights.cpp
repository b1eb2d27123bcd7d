#include "renderer/kernels/weigh_lights.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/kernels/weigh_lights.cpp"
#include <hwy/foreach_target.h>  // this file again, once for each instruction set
// Include after foreach_target.h, whose definitions these use.
#include "renderer/kernels/lane.h"
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

  [[nodiscard]] HWY_INLINE Lane operator()(float LightBounds::*field) const {
    return all_lanes(light.*field);
  }
  [[nodiscard]] HWY_INLINE Vectors operator()(glm::vec3 LightBounds::*field) const {
    return all_lanes(light.*field);
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

  [[nodiscard]] HWY_INLINE Lane operator()(const ShadingPoints::Floats& of) const {
    return all_lanes(of[i]);
  }
  [[nodiscard]] HWY_INLINE Vectors operator()(const ShadingPoints::Vectors& of) const {
    return all_lanes(of.at(i));
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
  const auto turns = point(of.turns) > zero;
  if (hn::AllFalse(FloatTag(), turns)) return min(one, alpha2);
  const Lane both = square(point(of.spread_right)) + square(point(of.spread_down));
  const Lane by_normals = both / Lane(24) + point(of.spread_variance);
  const Lane added =
      alpha2 + min(by_normals, Lane(PatchLobe::most_added)) + Lane(0.5) * square(point(of.stretch));
  const auto sheen = point(of.sheen) > zero;
  return min(one, selected(turns, selected(sheen, one, added), alpha2));
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
    shines = max(Lane(f90.x), max(Lane(f90.y), Lane(f90.z))) > Lane(0);
  }
};

/// Returns the cosine to the centre of a light, or to the centre of its part above the horizon.
/// `reach` is the light's extent along the normal at a distance of 1. The result is above 0 unless
/// the whole light is below the horizon.
HWY_INLINE Lane cosine_above(Lane cosine, Lane reach) {
  return max(Lane(0), max(cosine, Lane(0.5) * (cosine + reach)));
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
  const auto nearness_of = [](Lane distance)
                               HWY_ATTR { return Lane(1) / max(distance, Lane(1e-30)); };
  const Vectors offset =
      light(&LightBounds::centre) - scaled<Lanes>(light(&LightBounds::finite), at.position);
  const Lane distance = sqrt(square(offset)), nearness = nearness_of(distance);
  const Vectors direction = scaled<Lanes>(nearness, offset);
  // The nearest point of the light or of its bounding rectangle.
  const auto along = [&](const Vectors& half, Lane per_square) HWY_ATTR {
    return scaled<Lanes>(min(one, max(-one, -Lane(dot(offset, half)) * per_square)), half);
  };
  const Vectors nearest =
      offset + (along(u, light(&LightBounds::per_u2)) + along(v, light(&LightBounds::per_v2)));
  const Lane least = sqrt(square(nearest)), most_near = nearness_of(least);
  const Lane round = light(&LightBounds::round);
  const auto reach_along = [&](const Vectors& normal) HWY_ATTR {
    return round + absolute(dot(u, normal)) + absolute(dot(v, normal));
  };
  // An extent beyond twice the distance has no further effect.
  const auto seen_reach = [&](Lane reach) HWY_ATTR { return min(Lane(2), reach * nearness); };
  const Lane reach = reach_along(at.normal), cosine = dot(direction, at.normal);
  const Lane n_dot_l =
      max(cosine_above(cosine, seen_reach(reach)),
          cosine_above(most_near * Lane(dot(nearest, at.normal)), min(one, reach * most_near)));

  const Vectors towards = light(&LightBounds::towards);
  const Lane height = -most_near * Lane(dot(nearest, towards));
  const Lane by_face =
      max(light(&LightBounds::all_round),
          max(light(&LightBounds::front) * height, -light(&LightBounds::back) * height));
  const Lane cone = Lane(dot(direction, towards)) * light(&LightBounds::cone_scale) +
                    light(&LightBounds::cone_offset);
  const Lane r2 = square(min(one, distance * light(&LightBounds::inverse_range)));
  const Lane left = square(min(one, max(zero, cone))) * (one - square(r2));
  const Lane fall =
      max(least * (distance + light(&LightBounds::near_linear)), light(&LightBounds::near_square));
  const auto above =
      Lane(dot(direction, at.geometric)) + seen_reach(reach_along(at.geometric)) > zero;
  const Lane form = light(&LightBounds::extent) * (left / fall) * (n_dot_l * by_face);
  return {direction + scaled<Lanes>(n_dot_l - cosine, at.normal), nearness, n_dot_l,
          selected(above, form, zero)};
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
  const Lane length = sqrt(max(square(sum), Lane(1e-12)));
  const Lane per_sum = one / length;
  const Lane spread = seen.nearness * per_sum;
  // The half vector turns in the tangent plane from the light's centre to the ends of its edges.
  struct Turn {
    Lane x, y;
  };
  const auto turn_to_end = [&](const Vectors& half) HWY_ATTR {
    const Vectors across = half - scaled<Lanes>(dot(seen.direction, half), seen.direction);
    return Turn{spread * Lane(dot(at.tangent, across)), spread * Lane(dot(at.bitangent, across))};
  };
  const Turn u = turn_to_end(light(&LightBounds::half_u));
  const Turn v = turn_to_end(light(&LightBounds::half_v));
  const Lane round2 = square(light(&LightBounds::round) * spread);
  const Lane x2 = round2 + u.x * u.x + v.x * v.x, y2 = round2 + u.y * u.y + v.y * v.y;
  // No lobe is broader than a uniform one.
  const Lane part = one / max(one, x2 + y2);
  const GgxSlopes<Lane> slopes{at.alpha2 + part * x2, part * (u.x * u.y + v.x * v.y),
                               at.alpha2 + part * y2};
  const Lane det = max(slopes.determinant(), square(at.alpha2));
  const auto half_along = [&](const Vectors& axis)
                              HWY_ATTR { return per_sum * Lane(dot(axis, sum)); };
  const Lane stretched = slopes.stretched(half_along(at.tangent), half_along(at.bitangent),
                                          half_along(at.normal), det);
  const Lane shadowing = smith_without_roots(max(seen.n_dot_l, Lane(grazing_cosine)), at.n_dot_v,
                                             min(one, sqrt(sqrt(det))));
  return {ggx_over(GgxSlopes<Lane>::alpha2(det), stretched, shadowing),
          schlick_weight(Lane(0.5) * length)};
}

template <class Light>
HWY_INLINE Lane weight(const Light& light, const PointLanes& at) {
  const Lane zero(0), one(1);
  const Seen middle = seen(light, at);
  if (hn::AllFalse(FloatTag(), middle.form > zero)) return zero;
  EstimatedShine shown{zero, zero};
  if (!hn::AllFalse(FloatTag(), at.shines)) {
    shown = shine(light, at, middle);
    const auto mirrors = light(&LightBounds::shown_from) > at.shows_lights;
    shown.lobe = selected(hn::And(mirrors, at.shines), shown.lobe, zero);
    shown.fresnel = selected(at.shines, shown.fresnel, zero);
  }
  const Lane scatters = one - at.falloff * shown.fresnel;
  const auto channel = [&](Lane by, Lane diffuse, Lane f0, Lane rest) HWY_ATTR {
    return by * (diffuse * scatters + (f0 + rest * shown.fresnel) * shown.lobe);
  };
  const Vectors power = light(&LightBounds::power);
  const Lane most = max(channel(power.x, at.diffuse.x, at.f0.x, at.f90_less_f0.x),
                        max(channel(power.y, at.diffuse.y, at.f0.y, at.f90_less_f0.y),
                            channel(power.z, at.diffuse.z, at.f0.z, at.f90_less_f0.z)));
  const Lane all = middle.form * most;
  // The comparison is false for NaN.
  return selected(all > zero, min(all, Lane(1e30)), zero);
}

void weigh(std::span<const LightBounds> lights, const ShadingPoints& points,
           std::span<ShadingPoints::Floats> weights) {
  for (std::size_t i = 0; i < points.count; i += hn::Lanes(FloatTag())) {
    const PointLanes at(EachPoint{points, i});
    for (std::size_t k = 0; k < lights.size(); ++k)
      store(weight(OneLight{lights[k]}, at), weights[k], i);
  }
}

void weigh_at(std::span<const LightBounds> lights, const ShadingPoints& points, std::size_t i,
              std::span<float> weights) {
  const FloatTag d;
  const PointLanes at(OnePoint{points, i});
  for (std::size_t k = 0; k < lights.size(); k += hn::Lanes(d))
    hn::StoreU(Lanes(weight(EachLight(lights.subspan(k)), at)), d, &weights[k]);
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
