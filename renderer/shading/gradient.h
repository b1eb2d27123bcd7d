#pragma once

#include <glm/glm.hpp>

namespace asos {

/// Means over the unit directions of a disk around one, of the area of a square of a width, one
/// unit ahead: of their component along it, and of its square.
struct DiskMoments {
  float along = 1.0f;
  float squared = 1.0f;

  [[nodiscard]] static DiskMoments of(float width);
};

/// Radiance by the height of a direction, the sine of its elevation (+Y is up): linear from the
/// horizon to the zenith, and from there to the nadir. Where what is above the horizon differs from
/// what is below, one goes over into the other over heights from -`ramp` to `ramp`. Immutable.
class Gradient {
 public:
  struct Colours {
    glm::vec3 zenith{0.0f};
    glm::vec3 above{0.0f};  ///< just above the horizon
    glm::vec3 below{0.0f};
    glm::vec3 nadir{0.0f};
    bool operator==(const Colours&) const = default;
  };
  /// Half of the height over which a studio's wall becomes its floor: 3.4 degrees up and down.
  static constexpr double ramp = 0.06;

  Gradient() = default;
  explicit Gradient(const Colours& colours);

  /// The mean over directions about a unit one whose heights are as far from its own as those of a
  /// range of twice `half_range`: exact for a range of heights.
  [[nodiscard]] glm::dvec3 mean(double height, double half_range) const;

  /// The mean around a unit direction of this height, over a disk of the area of a square of
  /// `width`, one unit ahead; what is not linear in the height as if heights were spread evenly:
  /// within two hundredths of the brightest. See Sky::around.
  [[nodiscard]] glm::dvec3 around(double height, double width) const;

  /// The irradiance over pi of a surface with this unit normal under the whole of it: closed form
  /// (but for the third order of the ramp).
  [[nodiscard]] glm::dvec3 irradiance_over_pi(glm::dvec3 normal) const;

  /// Whether it is the same all over.
  [[nodiscard]] bool constant() const;
  /// Whether it is linear in the height where heights differ from this one by no more than `reach`.
  [[nodiscard]] bool linear_near(double height, double reach) const;
  /// The colour at the zenith.
  [[nodiscard]] glm::vec3 zenith() const { return colours_.zenith; }

 private:
  /// Of what the gradient is the sum of, how much there is.
  struct Parts {
    double up = 0.0;    ///< of what the zenith is above the horizon
    double down = 0.0;  ///< of what the nadir is below it
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
