#include "renderer/features/edge_chain.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace asos {
namespace {

float distance_to_line(glm::vec3 p, glm::vec3 a, glm::vec3 b) {
  const glm::vec3 d = b - a;
  const float length2 = glm::dot(d, d);
  const float t = length2 > 0.0f ? std::clamp(glm::dot(p - a, d) / length2, 0.0f, 1.0f) : 0.0f;
  return glm::distance(p, a + t * d);
}

}  // namespace

std::optional<EdgeChain> join(std::span<const glm::vec3> positions,
                              std::span<const std::optional<EdgeChain>> parts) {
  if (!std::all_of(parts.begin(), parts.end(), [](const auto& part) { return part.has_value(); }))
    return std::nullopt;
  std::vector<EdgeChain> all;
  for (const auto& part : parts) all.push_back(*part);
  std::vector<EdgeChain> left(all.begin() + 1, all.end());
  EdgeChain whole = all.front();
  while (!left.empty()) {
    const auto next = std::find_if(left.begin(), left.end(), [&](const EdgeChain& c) {
      return c.from == whole.to || c.to == whole.to || c.from == whole.from || c.to == whole.from;
    });
    if (next == left.end()) return std::nullopt;
    EdgeChain c = *next;
    if (c.to == whole.to || c.to == whole.from) std::swap(c.from, c.to);
    (c.from == whole.to ? whole.to : whole.from) = c.to;
    left.erase(next);
  }
  if (whole.from == whole.to) return std::nullopt;
  // A chain between two joints is at most as far from the line as the joints are, plus its own
  // deviation.
  const glm::vec3 a = positions[whole.from], b = positions[whole.to];
  whole.deviation = 0.0f;
  for (const EdgeChain& c : all) {
    const float joints = std::max(distance_to_line(positions[c.from], a, b),
                                  distance_to_line(positions[c.to], a, b));
    whole.deviation = std::max(whole.deviation, joints + c.deviation);
  }
  return whole;
}

}  // namespace asos
