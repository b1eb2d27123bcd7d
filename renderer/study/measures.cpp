#include "renderer/study/measures.h"

#include "renderer/study/colour_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {
namespace {

bool is_finite(glm::vec3 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Written so that NaN becomes white or black, whichever is farther from the other value.
glm::vec3 shown(glm::vec3 v, glm::vec3 beside) {
  glm::vec3 clipped;
  for (int c = 0; c < 3; ++c)
    clipped[c] = std::isnan(v[c]) ? (beside[c] < 0.5f ? 1.0f : 0.0f) : std::clamp(v[c], 0.0f, 1.0f);
  return clipped;
}

/// Returns the value that a fraction of all do not exceed, by nearest rank.
double percentile(const std::vector<double>& sorted, double share) {
  const auto count = static_cast<double>(sorted.size());
  const auto rank = static_cast<std::size_t>(std::max(1.0, std::ceil(share * count)));
  return sorted[std::min(rank, sorted.size()) - 1];
}

double mean_absolute(glm::vec3 a, glm::vec3 b) {
  const glm::dvec3 d = glm::abs(glm::dvec3(shown(a, b)) - glm::dvec3(b));
  return (d.x + d.y + d.z) / 3.0;
}

}  // namespace

glm::dvec3 clipped_difference(glm::vec3 a, glm::vec3 b) {
  b = glm::clamp(b, 0.0f, 1.0f);
  return glm::dvec3(shown(a, b)) - glm::dvec3(b);
}

double squared_error(glm::vec3 a, glm::vec3 b, bool clipped) {
  if (!clipped && !is_finite(a)) return std::numeric_limits<double>::infinity();
  const glm::dvec3 d = clipped ? clipped_difference(a, b) : glm::dvec3(a) - glm::dvec3(b);
  return glm::dot(d, d) / 3.0;
}

double root_mean_square(const Film& film, const Film& reference, bool clipped) {
  double sum = 0.0;
  for (std::size_t i = 0; i < reference.radiance.size(); ++i)
    sum += squared_error(film.radiance[i], reference.radiance[i], clipped);
  return std::sqrt(sum / static_cast<double>(reference.radiance.size()));
}

Measures measure(const Film& film, const Film& reference) {
  Measures m;
  std::vector<double> errors;
  errors.reserve(reference.radiance.size());
  for (std::size_t i = 0; i < reference.radiance.size(); ++i) {
    const glm::vec3 b = glm::clamp(reference.radiance[i], 0.0f, 1.0f);
    const glm::vec3 a = shown(film.radiance[i], b);
    errors.push_back(std::sqrt(squared_error(a, b, true)));
    m.mae += mean_absolute(a, b);
    m.rmse_display += squared_error(display_rgb(a, 0.0f), display_rgb(b, 0.0f), false);
    m.perceptual += ciede2000(lab_of_linear_srgb(a), lab_of_linear_srgb(b));
  }
  const auto count = static_cast<double>(errors.size());
  m.rmse = root_mean_square(film, reference, true);
  m.rmse_raw = root_mean_square(film, reference, false);
  m.mae /= count;
  m.rmse_display = std::sqrt(m.rmse_display / count);
  m.perceptual /= count;
  std::sort(errors.begin(), errors.end());
  m.p99 = percentile(errors, 0.99);
  m.p999 = percentile(errors, 0.999);
  m.max = errors.back();
  return m;
}

RegionErrors region_errors(const Film& film, const Film& reference,
                           const std::vector<Region>& regions) {
  RegionErrors all{};
  double total = 0.0;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    RegionError& region = all[static_cast<std::size_t>(regions[i])];
    const double error = squared_error(film.radiance[i], reference.radiance[i], true);
    ++region.pixels;
    region.share += error;
    total += error;
  }
  for (RegionError& region : all) {
    if (region.pixels > 0)
      region.rmse = std::sqrt(region.share / static_cast<double>(region.pixels));
    region.share = total > 0.0 ? region.share / total : 0.0;
  }
  return all;
}

}  // namespace asos
