#pragma once

#include "renderer/geometry/view.h"
#include "renderer/prepared/render_scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// Where points of the world appear in a view's picture.
class ScreenProjection {
 public:
  explicit ScreenProjection(const View& view)
      : frame_(view.frame(0, 0, view.width(), view.height())), size_(view.width(), view.height()) {}

  [[nodiscard]] glm::dvec2 size() const { return size_; }
  /// Returns the place, in pixels; none: behind the eye.
  [[nodiscard]] std::optional<glm::dvec2> at(glm::dvec3 p) const {
    const glm::dvec3 h = frame_.homogeneous(p);
    if (!frame_.parallel() && !(h.z > 0.0)) return std::nullopt;
    const FramePoint found = frame_.project(h);
    return size_ * glm::dvec2(found.u, found.v);
  }
  /// Returns homogeneous coordinates in the picture, a square from 0 to 1.
  [[nodiscard]] glm::dvec3 homogeneous(glm::dvec3 p) const {
    const glm::dvec3 h = frame_.homogeneous(p);
    return {h.x, h.y, frame_.parallel() ? 1.0 : h.z};
  }

 private:
  Frame frame_;
  glm::dvec2 size_;
};

/// Returns where the world's vertices, and the corners of its analytic shapes' boxes, appear in the
/// picture.
[[nodiscard]] std::vector<std::optional<glm::dvec2>> screen_points(const World& world,
                                                                   const View& view);

/// Returns the point of `to` to which `p` moves, a point of `from` that a ray hit. Both have the
/// same surfaces.
[[nodiscard]] glm::dvec3 point_at(const World& from, const World& to, glm::dvec3 p, const Hit& hit);

/// Returns whether two moments of a scene have the same surfaces, materials and cameras.
[[nodiscard]] bool same_surfaces(const World& a, const World& b);

/// Returns whether two moments of a scene differ by the motion of its surfaces, lights, cameras and
/// materials only: every surface is the same and interacts with rays in the same way.
[[nodiscard]] bool same_but_moved(const World& a, const World& b);

/// Returns how far the surface point of a hit moves from one moment to another.
[[nodiscard]] glm::dvec3 way_of_point(const World& from, const World& to, const Hit& hit);

/// A moment of a scene, and how it is seen.
struct SeenMoment {
  const RenderScene* scene;
  View view;
};

/// How far surfaces move in the picture, in pixels.
struct ScreenWay {
  double in_step = 0.0;  ///< the farthest from one moment to the next
  double in_all = 0.0;   ///< over all moments
  bool known = true;     ///< the moments have the same vertices
};

/// Follows vertices in and near the picture; edges of triangles that leave it; and the points that
/// a grid of rays meets.
[[nodiscard]] ScreenWay screen_way(std::span<const SeenMoment> moments);

}  // namespace asos
