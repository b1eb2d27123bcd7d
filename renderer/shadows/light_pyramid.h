#pragma once

#include "renderer/geometry/frame.h"
#include "renderer/geometry/half_space.h"
#include "renderer/lights/light_window.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/pyray/square.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// An extended light as seen from a receiver: the pyramid from the receiver around the light's
/// bounding rectangle (CGF'98 section 4.2), and the light's part of that square.
class LightPyramid {
 public:
  /// Returns the pyramid with the apex at the receiver's position, which must be clear of its
  /// surface. Returns nothing for a light without an extent, a segment, a ball around the receiver,
  /// and a light whose plane contains the receiver.
  [[nodiscard]] static std::optional<LightPyramid> of(const PreparedLight& light,
                                                      const Receiver& receiver);

  [[nodiscard]] const Frame& frame() const { return frame_; }

  /// Returns lines of the square where the light or the receiver's hemisphere ends, and where
  /// surfaces pass through the light. A disk's rim is not among them; `form` includes it exactly.
  [[nodiscard]] std::span<const BorderEdge> boundaries() const { return boundaries_; }
  /// Returns whether a point of the square is on the light (ignoring a disk's rim) and above the
  /// horizon.
  [[nodiscard]] bool holds(glm::vec2 p) const;

  /// Returns the projected solid angle, 0 to pi, of the light's part in a region of the square. It
  /// is Lambert's contour sum over the region's sides and, for disks, the arcs between them.
  [[nodiscard]] double form(const LeafRegion& region) const;

  /// Returns the vector from the apex to a point of the square: on the light's plane, or a
  /// direction if the light is infinitely distant.
  [[nodiscard]] glm::dvec3 towards(glm::dvec2 p) const {
    return p.x * frame_.base_u() + p.y * frame_.base_v() + frame_.base_corner();
  }
  [[nodiscard]] bool infinitely_far() const { return infinite_; }
  /// Returns whether the light is the disk that touches the square's sides.
  [[nodiscard]] bool round() const { return round_; }

  /// Returns the half-spaces between the receiver's horizon and the light.
  [[nodiscard]] std::span<const HalfSpace> between() const {
    return std::span(between_).first(infinite_ ? 1 : 2);
  }

 private:
  LightPyramid(const PreparedLight& light, const LightWindow& window, const Receiver& receiver,
               const Frame& frame);

  void add_horizon(glm::dvec3 normal);
  void add_outlines(const PreparedLight& light);
  void add_silhouette(const LightWindow& window);
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
  std::size_t outline_sides_ = 0;  // number of the outline's sides, which come first in boundaries_
  /// Above the horizon: x u + y v + z >= 0.
  std::array<glm::dvec3, 2> horizons_;
  int horizon_count_ = 0;
};

/// Returns the fraction of the way along `towards`, from a point to a light's window, at which
/// shadow rays end: just before the light.
[[nodiscard]] float end_before_light(const PreparedLight& light, glm::dvec3 from,
                                     glm::dvec3 towards);

}  // namespace asos
