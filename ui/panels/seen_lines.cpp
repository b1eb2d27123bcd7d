#include "ui/panels/seen_lines.h"

#include "renderer/geometry/frame.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace asos::ui {

namespace {

/// The range of a line's parameter, 0 to 1, that is within the picture; empty if `to` is not above
/// `from`.
struct Shares {
  double from = 0.0, to = 1.0;

  /// Keeps the part where a linear function is not negative; `at_a` and `at_b` are its values at
  /// both ends.
  void clip(double at_a, double at_b) {
    if (at_a < 0.0 && at_b < 0.0) to = from - 1.0;
    if ((at_a < 0.0) == (at_b < 0.0)) return;
    const double share = at_a / (at_a - at_b);
    (at_a < 0.0 ? from : to) = at_a < 0.0 ? std::max(from, share) : std::min(to, share);
  }
};

/// Traces rays from the viewer to points of the line.
class Looker {
 public:
  Looker(const RayScene& rays, const View& view, Culling faces, glm::dvec3 a, glm::dvec3 b)
      : rays_(rays),
        view_(view),
        frame_(view.frame(0.0, 0.0, view.width(), view.height())),
        faces_(faces),
        a_(a),
        b_(b) {
    const glm::dvec3 from = frame_.homogeneous(a), to = frame_.homogeneous(b);
    depth_a_ = frame_.parallel() ? 1.0 : from.z;
    depth_b_ = frame_.parallel() ? 1.0 : to.z;
    const double nearest = 1e-6 * std::max(std::abs(depth_a_), std::abs(depth_b_));
    seen_.clip(depth_a_ - nearest, depth_b_ - nearest);
    for (int axis = 0; axis < 2; ++axis) {
      seen_.clip(from[axis], to[axis]);
      seen_.clip(depth_a_ - from[axis], depth_b_ - to[axis]);
    }
  }

  [[nodiscard]] bool outside() const { return !(seen_.from < seen_.to); }
  /// The point of the line at a fraction of its visible length in the picture.
  [[nodiscard]] glm::dvec3 at(double share) const { return glm::mix(a_, b_, of_line(share)); }

  [[nodiscard]] std::vector<bool> hidden(int places) const {
    std::vector<Ray> rays;
    for (int i = 0; i <= places; ++i) rays.push_back(ray_to(static_cast<double>(i) / places));
    std::vector<Hit> hits(rays.size());
    rays_.closest(rays, hits, faces_);
    std::vector<bool> hidden;
    for (const Hit& hit : hits) hidden.push_back(hit.valid());
    return hidden;
  }
  /// Bisects for the change of visibility between two fractions. `from_hidden`: whether the first
  /// one is hidden.
  [[nodiscard]] double change(double from, double to, bool from_hidden) const {
    for (int step = 0; step < steps_to_change; ++step) {
      const double middle = 0.5 * (from + to);
      (rays_.closest(ray_to(middle), faces_).valid() == from_hidden ? from : to) = middle;
    }
    return 0.5 * (from + to);
  }

 private:
  static constexpr double touching = 1e-3;  // fraction of the distance to the point
  static constexpr int steps_to_change = 6;

  // Converts a fraction of the visible length in the picture to the line's parameter, with the
  // correction for perspective.
  [[nodiscard]] double of_line(double share) const {
    const double from = glm::mix(depth_a_, depth_b_, seen_.from);
    const double to = glm::mix(depth_a_, depth_b_, seen_.to);
    return glm::mix(seen_.from, seen_.to, share * from / (share * from + (1.0 - share) * to));
  }
  // The ray ends just before the point.
  [[nodiscard]] Ray ray_to(double share) const {
    const glm::dvec3 point = at(share);
    const FramePoint p = frame_.project(frame_.homogeneous(point));
    Ray ray = view_.ray(p.u * view_.width(), p.v * view_.height());
    const double distance = glm::distance(point, glm::dvec3(ray.origin));
    ray.t_far = static_cast<float>((1.0 - touching) * distance);
    return ray;
  }

  const RayScene& rays_;
  const View& view_;
  Frame frame_;
  Culling faces_;
  glm::dvec3 a_, b_;
  double depth_a_ = 1.0, depth_b_ = 1.0;
  Shares seen_;
};

}  // namespace

std::vector<LinePart> seen_parts(const RayScene& rays, const View& view, Culling faces,
                                 glm::dvec3 a, glm::dvec3 b, int places) {
  const Looker looker(rays, view, faces, a, b);
  if (looker.outside()) return {};
  const std::vector<bool> hidden = looker.hidden(places);
  std::vector<LinePart> parts;
  double from = 0.0;
  for (int i = 0; i < places; ++i) {
    const bool here = hidden[static_cast<std::size_t>(i)];
    if (hidden[static_cast<std::size_t>(i) + 1] == here) continue;
    const double to =
        looker.change(static_cast<double>(i) / places, static_cast<double>(i + 1) / places, here);
    parts.push_back({looker.at(from), looker.at(to), here});
    from = to;
  }
  parts.push_back({looker.at(from), looker.at(1.0), hidden.back()});
  return parts;
}

}  // namespace asos::ui
