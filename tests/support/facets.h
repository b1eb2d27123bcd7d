#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

// Microfacets of a rough surface (glTF's appendix B: GGX, height-correlated Smith, Schlick): their
// reflection or transmission of arbitrary surroundings, by quadrature over their distribution in
// double precision, independent of the renderer's shading.

namespace asos::test {

/// Directions are in the surface's frame; z is the normal.
struct Facets {
  glm::dvec2 alpha{0.1};  ///< squared roughness along x and y
  double f0 = 1.0;
  double f90 = 1.0;

  [[nodiscard]] double root(glm::dvec3 v) const { return glm::length(glm::dvec3(alpha, 1.0) * v); }

  /// Calls `each` with a facet's unit normal and its area in the unit square, for n x n of them.
  /// For slopes s, in units of alpha, GGX has the fraction s^2 / (1 + s^2) of its facets below s.
  /// Steep facets, which are rare, are sampled more densely.
  template <typename Function>
  void each(int n, const Function& each) const {
    for (int i = 0; i < n; ++i) {
      const double left = 1.0 - (i + 0.5) / n, slope = std::sqrt(1.0 - left * left) / left;
      for (int k = 0; k < n; ++k) {
        const double phi = 2.0 * std::numbers::pi * (k + 0.5 * (1 + i % 2)) / n;
        const glm::dvec2 s = slope * alpha * glm::dvec2(std::cos(phi), std::sin(phi));
        each(glm::normalize(glm::dvec3(-s.x, -s.y, 1.0)),
             2.0 * left / (static_cast<double>(n) * n));
      }
    }
  }

  /// Radiance towards a viewer in the unit direction `v`, with `radiance` as a function of the
  /// incoming unit direction: the integral of BRDF and cosine.
  template <typename Function>
  [[nodiscard]] auto mirrored(int n, glm::dvec3 v, const Function& radiance) const {
    auto sum = 0.0 * radiance(v);
    each(n, [&](glm::dvec3 h, double share) {
      const double vh = glm::dot(v, h);
      const glm::dvec3 l = 2.0 * vh * h - v;
      if (!(vh > 0.0) || !(l.z > 0.0)) return;
      const double met = 2.0 * l.z * v.z / (l.z * root(v) + v.z * root(l));
      const double fresnel = f0 + (f90 - f0) * std::pow(1.0 - vh, 5.0);
      sum += share * fresnel * met * vh / (v.z * h.z) * radiance(l);
    });
    return sum;
  }

  /// Calls `of` with the normals of the facets visible to a viewer, and their fractions of the
  /// visible area.
  template <typename Function>
  void each_visible(int n, glm::dvec3 v, const Function& of) const {
    each(n, [&](glm::dvec3 h, double share) {
      const double vh = glm::dot(v, h);
      if (vh > 0.0) of(h, share * 2.0 * vh / ((v.z + root(v)) * h.z));
    });
  }

  /// Mean of a function of the facet's normal over the visible facets.
  template <typename Function>
  [[nodiscard]] auto over_visible(int n, glm::dvec3 v, const Function& of) const {
    auto sum = 0.0 * of(v);
    each_visible(n, v, [&](glm::dvec3 h, double share) { sum += share * of(h); });
    return sum;
  }
};

}  // namespace asos::test
