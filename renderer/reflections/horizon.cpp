#include "renderer/reflections/horizon.h"

namespace asos {
namespace {

constexpr glm::dvec2 corners[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

}  // namespace

double Horizon::share_above() const {
  // Shoelace formula over the square clipped by the line.
  glm::dvec2 first(0.0), last(0.0);
  bool started = false;
  double twice = 0.0;
  const auto add = [&](glm::dvec2 p) {
    if (started) {
      twice += last.x * p.y - last.y * p.x;
    } else {
      first = p;
      started = true;
    }
    last = p;
  };
  for (int i = 0; i < 4; ++i) {
    const glm::dvec2 p = corners[i], q = corners[(i + 1) % 4];
    const double hp = at(p), hq = at(q);
    if (hp > 0.0) add(p);
    if ((hp > 0.0) != (hq > 0.0)) add(p + hp / (hp - hq) * (q - p));
  }
  if (started) twice += last.x * first.y - last.y * first.x;
  return 0.5 * twice;
}

std::optional<std::pair<glm::vec2, glm::vec2>> Horizon::line() const {
  glm::vec2 ends[2];
  int found = 0;
  for (int i = 0; i < 4; ++i) {
    const glm::dvec2 p = corners[i], q = corners[(i + 1) % 4];
    const double hp = at(p), hq = at(q);
    if ((hp > 0.0) != (hq > 0.0) && found < 2)
      ends[found++] = glm::vec2(p + hp / (hp - hq) * (q - p));
  }
  if (found < 2) return std::nullopt;
  return std::pair(ends[0], ends[1]);
}

}  // namespace asos
