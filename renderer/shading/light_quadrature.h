#pragma once

#include "renderer/lights/light_patches.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/lights/receiver.h"
#include "renderer/shading/lobe.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace asos {

/// What a surface makes of a light with nothing in the way, per power of the PreparedLight: the
/// specular part's radiance is f0 * lobe + (f90 - f0) * fresnel; what the diffuse part sends on is
/// the irradiance less its falloff times `scattered`, each over pi.
struct ReflectedIntegral {
  double lobe = 0.0;
  double fresnel = 0.0;
  double scattered = 0.0;  ///< the irradiance times Schlick's (1 - v.h)^5
};

/// How much of the light a surface's lobe returns that is seen square on.
enum class Reflectance {
  high,  ///< a metal's
  low,   ///< a dielectric's, a tenth at most: its lobe's sum may be as much less exact
};

/// Sums of the BRDF itself over lights that have a size, by the physical rule, above both of a
/// receiver's horizons. A light is divided until its parts are small beside their angle to the
/// mirrored view, or beside the lobe there, and is summed up there at Gauss and Legendre's nodes:
/// up to 75 degrees of view within 0.02 % on average over lights in all places, 0.2 % for a
/// dielectric. At 85 degrees lobes of roughness 0.1, bent and cut by the horizon, are off by up to
/// 2 % on average.
class LightQuadrature {
 public:
  /// `to_viewer` is unit; at or below the horizon it counts as at grazing_cosine.
  /// `sheen` is ViewedMaterial's, `stretch` its LobeStretch's `along`.
  LightQuadrature(const Receiver& receiver, glm::dvec3 to_viewer, double roughness,
                  double sheen = 0.0, glm::vec3 stretch = glm::vec3(0.0f),
                  Reflectance reflectance = Reflectance::high);

  /// 0 for a light that has no size.
  [[nodiscard]] ReflectedIntegral operator()(const PreparedLight& light);

  /// The cells that the light was summed up over, last.
  [[nodiscard]] int cells() const { return cells_; }

 private:
  struct Sums {
    float lobe = 0.0f, fresnel = 0.0f, scattered = 0.0f;
  };
  using Corners = std::array<glm::vec3, 4>;  ///< u from 0 to 1, and again at the larger v
  void add_patch(const LightPatch& patch);
  void add_square(const LightPatch& patch, const LightPatch::Square& square, const Corners& corners,
                  int depth);
  /// Where patches_ are the quarters of a round light that is small beside the lobe.
  bool add_as_one_cell();
  void add_cell(const LightPatch::Cell& cell);
  void add_segment(const PreparedLight& light);
  /// How far a cell may reach whose middle this is.
  [[nodiscard]] float widest_at(glm::vec3 middle) const;
  /// How far a direction is from where the lobe is brightest: a point, or a ridge.
  [[nodiscard]] float way_to_peak(glm::vec3 direction) const;

  Receiver receiver_;
  glm::vec3 normal_, geometric_, to_viewer_, mirrored_;
  float n_dot_v_;
  float alpha2_;
  float viewer_root_;  // of Smith's term
  float widest_;       // cells may span
  float share_of_way_;
  float narrowest_;  // the lobe's width
  float sheen_;
  PatchLobe stretched_;           // where it is wider()
  glm::vec3 across_ridge_{0.0f};  // unit, square to the stretch; 0: round
  int cells_ = 0;
  Sums sums_;
  std::vector<LightPatch> patches_;
};

}  // namespace asos
