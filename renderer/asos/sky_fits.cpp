#include "renderer/asos/sky_fits.h"

#include "renderer/asos/polynomial_fit.h"
#include "renderer/geometry/bounds2.h"
#include "renderer/pyray/tuning.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

namespace asos {
namespace {

double sum(glm::dvec3 v) {
  return v.x + v.y + v.z;
}

Bounds2 box_of(std::span<const SkyLeaf> lits, const SkyFits::Cell& cell) {
  Bounds2 box{glm::vec2(1.0f), glm::vec2(0.0f)};
  for (const std::uint32_t i : cell.lits) {
    box.lo = glm::min(box.lo, lits[i].leaf->at);
    box.hi = glm::max(box.hi, lits[i].leaf->at);
  }
  return box;
}

}  // namespace

// Returns whether both belong to one connected surface, bent by 25 degrees at most, and whether the
// line between them is not too steep, as at a step.
bool SkyFits::alike(const SkyLeaf& a, const SkyLeaf& b) const {
  if (a.smooth_surface != b.smooth_surface || a.mirrors != b.mirrors) return false;
  if (glm::dot(a.point.shading_normal, b.point.shading_normal) < SkyTuning::least_cosine)
    return false;
  const glm::vec3 between = b.point.position - a.point.position;
  return std::abs(glm::dot(between, a.point.geometric_normal)) <=
         SkyTuning::steepest * glm::length(between);
}

std::vector<SkyFits::Cell> SkyFits::cells() const {
  std::vector<Cell> cells;
  for (std::uint32_t i = 0; i < lits_.size(); ++i) {
    const SkyLeaf& lit = lits_[i];
    // Without diffuse reflection, each leaf reflects another part of the sky, so none can share.
    if (lit.rays == 0 || lit.material.diffuse == glm::vec3(0.0f)) continue;
    if (!(std::min({lit.unit.x, lit.unit.y, lit.unit.z}) > 0.0f)) continue;
    const auto found = std::find_if(cells.begin(), cells.end(), [&](const Cell& cell) {
      return alike(lits_[cell.lits.front()], lit);
    });
    if (found != cells.end()) {
      found->lits.push_back(i);
    } else if (cells.size() < SkyTuning::most_surfaces) {
      cells.push_back({{i}, {}, 0});
    }
  }
  std::erase_if(cells,
                [](const Cell& cell) { return cell.lits.size() < SkyTuning::fewest_leaves; });
  return cells;
}

// Returns the number of rays per node that brings the fit's error within the allowance of the
// surface's part of a pixel.
std::uint32_t SkyFits::rays_of_nodes(const Cell& cell) const {
  double weight = 0.0, variance = 0.0, unit = 0.0;
  std::uint32_t roots = 0, last = ~0u;
  for (const std::uint32_t i : cell.lits) {
    weight += lits_[i].leaf->weight;
    variance += lits_[i].leaf->weight * expected_[i].variance;
    unit = std::max(unit, std::min(1.0, static_cast<double>(largest(lits_[i].unit))));
    if (lits_[i].leaf->root != last) ++roots;
    last = lits_[i].leaf->root;
  }
  const double share = std::min(1.0, weight / roots);
  const double error = SkyTuning::share_of_nodes * standard_error_ / (unit * std::sqrt(share));
  const double rays = SkyLeaf::rays_for(variance / weight, error * error);
  return static_cast<std::uint32_t>(std::clamp(std::ceil(rays), 1.0, 1e4));
}

bool SkyFits::choose_nodes(Cell& cell) const {
  cell.nodes.clear();
  if (cell.lits.size() < SkyTuning::fewest_leaves) return false;
  const Bounds2 box = box_of(lits_, cell);
  for (int k = 0; k < SkyTuning::nodes_along * SkyTuning::nodes_along; ++k) {
    const glm::vec2 share(
        static_cast<float>(k % SkyTuning::nodes_along) / (SkyTuning::nodes_along - 1),
        static_cast<float>(k / SkyTuning::nodes_along) / (SkyTuning::nodes_along - 1));
    const glm::vec2 place = glm::mix(box.lo, box.hi, share);
    const auto distance = [&](std::uint32_t i) {
      const glm::vec2 off = lits_[i].leaf->at - place;
      return glm::dot(off, off);
    };
    const std::uint32_t nearest =
        *std::min_element(cell.lits.begin(), cell.lits.end(),
                          [&](auto a, auto b) { return distance(a) < distance(b); });
    if (std::find(cell.nodes.begin(), cell.nodes.end(), nearest) == cell.nodes.end())
      cell.nodes.push_back(nearest);
  }
  if (cell.nodes.size() < PolynomialFit::fewest) return false;
  // Compare the rays that all leaves need with those that the nodes need.
  cell.node_rays = rays_of_nodes(cell);
  const auto missing = [&](std::uint32_t i, std::uint32_t wanted) {
    return wanted > lits_[i].rays ? wanted - lits_[i].rays : 0u;
  };
  double alone = 0.0, shared = 0.0;
  for (const std::uint32_t i : cell.lits) alone += missing(i, expected_[i].rays);
  for (const std::uint32_t i : cell.nodes) shared += missing(i, cell.node_rays);
  return alone > SkyTuning::least_gain * shared;
}

// Returns the variance of a node's mean, from its own rays and from an invisible deviation of the
// fit.
double SkyFits::variance(std::uint32_t lit) const {
  const double unseen = 0.25 * standard_error_ / sum(glm::dvec3(lits_[lit].unit)) * 3.0;
  return SkyLeaf::variance_of_mean(expected_[lit].variance, lits_[lit].rays) + unseen * unseen;
}

bool SkyFits::assign(const Cell& cell) const {
  std::array<NoisyValue, static_cast<std::size_t>(SkyTuning::nodes_along * SkyTuning::nodes_along)>
      known;
  for (std::size_t k = 0; k < cell.nodes.size(); ++k) {
    const SkyLeaf& node = lits_[cell.nodes[k]];
    known[k] = {glm::dvec2(node.leaf->at), node.mean() / glm::dvec3(node.unit),
                variance(cell.nodes[k])};
  }
  const auto fit = PolynomialFit::through(std::span(known).first(cell.nodes.size()));
  if (!fit || fit->misfit() > SkyTuning::most_misfit) return false;
  // Compare the other leaves with the fit.
  double off = 0.0, certainty = 0.0;
  std::vector<std::uint32_t> agreeing;
  for (const std::uint32_t i : cell.lits) {
    const SkyLeaf& lit = lits_[i];
    const double by =
        sum(lit.mean() / glm::dvec3(lit.unit) - fit->at(glm::dvec2(lit.leaf->at))) / 3.0;
    const double noise = variance(i);
    off += by / noise;
    certainty += 1.0 / noise;
    if (by * by <= SkyTuning::most_off * SkyTuning::most_off * noise) agreeing.push_back(i);
  }
  const auto count = static_cast<double>(cell.lits.size());
  if (off * off > SkyTuning::most_off_together * SkyTuning::most_off_together * certainty ||
      static_cast<double>(agreeing.size()) < (1.0 - SkyTuning::most_contradicting) * count)
    return false;
  for (const std::uint32_t i : agreeing) {
    SkyLeaf& lit = lits_[i];
    lit.fitted = glm::dvec3(lit.unit) * glm::max(fit->at(glm::dvec2(lit.leaf->at)), 0.0);
  }
  return true;
}

void SkyFits::divide(const Cell& cell, std::vector<Cell>& quarters) const {
  const Bounds2 box = box_of(lits_, cell);
  const glm::vec2 middle = glm::mix(box.lo, box.hi, 0.5f);
  std::array<Cell, 4> parts;
  for (const std::uint32_t i : cell.lits) {
    const glm::vec2 at = lits_[i].leaf->at;
    parts[(at.x > middle.x ? 1u : 0u) + (at.y > middle.y ? 2u : 0u)].lits.push_back(i);
  }
  for (Cell& part : parts)
    if (part.lits.size() >= SkyTuning::fewest_leaves) quarters.push_back(std::move(part));
}

}  // namespace asos
