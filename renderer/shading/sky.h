#pragma once

#include "renderer/result.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/gradient.h"
#include "renderer/shading/side_light.h"
#include "renderer/shading/sky_choice.h"
#include "renderer/shading/sky_map.h"

#include <glm/glm.hpp>

#include <memory>
#include <string>

namespace asos {

/// The surroundings of a scene, infinitely far away: linear radiance by direction. +Y is up.
/// Immutable.
class Sky {
 public:
  /// The same radiance from everywhere.
  explicit Sky(glm::vec3 radiance) : Sky(radiance, radiance) {}
  /// From the horizon to the zenith linear in the sine of the elevation; below the horizon as at
  /// the horizon.
  Sky(glm::vec3 zenith, glm::vec3 horizon);
  /// A gradient up and down from the horizon, and what varies with the azimuth; or a picture.
  explicit Sky(Environment environment);
  /// An equirectangular picture that is turned about +Y, counter-clockwise as seen from above; at 0
  /// its middle is at -Z. `file` is where it comes from.
  Sky(SkyMap map, double turn_deg, std::string file);

  /// The mean over the directions `direction` + a `right` + b `down`, a and b from -1/2 to 1/2, all
  /// weighing the same, of a unit direction; steps of 0: at a point. Exact for constant skies;
  /// within a few thousandths for gradients. Patches of steps of up to 5 are resolved.
  [[nodiscard]] glm::vec3 radiance(glm::vec3 direction, glm::vec3 right = glm::vec3(0.0f),
                                   glm::vec3 down = glm::vec3(0.0f)) const;

  /// The mean over the square of this width around a unit direction, within a few hundredths: for
  /// the lobes of surfaces.
  [[nodiscard]] glm::vec3 around(glm::vec3 direction, float width) const;

  /// The irradiance over pi of a surface with this unit normal, times sky_visibility.
  [[nodiscard]] glm::vec3 ambient(glm::vec3 normal) const;

  /// A direction of the picture, at a place in the unit square, as its light comes from there; and
  /// the density of such at a unit direction, per steradian. Only of pictures.
  [[nodiscard]] SkyDirection bright_direction(glm::dvec2 place) const;
  [[nodiscard]] double bright_density(glm::vec3 direction) const;

  /// The same sky with its picture or environment turned by this angle from its first position. A
  /// sky of colours stays as it is.
  [[nodiscard]] Sky turned(double turn_deg) const;
  /// The same sky with the radiance of its picture or environment multiplied by `times`, likewise.
  [[nodiscard]] Sky brightened(double times) const;

  /// Whether it is the same all over.
  [[nodiscard]] bool constant() const { return !map_ && gradient_.constant() && sides_.none(); }
  [[nodiscard]] bool is_picture() const { return map_ != nullptr; }

  /// As on the command line: the environment, "R,G,B:R,G,B" or the file, how it is turned and how
  /// bright.
  [[nodiscard]] std::string name() const;
  /// The choice that it was made from.
  [[nodiscard]] const SkyChoice& choice() const { return choice_; }

 private:
  struct Directions {
    glm::dvec3 middle, right, down;
  };
  void follow_environment();
  [[nodiscard]] glm::dvec3 mean_of_parts(const Directions& all, int across_right,
                                         int across_down) const;
  [[nodiscard]] glm::dvec3 in_map(glm::dvec3 direction) const;
  [[nodiscard]] glm::dvec3 part_mean(glm::dvec3 direction, glm::dvec3 right, glm::dvec3 down) const;

  Gradient gradient_;
  SideLight sides_;
  std::shared_ptr<const SkyMap> map_;
  double brightness_ = 1.0;  // of the picture
  double turn_cos_ = 1.0;
  double turn_sin_ = 0.0;
  SkyChoice choice_;
};

/// The sky of a file: .hdr (Radiance) or .exr, linear, twice as wide as it is high. Errors name the
/// file: it cannot be read, has other proportions or more than 2^26 texels, or texels that are not
/// finite or are negative, which are counted.
[[nodiscard]] Result<std::shared_ptr<const Sky>> read_sky(const std::string& path,
                                                          double turn_deg = 0.0);

// Functions for shading. A null sky is the neutral one of environment.h.

/// Radiance of the background around a unit direction, averaged over a square of `side` pixels
/// where there is a `spacing`.
[[nodiscard]] glm::vec3 background(const Sky* sky, glm::vec3 direction, const PixelSpacing* spacing,
                                   float side);

/// The radiance of the sky that a surface reflects towards the viewer: diffusely, and by its lobe
/// around the mirrored direction. Not occluded but for sky_visibility and mirrored_visibility: for
/// `sample_sky` see sky_light.h.
[[nodiscard]] glm::vec3 reflected_sky(const Sky* sky, const ViewedMaterial& seen, glm::vec3 normal,
                                      glm::vec3 to_viewer);

}  // namespace asos
