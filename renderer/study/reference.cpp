#include "renderer/study/reference.h"

#include "renderer/study/measures.h"

namespace asos {

void Reference::add(const Film& first, const Film& second, int samples) {
  width_ = first.width;
  height_ = first.height;
  const std::array<const Film*, 2> films{&first, &second};
  for (std::size_t h = 0; h < 2; ++h) {
    sums_[h].resize(films[h]->radiance.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i < sums_[h].size(); ++i)
      sums_[h][i] += static_cast<double>(samples) * glm::dvec3(films[h]->radiance[i]);
  }
  samples_ += samples;
  ++passes_;
}

Film Reference::half(std::size_t which) const {
  Film film(width_, height_);
  for (std::size_t i = 0; i < film.radiance.size(); ++i)
    film.radiance[i] = glm::vec3(sums_[which][i] / static_cast<double>(samples_));
  return film;
}

Film Reference::film() const {
  Film film(width_, height_);
  for (std::size_t i = 0; i < film.radiance.size(); ++i)
    film.radiance[i] = glm::vec3((sums_[0][i] + sums_[1][i]) / static_cast<double>(samples()));
  return film;
}

double Reference::noise() const {
  return 0.5 * root_mean_square(half(0), half(1), true);
}

bool quiet_enough(double noise, double smallest_error) {
  return 4.0 * noise <= smallest_error;
}

double floor_of(double noise) {
  return 2.0 * noise;
}

}  // namespace asos
