#include "renderer/shadows/shadow_pyrays.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asos {
namespace {

/// A patch around a receiver in units of a window's edges, along the way to the light's middle.
struct PatchInWindow {
  double u = 0.0, v = 0.0;  ///< full widths
};

// How large the patch is beside the light's projection onto it (CGF'98 section 4.3.4): the edges of
// both, seen along the line that joins their middles, in the basis of the light's.
PatchInWindow patch_in_window(const LightWindow& window, const Patch& patch) {
  const glm::dvec3 m = window.towards({0.5, 0.5});
  const glm::dvec3 a = window.frame().base_u(), b = window.frame().base_v();
  const double det = glm::dot(m, glm::cross(a, b));
  const auto along_u = [&](glm::vec3 p) { return glm::dot(glm::dvec3(p), glm::cross(b, m)) / det; };
  const auto along_v = [&](glm::vec3 p) { return glm::dot(glm::dvec3(p), glm::cross(m, a)) / det; };
  return {std::abs(along_u(patch.right)) + std::abs(along_u(patch.down)),
          std::abs(along_v(patch.right)) + std::abs(along_v(patch.down))};
}

/// How the share of the light that is seen bends within the patch, summed over boundaries.
class Bends {
 public:
  Bends(const LightWindow& window, PatchInWindow patch) : frame_(window.frame()), patch_(patch) {}

  // Adds a straight piece of a boundary, in the world.
  void add(glm::dvec3 p, glm::dvec3 q) {
    // Nearness changes along it: a few steps.
    constexpr int steps = 4;
    const glm::dvec3 hp = frame_.homogeneous(p), hq = frame_.homogeneous(q);
    for (int i = 0; i < steps; ++i)
      add_step(hp + (hq - hp) * (i / static_cast<double>(steps)),
               hp + (hq - hp) * ((i + 1) / static_cast<double>(steps)));
  }

  /// The midpoint rule's error of the share, 0 to 1/2 and more.
  [[nodiscard]] double sum() const { return sum_; }

 private:
  void add_step(glm::dvec3 hp, glm::dvec3 hq) {
    const double w = 0.5 * (hp.z + hq.z);
    if (!(w > 0.0) || w >= 1.0 || !(hp.z > 0.0) || !(hq.z > 0.0)) return;
    // How far the boundary moves to either side across the window while the receiver moves over the
    // patch.
    const double eu = 0.5 * patch_.u * (1.0 / w - 1.0), ev = 0.5 * patch_.v * (1.0 / w - 1.0);
    const glm::dvec2 p(hp.x / hp.z, hp.y / hp.z), q(hq.x / hq.z, hq.y / hq.z);
    const glm::dvec2 middle = 0.5 * (p + q);
    const bool out = middle.x < -eu || middle.x > 1.0 + eu || middle.y < -ev || middle.y > 1.0 + ev;
    const bool well_in =
        middle.x > eu && middle.x < 1.0 - eu && middle.y > ev && middle.y < 1.0 - ev;
    if (out || well_in) return;
    const double length = glm::distance(p, q);
    if (!(length > 0.0)) return;
    const glm::dvec2 across = glm::dvec2(std::abs(q.y - p.y), std::abs(q.x - p.x)) / length;
    const double e = eu * across.x + ev * across.y;
    // A boundary that passes the light's rim bends the share, linear on both sides, in the patch's
    // middle at worst: a quarter of what it moves by.
    sum_ += std::min(0.5, 0.25 * e) * std::min(1.0, length);
  }

  const Frame& frame_;
  PatchInWindow patch_;
  double sum_ = 0.0;
};

}  // namespace

float ShadowPyrays::midpoint_error(const PreparedLight& light, std::uint32_t index,
                                   const SurfacePoint& point, const Patch& patch, float reflected,
                                   RenderStatistics& counts) {
  if (settings_.quality != ShadowQuality::refined) return 0.0f;
  const glm::vec3 around = 0.5f * (glm::abs(patch.right) + glm::abs(patch.down));
  if (!std::isfinite(around.x + around.y + around.z)) return 0.0f;
  Box box;
  box.grow(point.position - around);
  box.grow(point.position + around);
  const ShadowKnowledge known = groups_.ask(light, index, point, box, counts.shadow_rays);
  if (known.verdict != ShadowKnowledge::Verdict::open || (known.cut && known.cut->empty()))
    return 0.0f;
  const glm::vec3 unshadowed = unshadowed_irradiance(light, receiver_at(point));
  const float display_intensity =
      std::min(1.0f, reflected * std::max({unshadowed.x, unshadowed.y, unshadowed.z}));
  if (!(display_intensity > settings_.most_uneven)) return 0.0f;

  Receiver receiver = receiver_at(point);
  receiver.position += static_cast<double>(clear_height(point)) * receiver.geometric;
  const auto window = LightWindow::of(light, receiver);
  if (!window) return 0.0f;
  const PatchInWindow size = patch_in_window(*window, patch);
  const double widest = std::max(size.u, size.v);
  if (!(widest > 0.0) || !std::isfinite(widest)) return 0.0f;

  // Boundaries matter up to where the quarter of what they move by is what is let pass, so far
  // along the way to the light.
  const double let_pass = static_cast<double>(settings_.most_uneven / display_intensity);
  const double highest = 1.0 / (1.0 + 8.0 * let_pass / widest);
  // The extended shadow pyray that holds the patch: its apex lies `back` ways to the light behind
  // the surface. Where the patch is larger than half the light, it is aimed at a larger square.
  const double larger = std::max(1.0, 2.0 * widest);
  const double covered = widest / larger;
  const double back = covered / (1.0 - covered);
  const glm::dvec3 m = window->towards({0.5, 0.5});
  const glm::dvec3 apex = receiver.position - back * m;
  const glm::dvec3 a = larger * window->frame().base_u(), b = larger * window->frame().base_v();
  const Frame extended = Frame::pyramid(apex, (1.0 + back) * m - 0.5 * (a + b), a, b);

  const auto between = window->between();
  HalfSpace near[2] = {between[0], {-m, glm::dot(-m, receiver.position + highest * m)}};
  near[0].offset += scene_.features.departure(point.triangle);
  SearchBounds bounds = own_part_ignored(scene_.world, light);
  bounds.cut = known.cut;
  bounds.within = near;
  HitLists& lists = work_.lists;
  lists.reset(scene_.features, extended, 1.0f / 64.0f, bounds);
  if (lists.root().empty()) return 0.0f;
  const Square whole{0.0f, 0.0f, 1.0f};
  constexpr std::size_t most = 64;
  HitLists::List& list = work_.list;
  list.clear();
  for (const std::uint32_t i : lists.root())
    if (!lists.tell_apart(i, whole, 0.0f, most, list)) return 1.0f;  // a thicket
  Bends bends(*window, size);
  for (const std::uint32_t i : list) {
    const Segment& s = lists.segment(i);
    const Clip c = clip(s, whole);
    const auto at = [&](float t) {
      return extended.world(
          {s.u0 + t * (s.u1 - s.u0), s.v0 + t * (s.v1 - s.v0), s.q0 + t * (s.q1 - s.q0)});
    };
    bends.add(at(c.t0), at(c.t1));
  }
  return display_intensity * static_cast<float>(bends.sum());
}

}  // namespace asos
