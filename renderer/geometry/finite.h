#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace asos {

/// Returns whether all components are finite numbers.
template <glm::length_t L, typename T, glm::qualifier Q>
[[nodiscard]] bool finite(const glm::vec<L, T, Q>& v) {
  for (glm::length_t i = 0; i < L; ++i)
    if (!std::isfinite(v[i])) return false;
  return true;
}
template <glm::length_t C, glm::length_t R, typename T, glm::qualifier Q>
[[nodiscard]] bool finite(const glm::mat<C, R, T, Q>& m) {
  for (glm::length_t c = 0; c < C; ++c)
    if (!finite(m[c])) return false;
  return true;
}

}  // namespace asos
