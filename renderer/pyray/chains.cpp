#include "renderer/pyray/chains.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

constexpr std::uint32_t none = 0xffffffffu;

float distance_to_segment(glm::vec2 p, glm::vec2 a, glm::vec2 b) {
  const glm::vec2 d = b - a;
  const float length2 = glm::dot(d, d);
  const float t = length2 > 0.0f ? std::clamp(glm::dot(p - a, d) / length2, 0.0f, 1.0f) : 0.0f;
  return glm::distance(p, a + t * d);
}

bool is_point(const Segment& s) {
  return s.u0 == s.u1 && s.v0 == s.v1;
}

}  // namespace

std::span<const Segment> ChainSimplifier::simplify(std::span<const Segment> segments,
                                                   float tolerance) {
  simplified_.clear();
  chain_count_ = 0;
  join(segments);
  used_.assign(segments.size(), 0);
  for (std::uint32_t s = 0; s < segments.size(); ++s) {
    if (!is_point(segments[s])) continue;
    used_[s] = 1;
    simplified_.push_back(segments[s]);
  }
  // Chains with loose ends come first; the remaining ones are closed.
  for (const bool closed : {false, true}) {
    for (std::uint32_t s = 0; s < segments.size(); ++s) {
      if (used_[s]) continue;
      const bool loose_first = partner_[2 * s] == none;
      if (!closed && !loose_first && partner_[2 * s + 1] != none) continue;
      walk(segments, s, !closed && !loose_first);
      emit_chain(tolerance);
      ++chain_count_;
    }
  }
  return simplified_;
}

// Finds, for each segment's end, the single other end at the same place.
void ChainSimplifier::join(std::span<const Segment> segments) {
  ends_.clear();
  for (std::uint32_t s = 0; s < segments.size(); ++s) {
    if (is_point(segments[s])) continue;
    ends_.push_back({{segments[s].u0, segments[s].v0}, s, false});
    ends_.push_back({{segments[s].u1, segments[s].v1}, s, true});
  }
  std::sort(ends_.begin(), ends_.end(), [](const End& x, const End& y) {
    if (x.at.x != y.at.x) return x.at.x < y.at.x;
    if (x.at.y != y.at.y) return x.at.y < y.at.y;
    return x.segment < y.segment;
  });
  partner_.assign(2 * segments.size(), none);
  const auto number = [](const End& end) { return 2 * end.segment + (end.second ? 1u : 0u); };
  for (std::size_t i = 0; i < ends_.size();) {
    std::size_t next = i + 1;
    while (next < ends_.size() && ends_[next].at == ends_[i].at) ++next;
    if (next - i == 2 && ends_[i].segment != ends_[i + 1].segment) {
      partner_[number(ends_[i])] = number(ends_[i + 1]);
      partner_[number(ends_[i + 1])] = number(ends_[i]);
    }
    i = next;
  }
}

// Follows the chain that begins with segment `start`, at its second or first end.
void ChainSimplifier::walk(std::span<const Segment> segments, std::uint32_t start,
                           bool from_second) {
  chain_.clear();
  edge_ = segments[start].edge;
  std::uint32_t entry = 2 * start + (from_second ? 1u : 0u);
  const auto joint = [&](std::uint32_t end) {
    const Segment& s = segments[end / 2];
    return end & 1 ? Joint{s.u1, s.v1, s.nearness1} : Joint{s.u0, s.v0, s.nearness0};
  };
  chain_.push_back(joint(entry));
  while (entry != none && !used_[entry / 2]) {
    used_[entry / 2] = 1;
    chain_.push_back(joint(entry ^ 1u));
    entry = partner_[entry ^ 1u];
  }
}

void ChainSimplifier::emit_chain(float tolerance) {
  const std::size_t last = chain_.size() - 1;
  const Joint& a = chain_.front();
  const Joint& b = chain_[last];
  if (last < 2 || a.u != b.u || a.v != b.v) {
    emit_range(0, last, tolerance);
    return;
  }
  // A closed chain has no ends. It is fixed at its start and at the joint farthest from it.
  std::size_t farthest = 1;
  float most = -1.0f;
  for (std::size_t i = 1; i < last; ++i) {
    const float d = glm::distance(glm::vec2(chain_[i].u, chain_[i].v), glm::vec2(a.u, a.v));
    if (d > most) most = d, farthest = i;
  }
  emit_range(0, farthest, tolerance);
  emit_range(farthest, last, tolerance);
}

void ChainSimplifier::emit_range(std::size_t first, std::size_t last, float tolerance) {
  const glm::vec2 a(chain_[first].u, chain_[first].v), b(chain_[last].u, chain_[last].v);
  std::size_t farthest = first;
  float most = tolerance;
  for (std::size_t i = first + 1; i < last; ++i) {
    const float d = distance_to_segment({chain_[i].u, chain_[i].v}, a, b);
    if (d > most) most = d, farthest = i;
  }
  if (farthest != first) {
    emit_range(first, farthest, tolerance);
    emit_range(farthest, last, tolerance);
    return;
  }
  // Use the largest nearness along the chain, so that no visible boundary counts as hidden.
  float nearness0 = chain_[first].nearness, nearness1 = chain_[last].nearness;
  for (std::size_t i = first + 1; i < last; ++i) {
    nearness0 = std::max(nearness0, chain_[i].nearness);
    nearness1 = std::max(nearness1, chain_[i].nearness);
  }
  simplified_.push_back({a.x, a.y, nearness0, b.x, b.y, nearness1, edge_});
}

}  // namespace asos
