#include "renderer/shading/lobe_norms.h"

#include "renderer/shading/ggx.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

namespace asos {
namespace {

struct Norms {
  double lobe = 0.0;
  double fresnel = 0.0;
};

/// The cosines and sines of the middles of equal parts of an angle. They are computed once, since
/// every entry of a table needs them.
template <std::size_t count>
struct Turns {
  explicit Turns(double whole) {
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = whole * (static_cast<double>(i) + 0.5) / count;
      cosine[i] = std::cos(angle);
      sine[i] = std::sin(angle);
    }
  }
  std::array<double, count> cosine{}, sine{};
};

/// Integrates, over visible normals by spherical caps (Dupuy and Benyoub 2023), a lobe with the
/// squared roughness `along` in the direction x and `across` in y. Only the masking of the light's
/// side and Fresnel's term remain, which are smooth. The viewer's azimuth is `turn` from x. The
/// nodes are at `azimuths` of `caps` circles.
template <std::size_t count>
Norms integrate(double n_dot_v, double along, double across, double turn, int caps,
                const Turns<count>& azimuths) {
  const double sine = std::sqrt((1.0 - n_dot_v) * (1.0 + n_dot_v));
  const glm::dvec3 alpha(along, across, 1.0);
  const glm::dvec3 v(sine * std::cos(turn), sine * std::sin(turn), n_dot_v);
  const double view_root = glm::length(alpha * v);
  const glm::dvec3 view = alpha * v / view_root;
  Norms sum;
  for (int i = 0; i < caps; ++i) {
    // Nodes are denser where the normals are steep, since a narrow lobe's light is cut off there.
    const double t = (i + 0.5) / caps;
    const double weight = 2.0 * t;
    const double z = t * t * (1.0 + view.z) - view.z;
    const double radius = std::sqrt(std::max(0.0, (1.0 - z) * (1.0 + z)));
    for (std::size_t k = 0; k < count; ++k) {
      // Compute the normal, the reflected direction and its masking.
      const glm::dvec3 cap(radius * azimuths.cosine[k], radius * azimuths.sine[k], z);
      const glm::dvec3 h = glm::normalize(alpha * (cap + view));
      const double v_dot_h = std::clamp(glm::dot(v, h), 0.0, 1.0);
      const glm::dvec3 l = 2.0 * v_dot_h * h - v;
      if (!(l.z > 0.0)) continue;
      const double left = smith_reached(l.z, glm::length(alpha * l), v.z, view_root);
      sum.lobe += weight * left;
      sum.fresnel += weight * left * schlick_weight(v_dot_h);
    }
  }
  const double samples = caps * static_cast<double>(count);
  return {sum.lobe / samples, sum.fresnel / samples};
}

/// Integrates an isotropic lobe. Both sides of the plane of view are equal.
Norms integrate(double n_dot_v, double alpha) {
  if (alpha == 0.0) return {1.0, schlick_weight(n_dot_v)};
  static const Turns<10> half_turn(std::numbers::pi);
  return integrate(n_dot_v, alpha, alpha, 0.0, 40, half_turn);
}

/// The place of a value from 0 to 1 in a table's row: the index below, and the fraction to the
/// next.
struct Between {
  Between(float value, std::size_t count) {
    const auto last = static_cast<float>(count - 1);
    const float at = std::clamp(value, 0.0f, 1.0f) * last;
    below = static_cast<std::size_t>(std::min(std::floor(at), last - 1.0f));
    way = at - static_cast<float>(below);
  }
  std::size_t below;
  float way;
};

/// Returns the value from 0 to 1 of a place in a table's row.
constexpr double step(std::size_t i, std::size_t count) {
  return static_cast<double>(i) / static_cast<double>(count - 1);
}

StretchedNormTable make_stretched_table() {
  using T = StretchedNormTable;
  const Turns<16> whole_turn(2.0 * std::numbers::pi);
  auto table = std::make_unique<T>();
  std::size_t at = 0;
  for (std::size_t r = 0; r < T::roughnesses; ++r) {
    // A mirror's lobe counts as the narrowest that is rendered.
    const double across = std::max(1e-4, std::pow(step(r, T::roughnesses), 2.0));
    for (std::size_t s = 0; s < T::stretches; ++s) {
      const double along = glm::mix(across, 1.0, std::pow(step(s, T::stretches), 2.0));
      for (std::size_t turn = 0; turn < T::turns; ++turn) {
        for (std::size_t c = 0; c < T::cosines; ++c) {
          const double root = std::max(step(c, T::cosines), 1e-2);
          const double azimuth =
              0.5 * std::numbers::pi * (1.0 - std::pow(step(turn, T::turns), 2.0));
          const Norms norms = integrate(root * root, along, across, azimuth, 24, whole_turn);
          table->norms[at++] = {static_cast<float>(norms.lobe), static_cast<float>(norms.fresnel)};
        }
      }
    }
  }
  return *table;
}

LobeNormTable make_table() {
  LobeNormTable table;
  for (std::size_t r = 0; r < LobeNormTable::roughnesses; ++r) {
    const double roughness = step(r, LobeNormTable::roughnesses);
    for (std::size_t c = 0; c < LobeNormTable::cosines; ++c) {
      const double root = std::max(step(c, LobeNormTable::cosines), 1e-4);
      const Norms norms = integrate(root * root, roughness * roughness);
      table.lobe[r * LobeNormTable::cosines + c] = static_cast<float>(norms.lobe);
      table.fresnel[r * LobeNormTable::cosines + c] = static_cast<float>(norms.fresnel);
    }
  }
  return table;
}

}  // namespace

const LobeNormTable& lobe_norm_table() {
  static const LobeNormTable table = make_table();
  return table;
}

const StretchedNormTable& stretched_norm_table() {
  static const StretchedNormTable table = make_stretched_table();
  return table;
}

LobeNorms stretched_lobe_norms(float n_dot_v, float roughness, float alpha_along,
                               float seen_along2) {
  using T = StretchedNormTable;
  const float all = n_dot_v + roughness + alpha_along + seen_along2;
  if (std::isnan(all)) return {all, all};
  const T& table = stretched_norm_table();
  const float across = std::clamp(roughness * roughness, 0.0f, 1.0f);
  const float stretch = across < 1.0f ? (alpha_along - across) / (1.0f - across) : 0.0f;
  const float from_across = std::asin(std::sqrt(std::clamp(seen_along2, 0.0f, 1.0f)));
  const Between r(roughness, T::roughnesses), s(std::sqrt(std::max(0.0f, stretch)), T::stretches);
  const Between t(std::sqrt(from_across * 2.0f * std::numbers::inv_pi_v<float>), T::turns);
  const Between c(std::sqrt(std::max(0.0f, n_dot_v)), T::cosines);
  LobeNorms sum{0.0f, 0.0f};
  for (std::size_t corner = 0; corner < 16; ++corner) {
    const auto side = [corner](const Between& b, std::size_t bit, float& weight) {
      const bool next = (corner >> bit & 1) != 0;
      weight *= next ? b.way : 1.0f - b.way;
      return b.below + (next ? 1 : 0);
    };
    float weight = 1.0f;
    std::size_t at = side(r, 0, weight);
    at = at * T::stretches + side(s, 1, weight);
    at = at * T::turns + side(t, 2, weight);
    at = at * T::cosines + side(c, 3, weight);
    sum.lobe += weight * table.norms[at].lobe;
    sum.fresnel += weight * table.norms[at].fresnel;
  }
  return sum;
}

LobeNorms lobe_norms(float n_dot_v, float roughness) {
  using T = LobeNormTable;
  if (std::isnan(n_dot_v + roughness)) return {n_dot_v + roughness, n_dot_v + roughness};
  const Between c(std::sqrt(std::max(0.0f, n_dot_v)), T::cosines), r(roughness, T::roughnesses);
  const auto between = [&](const auto& values) {
    const auto along = [&](std::size_t row) {
      const float* at = &values[row * T::cosines + c.below];
      return at[0] + (at[1] - at[0]) * c.way;
    };
    const float low = along(r.below);
    return low + (along(r.below + 1) - low) * r.way;
  };
  const T& table = lobe_norm_table();
  return {between(table.lobe), between(table.fresnel)};
}

}  // namespace asos
