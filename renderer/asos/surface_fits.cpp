#include "renderer/asos/surface_fits.h"

#include "renderer/geometry/bounds2.h"
#include "renderer/geometry/largest.h"
#include "renderer/pyray/tuning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace asos {
namespace {

using LeafGroup = std::vector<SampledLeaf*>;

// Returns whether both belong to one connected surface, bent by 25 degrees at most, and whether the
// line between them is not too steep, as at a step.
bool alike(const FeatureSet& features, const Leaf& a, const Leaf& b) {
  if (features.smooth_surface(a.hit.triangle) != features.smooth_surface(b.hit.triangle) ||
      glm::dot(a.point.shading_normal, b.point.shading_normal) < FitTuning::least_cosine)
    return false;
  const glm::vec3 between = b.point.position - a.point.position;
  return std::abs(glm::dot(between, a.point.geometric_normal)) <=
         FitTuning::steepest * glm::length(between);
}

std::vector<LeafGroup> surfaces_of(const FeatureSet& features, std::span<SampledLeaf> leaves) {
  std::vector<LeafGroup> groups;
  for (SampledLeaf& leaf : leaves) {
    if (!leaf.shares || !(leaf.found.cost > 0.0)) continue;
    const auto found = std::find_if(groups.begin(), groups.end(), [&](const LeafGroup& group) {
      return alike(features, *group.front()->leaf, *leaf.leaf);
    });
    if (found != groups.end()) {
      found->push_back(&leaf);
    } else if (groups.size() < FitTuning::most_surfaces) {
      groups.push_back({&leaf});
    }
  }
  return groups;
}

Bounds2 box_of(const LeafGroup& group) {
  Bounds2 box{glm::vec2(1.0f), glm::vec2(0.0f)};
  for (const SampledLeaf* leaf : group) {
    box.lo = glm::min(box.lo, leaf->leaf->at);
    box.hi = glm::max(box.hi, leaf->leaf->at);
  }
  return box;
}

// Returns the factor of a fit in a leaf's value, so that textures do not disturb a fit.
glm::dvec3 unit_of(const SampledLeaf& leaf) {
  constexpr float black = 1e-6f;
  return glm::dvec3(glm::max(leaf.reflectance, black));
}

// Returns the variance of the mean of n Sobol samples, in variances of one sample.
double variance_of_mean(double samples) {
  return 1.0 / (samples * std::sqrt(samples));
}

// Returns the variance of one sample per reflectance, from all leaves.
double variance_of_sample(const LeafGroup& group) {
  double variance = 0.0, known = 0.0;
  for (const SampledLeaf* leaf : group) {
    const double error = leaf->found.error / largest(unit_of(*leaf));
    if (!std::isfinite(error)) continue;
    variance += error * error / variance_of_mean(leaf->found.cost);
    known += 1.0;
  }
  return known > 0.0 ? variance / known : 0.0;
}

/// A polynomial of degree 2 over a part of the viewer's frame.
class Quadratic {
 public:
  static constexpr std::size_t terms = 6;

  /// Returns the fit that, times the reflectances, has the least squared deviations from the
  /// values, in variances. None if the leaves do not determine it, as on a line.
  [[nodiscard]] static std::optional<Quadratic> through(const LeafGroup& group) {
    Quadratic fit;
    fit.box_ = box_of(group);
    for (int channel = 0; channel < 3; ++channel) {
      Terms factors{};
      std::array<Terms, terms> products{};
      for (const SampledLeaf* leaf : group) {
        const Terms at = fit.terms_at(leaf->leaf->at);
        const double unit = unit_of(*leaf)[channel];
        const double weight = unit / variance_of_mean(leaf->found.cost);
        for (std::size_t i = 0; i < terms; ++i) {
          for (std::size_t j = 0; j < terms; ++j) products[i][j] += weight * unit * at[i] * at[j];
          factors[i] += weight * at[i] * leaf->found.value[channel];
        }
      }
      if (!solve(products, factors)) return std::nullopt;
      for (std::size_t i = 0; i < terms; ++i) fit.factors_[i][channel] = factors[i];
    }
    return fit;
  }
  [[nodiscard]] glm::dvec3 at(glm::vec2 place) const {
    const Terms at = terms_at(place);
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < terms; ++i) sum += at[i] * factors_[i];
    return sum;
  }

 private:
  using Terms = std::array<double, terms>;

  [[nodiscard]] Terms terms_at(glm::vec2 place) const {
    const glm::dvec2 p =
        glm::dvec2(place - box_.lo) / glm::dvec2(glm::max(box_.hi - box_.lo, 1e-9f));
    return {1.0, p.x, p.y, p.x * p.x, p.x * p.y, p.y * p.y};
  }
  /// Solves a symmetric system by Gauss's elimination. Returns false if the matrix is singular.
  [[nodiscard]] static bool solve(std::array<Terms, terms>& a, Terms& b) {
    // Smallest pivot, relative to the row's diagonal element before elimination.
    constexpr double least_pivot = 1e-6;
    Terms began{};
    for (std::size_t i = 0; i < terms; ++i) began[i] = a[i][i];
    for (std::size_t k = 0; k < terms; ++k) {
      if (!(a[k][k] > least_pivot * began[k])) return false;
      for (std::size_t i = k + 1; i < terms; ++i) {
        const double factor = a[i][k] / a[k][k];
        for (std::size_t j = k; j < terms; ++j) a[i][j] -= factor * a[k][j];
        b[i] -= factor * b[k];
      }
    }
    for (std::size_t k = terms; k-- > 0;) {
      for (std::size_t j = k + 1; j < terms; ++j) b[k] -= a[k][j] * b[j];
      b[k] /= a[k][k];
    }
    return true;
  }

  Bounds2 box_{};
  std::array<glm::dvec3, terms> factors_{};
};

// Returns whether a fit is accepted.
bool fit(const LeafGroup& group) {
  const auto found = Quadratic::through(group);
  if (!found) return false;
  const double variance = variance_of_sample(group);
  std::vector<glm::dvec3> off;
  std::vector<double> squares;  // squared deviations, in variances
  double sum = 0.0;
  for (const SampledLeaf* leaf : group) {
    const glm::dvec3 unit = unit_of(*leaf);
    off.push_back(unit * found->at(leaf->leaf->at) - leaf->found.value);
    const double error = largest(glm::abs(off.back())) / largest(unit);
    squares.push_back(error * error / (variance * variance_of_mean(leaf->found.cost)));
    sum += squares.back();
  }
  const auto freedom = static_cast<double>(group.size() - Quadratic::terms);
  if (!(sum <= freedom + FitTuning::most_off_together * std::sqrt(2.0 * freedom))) return false;
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (squares[i] > FitTuning::most_off * FitTuning::most_off) continue;
    group[i]->fitted = true;
    group[i]->correction = glm::max(off[i], -group[i]->found.value);
  }
  return true;
}

std::array<LeafGroup, 4> quarters_of(const LeafGroup& group) {
  const Bounds2 box = box_of(group);
  const glm::vec2 middle = glm::mix(box.lo, box.hi, 0.5f);
  std::array<LeafGroup, 4> parts;
  for (SampledLeaf* leaf : group) {
    const glm::vec2 at = leaf->leaf->at;
    parts[(at.x > middle.x ? 1u : 0u) + (at.y > middle.y ? 2u : 0u)].push_back(leaf);
  }
  return parts;
}

}  // namespace

void fit_surfaces(const FeatureSet& features, std::span<SampledLeaf> leaves) {
  std::vector<LeafGroup> groups = surfaces_of(features, leaves);
  while (!groups.empty()) {
    const LeafGroup group = std::move(groups.back());
    groups.pop_back();
    if (group.size() < FitTuning::fewest_leaves ||
        std::all_of(group.begin(), group.end(), [](const auto* leaf) { return leaf->converged; }) ||
        fit(group))
      continue;
    for (LeafGroup& part : quarters_of(group)) groups.push_back(std::move(part));
  }
}

}  // namespace asos
