#pragma once

#include <glm/glm.hpp>

namespace asos {

/// Moments of the unit directions to the points of a disk, one unit ahead, that has the area of a
/// square of some width: the mean component along the axis, and the mean of its square.
struct DiskMoments {
  float along = 1.0f;
  float squared = 1.0f;

  [[nodiscard]] static DiskMoments of(float width);
};

/// Radiance as a function of a direction's height, the sine of its elevation (+Y is up). It is
/// linear from the horizon to the zenith, and from the horizon to the nadir. A step at the horizon
/// is smoothed over heights from -`ramp` to `ramp`. Immutable.
class Gradient {
 public:
  struct Colours {
    glm::vec3 zenith{0.0f};
    glm::vec3 above{0.0f};  ///< just above the horizon
    glm::vec3 below{0.0f};
    glm::vec3 nadir{0.0f};
    bool operator==(const Colours&) const = default;
  };
  /// Half of the height over which a studio's wall blends into its floor: 3.4 degrees up and down.
  static constexpr double ramp = 0.06;

  Gradient() = default;
  explicit Gradient(const Colours& colours);

  /// Returns the mean over directions whose heights are evenly distributed within `half_range` of
  /// `height`. Approximate for other distributions of the same variance.
  [[nodiscard]] glm::dvec3 mean(double height, double half_range) const;

  /// Returns the mean around a unit direction of this height, over a disk with the area of a square
  /// of `width`, one unit ahead. Non-linear parts assume evenly distributed heights; their error is
  /// within 2 % of the brightest value. See Sky::around.
  [[nodiscard]] glm::dvec3 around(double height, double width) const;

  /// Returns the irradiance over pi of a surface with this unit normal under the whole gradient.
  /// Closed form, up to the third order of the ramp.
  [[nodiscard]] glm::dvec3 irradiance_over_pi(glm::dvec3 normal) const;

  [[nodiscard]] bool constant() const;
  /// Returns whether the radiance is linear for heights within `reach` of this one.
  [[nodiscard]] bool linear_near(double height, double reach) const;
  [[nodiscard]] glm::vec3 zenith() const { return colours_.zenith; }

 private:
  /// Weights of the components of the gradient.
  struct Parts {
    double up = 0.0;    ///< of the zenith's difference from the horizon
    double down = 0.0;  ///< of the nadir's difference from the horizon
    double over = 0.0;  ///< of the step at the horizon, 0 to 1
  };
  [[nodiscard]] Parts parts_at(double height, double half_range) const;
  [[nodiscard]] glm::dvec3 sum_of(const Parts& parts) const;

  Colours colours_;
  glm::dvec3 below_{0.0};
  glm::dvec3 up_{0.0};
  glm::dvec3 down_{0.0};
  glm::dvec3 step_{0.0};
  bool has_step_ = false;
};

}  // namespace asos
