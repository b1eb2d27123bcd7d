#pragma once

#include "renderer/lights/prepared_light.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

// The rendering equation for direct light on a surface with glTF's BRDF (appendix B), by quadrature
// over the lights' surfaces. Independent of the renderer's shading.

namespace asos::test {

struct Reflector {
  glm::dvec3 base{1.0};
  double metallic = 1.0;
  double roughness = 0.5;
  double coat = 0.0;  ///< KHR_materials_clearcoat
  double coat_roughness = 0.0;
  glm::dvec3 sheen{0.0};  ///< KHR_materials_sheen
  double sheen_roughness = 1.0;
  double anisotropy = 0.0;      ///< KHR_materials_anisotropy: its strength
  glm::dvec3 tangent{1, 0, 0};  ///< unit vector, the direction of larger roughness
};

/// A point of a surface and the direction to the viewer; all vectors except the position are unit.
struct SeenPoint {
  glm::dvec3 position, normal, to_viewer;
};

/// The fifth power, in a fifth of std::pow's time.
[[nodiscard]] inline double fifth_power(double x) {
  return x * x * (x * x) * x;
}

/// GGX's D times Smith's V.
[[nodiscard]] inline double ggx_reference(double roughness, const SeenPoint& at,
                                          glm::dvec3 to_light) {
  const glm::dvec3 n = at.normal, v = at.to_viewer;
  const glm::dvec3 h = glm::normalize(v + to_light);
  const double alpha = roughness * roughness, a2 = alpha * alpha;
  const double nl = glm::dot(n, to_light), nv = glm::dot(n, v), nh = glm::dot(n, h);
  const glm::dvec3 across = glm::cross(n, h);
  const double b = glm::dot(across, across) + a2 * nh * nh;
  const auto root = [a2](double x) { return std::sqrt(a2 + (1.0 - a2) * x * x); };
  return a2 / (std::numbers::pi * b * b) * 0.5 / (nl * root(nv) + nv * root(nl));
}

/// D times V of KHR_materials_anisotropy's text, except that V is not clamped to 1.
[[nodiscard]] inline double anisotropic_reference(const Reflector& r, const SeenPoint& at,
                                                  glm::dvec3 to_light) {
  const glm::dvec3 n = at.normal, v = at.to_viewer, t = r.tangent, b = glm::cross(n, t);
  const glm::dvec3 h = glm::normalize(v + to_light);
  const double alpha = r.roughness * r.roughness;
  const double along = glm::mix(alpha, 1.0, r.anisotropy * r.anisotropy), across = alpha;
  const double a2 = along * across;
  const glm::dvec3 f(across * glm::dot(t, h), along * glm::dot(b, h), a2 * glm::dot(n, h));
  const double w2 = a2 / glm::dot(f, f);
  const double d = a2 * w2 * w2 * std::numbers::inv_pi;
  const auto length = [&](glm::dvec3 w) {
    return glm::length(glm::dvec3(along * glm::dot(t, w), across * glm::dot(b, w), glm::dot(n, w)));
  };
  return d * 0.5 / (glm::dot(n, to_light) * length(v) + glm::dot(n, v) * length(to_light));
}

/// D times V of KHR_materials_sheen's text: Estevez and Kulla 2017.
[[nodiscard]] inline double sheen_reference(double roughness, const SeenPoint& at,
                                            glm::dvec3 to_light) {
  const glm::dvec3 h = glm::normalize(at.to_viewer + to_light);
  const double alpha = roughness * roughness;
  const auto l = [alpha](double x) {
    const double t = (1.0 - alpha) * (1.0 - alpha);
    const double a = (1.0 - t) * 21.5473 + t * 25.3245, b = (1.0 - t) * 3.82987 + t * 3.32435;
    const double c = (1.0 - t) * 0.19823 + t * 0.16801, d = -(1.0 - t) * 1.97760 - t * 1.27393;
    const double e = -(1.0 - t) * 4.32054 - t * 4.85967;
    return a / (1.0 + b * std::pow(x, c)) + d * x + e;
  };
  const auto lambda = [&](double x) {
    return x < 0.5 ? std::exp(l(x)) : std::exp(2.0 * l(0.5) - l(1.0 - x));
  };
  const double nl = glm::dot(at.normal, to_light), nv = glm::dot(at.normal, at.to_viewer);
  const double sine = glm::length(glm::cross(at.normal, h));
  const double d = (2.0 + 1.0 / alpha) * std::pow(sine, 1.0 / alpha) / (2.0 * std::numbers::pi);
  return d / ((1.0 + lambda(nv) + lambda(nl)) * 4.0 * nv * nl);
}

/// Integral over the hemisphere of a function of the direction to the light, times the cosine: the
/// radiance under a sky of radiance 1.
template <typename Function>
[[nodiscard]] auto over_hemisphere(const SeenPoint& at, int rings, const Function& of) {
  const glm::dvec3 n = at.normal;
  const glm::dvec3 along = at.to_viewer - glm::dot(at.to_viewer, n) * n;
  const glm::dvec3 other = std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x =
      glm::normalize(glm::dot(along, along) > 1e-12 ? along : glm::cross(n, other));
  const glm::dvec3 y = glm::cross(n, x);
  decltype(of(n)) sum(0.0);
  for (int i = 0; i < rings; ++i) {
    const double t = (i + 0.5) / rings;
    const double z = t * t, radius = std::sqrt((1.0 - z) * (1.0 + z));
    for (int k = 0; k < 2 * rings; ++k) {
      const double angle = std::numbers::pi * (k + 0.5) / rings;
      sum += 2.0 * t * z * of(z * n + radius * std::cos(angle) * x + radius * std::sin(angle) * y);
    }
  }
  return std::numbers::pi / (rings * rings) * sum;
}

/// The layers' factors that depend only on the view: KHR_materials_clearcoat's factor times its
/// Fresnel term, and KHR_materials_sheen's albedo scaling.
struct LayersSeen {
  double coat = 0.0;
  double below_sheen = 1.0;

  LayersSeen(const Reflector& r, const SeenPoint& at) {
    coat = r.coat * (0.04 + 0.96 * fifth_power(1.0 - glm::dot(at.normal, at.to_viewer)));
    if (r.sheen == glm::dvec3(0.0)) return;
    const double albedo = over_hemisphere(
        at, 40, [&](glm::dvec3 l) { return sheen_reference(r.sheen_roughness, at, l); });
    below_sheen = 1.0 - std::max({r.sheen.x, r.sheen.y, r.sheen.z}) * albedo;
  }
};

/// The BRDF of appendix B with its layers on top, for `to_light` above the horizon, in 1 / sr.
[[nodiscard]] inline glm::dvec3 gltf_brdf(const Reflector& r, const SeenPoint& at,
                                          const LayersSeen& layers, glm::dvec3 to_light) {
  const glm::dvec3 h = glm::normalize(at.to_viewer + to_light);
  const double specular = r.anisotropy > 0.0 ? anisotropic_reference(r, at, to_light)
                                             : ggx_reference(r.roughness, at, to_light);
  const double schlick = fifth_power(1.0 - glm::dot(at.to_viewer, h));
  const double fresnel = 0.04 + 0.96 * schlick;
  const glm::dvec3 dielectric =
      (1.0 - fresnel) * std::numbers::inv_pi * r.base + glm::dvec3(fresnel * specular);
  const glm::dvec3 metal = specular * (r.base + (1.0 - r.base) * schlick);
  glm::dvec3 all = glm::mix(dielectric, metal, r.metallic);
  if (r.sheen != glm::dvec3(0.0))
    all = r.sheen * sheen_reference(r.sheen_roughness, at, to_light) + layers.below_sheen * all;
  if (r.coat > 0.0)
    all = glm::mix(all, glm::dvec3(ggx_reference(r.coat_roughness, at, to_light)), layers.coat);
  return all;
}

/// A part of a light with two parameters from 0 to 1.
struct RadiantPatch {
  struct Place {
    glm::dvec3 to_light;     ///< unit
    double solid_angle = 0;  ///< per du dv; negative if seen from behind
  };
  std::function<Place(glm::dvec3 from, double u, double v)> at;
};

[[nodiscard]] inline RadiantPatch flat_patch(glm::dvec3 corner, glm::dvec3 u_edge,
                                             glm::dvec3 v_edge) {
  const glm::dvec3 facing = glm::cross(u_edge, v_edge);
  return {[=](glm::dvec3 from, double u, double v) -> RadiantPatch::Place {
    const glm::dvec3 d = corner + u * u_edge + v * v_edge - from;
    const double distance = glm::length(d);
    return {d / distance, -glm::dot(d, facing) / (distance * distance * distance)};
  }};
}

/// A quarter of a disk, or of a cone's directions, between two orthogonal axes.
[[nodiscard]] inline RadiantPatch disk_patch(glm::dvec3 centre, glm::dvec3 x, glm::dvec3 y) {
  const glm::dvec3 facing = glm::cross(x, y);
  return {[=](glm::dvec3 from, double u, double v) -> RadiantPatch::Place {
    const double angle = 0.5 * std::numbers::pi * v;
    const glm::dvec3 d = centre + u * (std::cos(angle) * x + std::sin(angle) * y) - from;
    const double distance = glm::length(d);
    return {d / distance,
            -0.5 * std::numbers::pi * u * glm::dot(d, facing) / (distance * distance * distance)};
  }};
}

[[nodiscard]] inline glm::dvec3 across(glm::dvec3 axis) {
  const glm::dvec3 other = std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(axis, other));
}

/// Four quarters of a disk that faces `facing` (unit).
inline void add_disk(std::vector<RadiantPatch>& patches, glm::dvec3 centre, glm::dvec3 facing,
                     double radius) {
  const glm::dvec3 x = radius * across(facing);
  const glm::dvec3 y = glm::cross(facing, x);
  for (const auto& [a, b] : {std::pair{x, y}, {y, -x}, {-x, -y}, {-y, x}})
    patches.push_back(disk_patch(centre, a, b));
}

/// The directions of a cone around a unit axis.
inline void add_cone(std::vector<RadiantPatch>& patches, glm::dvec3 from, glm::dvec3 axis,
                     double sine) {
  add_disk(patches, from + std::sqrt((1.0 - sine) * (1.0 + sine)) * axis, -axis, sine);
}

/// Returns the largest angle from `flat` towards `across`, both unit, at which a direction from
/// `from` meets the capsule; it meets the capsule along `flat`.
[[nodiscard]] inline double capsule_latitude(const PreparedLight& light, glm::dvec3 from,
                                             glm::dvec3 flat, glm::dvec3 across) {
  const auto meets = [&](double angle) {
    const glm::dvec3 ray = std::cos(angle) * flat + std::sin(angle) * across;
    const glm::dvec3 to_middle = light.position - from, half = light.half_u;
    const double ray_half = glm::dot(ray, half), ray_middle = glm::dot(ray, to_middle);
    const double t = (ray_middle * ray_half - glm::dot(to_middle, half)) /
                     (glm::dot(half, half) - ray_half * ray_half);
    const glm::dvec3 nearest = to_middle + std::clamp(t, -1.0, 1.0) * half;
    return glm::length(nearest - glm::dot(nearest, ray) * ray) < light.radius;
  };
  double low = 0.0, high = 0.5 * std::numbers::pi;
  for (int i = 0; i < 50; ++i) (meets(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
  return low;
}

/// The directions to a capsule from outside the infinite cylinder around it, by an angle in the
/// plane of the axis and one across, which bisection limits.
inline void add_capsule(std::vector<RadiantPatch>& patches, const PreparedLight& light,
                        glm::dvec3 from) {
  const glm::dvec3 along = glm::normalize(light.half_u);
  const glm::dvec3 to_middle = light.position - from;
  const glm::dvec3 foot = to_middle - glm::dot(to_middle, along) * along;
  const double height = glm::length(foot);
  const glm::dvec3 across = glm::cross(foot / height, along);
  const auto limits = [&](double side) {
    const double s = glm::dot(to_middle + side * light.half_u, along);
    const double tip =
        std::atan2(s, height) + side * std::asin(light.radius / std::hypot(s, height));
    const double touch = std::atan2(s * height, height * height - light.radius * light.radius);
    return std::pair{tip, touch};
  };
  const auto [low, low_side] = limits(-1.0);
  const auto [high, high_side] = limits(1.0);
  // The width has a root at the tips.
  for (const auto& [begin, end] :
       {std::pair{low, low_side}, {high, high_side}, {low_side, high_side}}) {
    const bool tip = begin != low_side;
    patches.push_back({[=](glm::dvec3, double u, double v) -> RadiantPatch::Place {
      const double psi = begin + (tip ? u * u : u) * (end - begin);
      const glm::dvec3 flat = std::cos(psi) * (foot / height) + std::sin(psi) * along;
      const double most = capsule_latitude(light, from, flat, across);
      const double beta = (2.0 * v - 1.0) * most;
      return {std::cos(beta) * flat + std::sin(beta) * across,
              (tip ? 2.0 * u : 1.0) * std::abs(end - begin) * 2.0 * most * std::cos(beta)};
    }});
  }
}

/// Radiance reflected at a point from patches of radiance 1. Patches are divided until each is
/// small relative to its angle to the mirrored view, or to the lobe; `fineness` 1 has an error of
/// about 1e-4 of the total.
class PatchQuadrature {
 public:
  PatchQuadrature(const Reflector& reflector, const SeenPoint& at, double fineness = 2.0)
      : reflector_(reflector),
        at_(at),
        layers_(reflector, at),
        mirrored_(glm::reflect(-at.to_viewer, at.normal)),
        lobe_(narrowest(reflector) * narrowest(reflector) *
              std::clamp(glm::dot(at.normal, at.to_viewer), 0.1, 1.0)),
        fineness_(fineness) {}

  [[nodiscard]] glm::dvec3 operator()(const RadiantPatch& patch) const {
    return integral(patch, 0.0, 0.0, 1.0, 0);
  }

 private:
  [[nodiscard]] static double narrowest(const Reflector& r) {
    return r.coat > 0.0 ? std::min(r.roughness, r.coat_roughness) : r.roughness;
  }
  [[nodiscard]] glm::dvec3 integral(const RadiantPatch& patch, double u, double v, double side,
                                    int depth) const {
    constexpr int deepest = 12;
    const glm::dvec3 middle = patch.at(at_.position, u + 0.5 * side, v + 0.5 * side).to_light;
    double reach = 0.0;
    for (const double du : {0.0, 1.0}) {
      for (const double dv : {0.0, 1.0}) {
        const auto corner = patch.at(at_.position, u + du * side, v + dv * side);
        reach = std::max(reach, glm::length(corner.to_light - middle));
      }
    }
    double to_peak = glm::length(mirrored_ - middle);
    if (reflector_.anisotropy > 0.0) {
      const glm::dvec3 across_ridge = glm::cross(at_.normal, reflector_.tangent);
      to_peak = std::min(to_peak, std::abs(glm::dot(across_ridge, at_.to_viewer + middle)));
    }
    const double most = std::min(0.25, std::max(lobe_, 0.5 * to_peak)) / fineness_;
    if (reach > most && depth < deepest) {
      const double half = 0.5 * side;
      return integral(patch, u, v, half, depth + 1) +
             integral(patch, u + half, v, half, depth + 1) +
             integral(patch, u, v + half, half, depth + 1) +
             integral(patch, u + half, v + half, half, depth + 1);
    }
    constexpr std::array<double, 4> nodes{0.0694318442029737, 0.3300094782075719,
                                          0.6699905217924281, 0.9305681557970263};
    constexpr std::array<double, 4> weights{0.1739274225687269, 0.3260725774312731,
                                            0.3260725774312731, 0.1739274225687269};
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        const auto place = patch.at(at_.position, u + side * nodes[i], v + side * nodes[k]);
        const double cosine = glm::dot(place.to_light, at_.normal);
        if (!(cosine > 0.0) || !(place.solid_angle > 0.0)) continue;
        sum += weights[i] * weights[k] * cosine * place.solid_angle *
               gltf_brdf(reflector_, at_, layers_, place.to_light);
      }
    }
    return side * side * sum;
  }

  Reflector reflector_;
  SeenPoint at_;
  LayersSeen layers_;
  glm::dvec3 mirrored_;
  double lobe_;
  double fineness_;
};

/// Reflected radiance of a line of one candela per metre, a thin Lambertian tube.
[[nodiscard]] inline glm::dvec3 line_quadrature(const Reflector& reflector, const SeenPoint& at,
                                                glm::dvec3 begin, glm::dvec3 end) {
  constexpr int parts = 400;
  const glm::dvec3 step = (end - begin) / static_cast<double>(parts);
  const glm::dvec3 along = glm::normalize(step);
  const double third = 0.5 * std::sqrt(0.6);
  const LayersSeen layers(reflector, at);
  glm::dvec3 sum(0.0);
  for (int i = 0; i < parts; ++i) {
    for (const double node : {-third, 0.0, third}) {
      const glm::dvec3 d = begin + (i + 0.5 + node) * step - at.position;
      const double distance = glm::length(d);
      const glm::dvec3 to_light = d / distance;
      const double cosine = glm::dot(to_light, at.normal);
      if (!(cosine > 0.0)) continue;
      const double sine = glm::length(glm::cross(to_light, along));
      sum += (node == 0.0 ? 4.0 / 9.0 : 5.0 / 18.0) * cosine * sine / (distance * distance) *
             gltf_brdf(reflector, at, layers, to_light);
    }
  }
  return glm::length(step) * sum;
}

/// Reflected radiance of the light at a point, without occluders. Polygons are rings between
/// similar outlines around the same centre.
[[nodiscard]] inline glm::dvec3 reflected_radiance(const PreparedLight& light,
                                                   const Reflector& reflector, const SeenPoint& at,
                                                   double fineness = 2.0) {
  const glm::dvec3 power(light.power);
  if (light.shape == LightShape::segment) {
    return power * line_quadrature(reflector, at, light.position - light.half_u,
                                   light.position + light.half_u);
  }
  std::vector<RadiantPatch> patches;
  if (light.shape == LightShape::disk) {
    add_disk(patches, light.position, light.towards, light.radius);
  } else if (light.shape == LightShape::ball) {
    const glm::dvec3 to_middle = light.position - at.position;
    const double distance = glm::length(to_middle);
    add_cone(patches, at.position, to_middle / distance, light.radius / distance);
  } else if (light.shape == LightShape::capsule) {
    add_capsule(patches, light, at.position);
  } else if (light.shape == LightShape::sun) {
    add_cone(patches, at.position, light.towards, std::sin(std::atan(light.radius)));
  } else if (light.outlines.size() == 2) {
    // A ring: the quadrangles between two outlines, which may have opposite windings.
    const auto& outer = light.outlines[0];
    std::vector<glm::dvec3> inner;
    for (const glm::dvec3& corner : outer) {
      inner.push_back(*std::min_element(
          light.outlines[1].begin(), light.outlines[1].end(), [&](glm::dvec3 p, glm::dvec3 q) {
            return glm::distance(p, corner) < glm::distance(q, corner);
          }));
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t k = (i + 1) % 4;
      const glm::dvec3 a = outer[i], b = outer[k], c = inner[k], d = inner[i];
      const glm::dvec3 facing = light.towards;
      patches.push_back({[=](glm::dvec3 from, double u, double v) -> RadiantPatch::Place {
        const glm::dvec3 p = glm::mix(glm::mix(a, b, u), glm::mix(d, c, u), v);
        const glm::dvec3 du = glm::mix(b - a, c - d, v), dv = glm::mix(d - a, c - b, u);
        const glm::dvec3 to = p - from;
        const double distance = glm::length(to);
        return {to / distance, -glm::dot(to, facing) * glm::length(glm::cross(du, dv)) /
                                   (distance * distance * distance)};
      }});
    }
  } else {
    patches.push_back(flat_patch(light.position - light.half_u - light.half_v, 2.0 * light.half_u,
                                 2.0 * light.half_v));
  }
  const PatchQuadrature quadrature(reflector, at, fineness);
  glm::dvec3 sum(0.0);
  for (const RadiantPatch& patch : patches) sum += quadrature(patch);
  return power * sum;
}

}  // namespace asos::test
