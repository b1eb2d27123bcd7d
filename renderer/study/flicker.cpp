#include "renderer/study/flicker.h"

#include "renderer/study/measures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace asos {
namespace {

double root(double square) {
  return std::sqrt(std::max(0.0, square));
}

}  // namespace

void FlickerMeter::add(const Film& film, const Film& first_half, const Film& second_half) {
  const std::size_t pixels = film.radiance.size();
  means_.resize(pixels);
  last_.resize(pixels);
  scatter_.resize(pixels, glm::dvec3(0.0));
  ++frames_;
  for (std::size_t i = 0; i < pixels; ++i) {
    const Errors now{{clipped_difference(film.radiance[i], first_half.radiance[i]),
                      clipped_difference(film.radiance[i], second_half.radiance[i])}};
    const glm::dvec3 before = now.of[0] - means_[i].of[0];
    for (std::size_t h = 0; h < 2; ++h)
      means_[i].of[h] += (now.of[h] - means_[i].of[h]) / static_cast<double>(frames_);
    scatter_[i] += before * (now.of[1] - means_[i].of[1]);
    if (frames_ > 1) step_sum_ += glm::dot(now.of[0] - last_[i].of[0], now.of[1] - last_[i].of[1]);
    last_[i] = now;
  }
}

double FlickerMeter::mean_scatter() const {
  double sum = 0.0;
  for (const glm::dvec3& s : scatter_) sum += s.x + s.y + s.z;
  return sum / (3.0 * static_cast<double>(scatter_.size()) * frames_);
}

double FlickerMeter::mean_steady() const {
  double sum = 0.0;
  for (const Errors& m : means_) sum += glm::dot(m.of[0], m.of[1]);
  return sum / (3.0 * static_cast<double>(means_.size()));
}

double FlickerMeter::flicker() const {
  return root(mean_scatter());
}

double FlickerMeter::steady() const {
  return root(mean_steady());
}

double FlickerMeter::rmse() const {
  return std::hypot(flicker(), steady());
}

double FlickerMeter::step() const {
  if (frames_ < 2) return 0.0;
  return root(step_sum_ / (3.0 * static_cast<double>(last_.size()) * (frames_ - 1)));
}

std::vector<double> FlickerMeter::map() const {
  std::vector<double> flickers;
  flickers.reserve(scatter_.size());
  for (const glm::dvec3& s : scatter_)
    flickers.push_back(root((s.x + s.y + s.z) / (3.0 * frames_)));
  return flickers;
}

double flicker_floor(const FlickerMeter& halves) {
  double sum = 0.0;
  const std::vector<double> map = halves.map();
  for (const double both : map) {
    const double variance = 0.5 * both * both;
    sum += variance * variance;
  }
  const double strays = std::sqrt(sum / (3.0 * halves.frames())) / static_cast<double>(map.size());
  return std::sqrt(2.0 * strays);
}

}  // namespace asos
