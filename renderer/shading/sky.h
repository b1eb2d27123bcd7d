#pragma once

#include "renderer/result.h"
#include "renderer/shading/azimuth_variation.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/gradient.h"
#include "renderer/shading/sky_choice.h"
#include "renderer/shading/sky_lobes.h"
#include "renderer/shading/sky_map.h"

#include <glm/glm.hpp>

#include <memory>
#include <string>

namespace asos {

/// The infinitely distant surroundings of a scene: linear radiance by direction. +Y is up.
/// Immutable.
class Sky {
 public:
  /// The same radiance from all directions.
  explicit Sky(glm::vec3 radiance) : Sky(radiance, radiance) {}
  /// Linear in the sine of the elevation from the horizon to the zenith; constant below the
  /// horizon.
  Sky(glm::vec3 zenith, glm::vec3 horizon);
  /// A gradient with variation by azimuth, or a picture.
  explicit Sky(Environment environment);
  /// An equirectangular picture that is turned about +Y, counter-clockwise seen from above. At 0
  /// its centre is at -Z. `file` is its path.
  Sky(SkyMap map, double turn_deg, std::string file);

  /// Returns the mean over the directions `direction` + a `right` + b `down`, with a and b uniform
  /// from -1/2 to 1/2 and a unit `direction`. Steps of 0 are a point. Exact for constant skies, and
  /// within a few thousandths for gradients. Patches with steps of up to 5 are resolved.
  [[nodiscard]] glm::vec3 radiance(glm::vec3 direction, glm::vec3 right = glm::vec3(0.0f),
                                   glm::vec3 down = glm::vec3(0.0f)) const;

  /// Returns the mean over the square of lobe_width(roughness) around a unit direction, one unit
  /// ahead. Its edges are any_perpendicular to the direction. Within a few hundredths: one look-up
  /// from SkyLobes::least_roughness on.
  [[nodiscard]] glm::vec3 around(glm::vec3 direction, float roughness) const;

  /// Returns the irradiance over pi of a surface with this unit normal, times sky_visibility.
  [[nodiscard]] glm::vec3 ambient(glm::vec3 normal) const;

  /// Samples a direction of a picture in proportion to its radiance, from a place in the unit
  /// square. bright_density() returns the density at a unit direction, per steradian. Only for
  /// pictures.
  [[nodiscard]] SkyDirection bright_direction(glm::dvec2 place) const;
  [[nodiscard]] double bright_density(glm::vec3 direction) const;

  /// Returns the sky with its picture or environment turned to this angle from its original
  /// position. Constant colours stay the same.
  [[nodiscard]] Sky turned(double turn_deg) const;
  /// Returns the sky with the original radiance of its picture or environment multiplied by
  /// `times`. Constant colours stay the same.
  [[nodiscard]] Sky brightened(double times) const;

  [[nodiscard]] bool constant() const { return !lobes_ && gradient_.constant() && sides_.none(); }
  [[nodiscard]] bool is_picture() const { return lobes_ != nullptr; }

  /// The lobes of a picture, for kernels: `around` and `ambient` are its values in the turned
  /// direction, times `brightness`. Null for other skies.
  struct PictureLobes {
    const SkyLobes* lobes = nullptr;
    float brightness = 1.0f;
    float turn_cos = 1.0f;
    float turn_sin = 0.0f;

    [[nodiscard]] glm::vec3 turned(glm::vec3 d) const {
      return {turn_cos * d.x - turn_sin * d.z, d.y, turn_sin * d.x + turn_cos * d.z};
    }
  };
  [[nodiscard]] PictureLobes picture_lobes() const {
    return {lobes_.get(), static_cast<float>(brightness_), static_cast<float>(turn_cos_),
            static_cast<float>(turn_sin_)};
  }

  /// Returns the sky's name on the command line, with turn and brightness: the environment,
  /// "R,G,B:R,G,B" or the file.
  [[nodiscard]] std::string name() const;
  /// Returns the choice from which it was made.
  [[nodiscard]] const SkyChoice& choice() const { return choice_; }

 private:
  struct Directions {
    glm::dvec3 middle, right, down;
  };
  void follow_environment();
  [[nodiscard]] glm::dvec3 mean_of_parts(const Directions& all, int across_right,
                                         int across_down) const;
  [[nodiscard]] const SkyMap& map() const;
  [[nodiscard]] glm::dvec3 in_map(glm::dvec3 direction) const;
  [[nodiscard]] glm::dvec3 part_mean(glm::dvec3 direction, glm::dvec3 right, glm::dvec3 down) const;

  Gradient gradient_;
  AzimuthVariation sides_;
  std::shared_ptr<const SkyMap> map_;  // of a file
  std::shared_ptr<const SkyLobes> lobes_;
  double brightness_ = 1.0;  // of the picture
  double turn_cos_ = 1.0;
  double turn_sin_ = 0.0;
  SkyChoice choice_;
};

/// Reads a sky from a file: .hdr (Radiance) or .exr, linear, twice as wide as high. Errors name the
/// file and one of these reasons: it is not readable, it has other proportions or more than 2^26
/// texels (.exr: 2^27), or it has negative, non-finite or too bright texels, which are counted.
[[nodiscard]] Result<std::shared_ptr<const Sky>> read_sky(const std::string& path,
                                                          double turn_deg = 0.0);

// Functions for shading. A null sky is the neutral one of environment.h.

/// Returns the background's radiance around a unit direction, averaged over a square of `side`
/// pixels if there is a `spacing`.
[[nodiscard]] glm::vec3 background(const Sky* sky, glm::vec3 direction, const PixelSpacing* spacing,
                                   float side);

/// Returns the sky's radiance that a surface reflects to the viewer: diffusely, and by its lobe
/// around the mirrored direction. Occlusion is only sky_visibility and mirrored_visibility; for
/// sampled occlusion see sky_light.h.
[[nodiscard]] glm::vec3 reflected_sky(const Sky* sky, const ViewedMaterial& seen, glm::vec3 normal,
                                      glm::vec3 to_viewer);

}  // namespace asos
