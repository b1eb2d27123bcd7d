#pragma once

#include "renderer/geometry/frame.h"
#include "renderer/geometry/half_space.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/pyray/square.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// A light of some size as a receiver sees it: the pyramid from the receiver around a rectangle
/// around the light (CGF'98 section 4.2), and what part of that square the light fills.
class LightWindow {
 public:
  /// The apex is the receiver's position, moved off its surface. Nothing for a light without a
  /// size, a segment, a ball around the receiver, and one in whose plane the receiver lies.
  [[nodiscard]] static std::optional<LightWindow> of(const PreparedLight& light,
                                                     const Receiver& receiver);

  [[nodiscard]] const Frame& frame() const { return frame_; }

  /// Lines of the square where the light, or the receiver's sky, ends, and where surfaces pass
  /// through the light. A disk's rim is not among them: it is taken account of exactly in `form`.
  [[nodiscard]] std::span<const BorderEdge> boundaries() const { return boundaries_; }
  /// Whether a point of the square is on the light, but for a disk's rim, and above the horizon.
  [[nodiscard]] bool holds(glm::vec2 p) const;

  /// The projected solid angle, 0 to pi, of the part of the light that lies in a region of the
  /// square: Lambert's contour sum over the region's sides and, of disks, the arcs between.
  [[nodiscard]] double form(const LeafRegion& region) const;

  /// From the apex to a point of the square: of the light's plane, or a direction if it is
  /// infinitely far.
  [[nodiscard]] glm::dvec3 towards(glm::dvec2 p) const {
    return p.x * frame_.base_u() + p.y * frame_.base_v() + frame_.base_corner();
  }
  [[nodiscard]] bool infinitely_far() const { return infinite_; }
  /// The light is the disk that touches the square's sides.
  [[nodiscard]] bool round() const { return round_; }

  /// The half-spaces between the receiver's horizon and the light.
  [[nodiscard]] std::span<const HalfSpace> between() const {
    return std::span(between_).first(infinite_ ? 1 : 2);
  }

 private:
  LightWindow(const PreparedLight& light, const Receiver& receiver, const Frame& frame);

  void add_horizon(glm::dvec3 normal);
  void add_outlines(const PreparedLight& light);
  void add_cuts(const PreparedLight& light);
  [[nodiscard]] double arc(double from, double to) const;
  [[nodiscard]] double round_form(const LeafRegion& region) const;

  Frame frame_;
  glm::dvec3 normal_;
  double orientation_ = 1.0;  // -1: seen from the apex, sides run clockwise
  bool round_ = false;
  bool infinite_ = false;
  std::array<HalfSpace, 2> between_;
  std::vector<BorderEdge> boundaries_;
  std::size_t outline_sides_ = 0;  // the first of the boundaries
  /// Above the horizon: x u + y v + z >= 0.
  std::array<glm::dvec3, 2> horizons_;
  int horizon_count_ = 0;
};

/// How much of the way that a ray goes along `towards`, to a light's window, it may go until it is
/// at the light: up to the window's plane, or to where it enters a ball, whose window is at its
/// rim.
[[nodiscard]] float way_to_light(const PreparedLight& light, glm::dvec3 from, glm::dvec3 towards);

}  // namespace asos
