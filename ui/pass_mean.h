#pragma once

#include "renderer/film/film.h"
#include "renderer/geometry/largest.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace asos::ui {

/// Mean of passes, and the standard error of its linear radiance (Welford 1962). The mean has all
/// that a display needs: radiance, unlit parts and coverage.
class PassMean {
 public:
  void add(const Film& pass) {
    if (count_ == 0) {
      film_ = Film(pass.width, pass.height);
      squares_.assign(film_.radiance.size(), glm::vec3(0.0f));
    }
    ++count_;
    const float share = 1.0f / static_cast<float>(count_);
    for (std::size_t i = 0; i < film_.radiance.size(); ++i) {
      glm::vec3& mean = film_.radiance[i];
      const glm::vec3 before = pass.radiance[i] - mean;
      mean += share * before;
      squares_[i] += before * (pass.radiance[i] - mean);
    }
    average(pass.unlit, glm::vec4(0.0f), share, film_.unlit);
    average(pass.coverage, 1.0f, share, film_.coverage);
  }
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] const Film& film() const { return film_; }
  [[nodiscard]] std::vector<float> uncertainty() const {
    const auto n = static_cast<float>(count_);
    std::vector<float> errors;
    errors.reserve(squares_.size());
    for (const glm::vec3& sum : squares_)
      errors.push_back(std::sqrt(largest(sum) / std::max(1.0f, n * (n - 1.0f))));
    return errors;
  }

 private:
  // `usual`: the value of pixels of a film that has none.
  template <typename T>
  void average(const std::vector<T>& pass, T usual, float share, std::vector<T>& mean) const {
    if (pass.empty() && mean.empty()) return;
    if (mean.empty()) mean.assign(film_.radiance.size(), usual);
    for (std::size_t i = 0; i < mean.size(); ++i)
      mean[i] += share * ((pass.empty() ? usual : pass[i]) - mean[i]);
  }

  int count_ = 0;
  Film film_;
  std::vector<glm::vec3> squares_;
};

}  // namespace asos::ui
