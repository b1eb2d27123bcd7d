#include "ui/frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace asos {

bool Frames::store(const Film& film, std::string summary) {
  if (stored.size() >= most || film.width <= 0) return false;
  // The first letter that is free.
  char letter = 'A';
  const auto taken = [&](char c) {
    return std::any_of(stored.begin(), stored.end(),
                       [c](const StoredFrame& frame) { return frame.name == std::string(1, c); });
  };
  while (taken(letter)) ++letter;
  stored.push_back({std::string(1, letter), std::move(summary), film});
  chosen = static_cast<int>(stored.size()) - 1;
  ++revision;
  return true;
}

void Frames::remove(int index) {
  if (index < 0 || index >= static_cast<int>(stored.size())) return;
  stored.erase(stored.begin() + index);
  chosen = std::clamp(chosen, 0, std::max(0, static_cast<int>(stored.size()) - 1));
  if (stored.empty()) comparison = Comparison::none;
  ++revision;
}

const StoredFrame* Frames::compared() const {
  if (comparison == Comparison::none || chosen < 0 || chosen >= static_cast<int>(stored.size()))
    return nullptr;
  return &stored[static_cast<std::size_t>(chosen)];
}

float difference_of(glm::vec3 a, glm::vec3 b, float exposure_ev) {
  const glm::vec3 d = glm::abs(display_rgb(a, exposure_ev) - display_rgb(b, exposure_ev));
  return std::max({d.x, d.y, d.z});
}

glm::u8vec3 difference_colour(float share) {
  // From black over violet and orange to white, ever brighter, so that it reads without colour too.
  constexpr std::array<std::array<float, 3>, 5> stops{
      {{0, 0, 0}, {87, 16, 110}, {188, 55, 84}, {249, 142, 9}, {255, 255, 255}}};
  const float at = std::clamp(std::isfinite(share) ? share : 1.0f, 0.0f, 1.0f) * 4.0f;
  const auto index = static_cast<std::size_t>(std::min(3.0f, std::floor(at)));
  const float part = at - static_cast<float>(index);
  glm::u8vec3 colour;
  for (std::size_t k = 0; k < 3; ++k) {
    const float value = stops[index][k] + part * (stops[index + 1][k] - stops[index][k]);
    colour[static_cast<int>(k)] = static_cast<std::uint8_t>(value + 0.5f);
  }
  return colour;
}

}  // namespace asos
