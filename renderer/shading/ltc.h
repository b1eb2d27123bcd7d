#pragma once

#include "renderer/lights/clipped_form.h"
#include "renderer/lights/receiver.h"

#include <glm/glm.hpp>

namespace asos {

/// A lobe times the cosine as a linearly transformed cosine (Heitz, Dupuy, Hill and Neubelt 2016):
/// its value towards p is weight times that of the clamped cosine towards to_cosine p, by solid
/// angle there; so that its integral over a light is weight times the form of the transformed light
/// above the transformed horizons.
struct Ltc {
  glm::dmat3 to_cosine{1.0};
  Horizons horizons;
  double weight = 0.0;
};

/// The two parts of brdf.h's GGX lobe, as a viewer sees it: a surface sends f0 times the first and
/// f90 - f0 times the second on.
struct LtcPair {
  Ltc lobe;
  Ltc fresnel;  ///< the lobe times Schlick's (1 - v.h)^5
};

/// Of ltc_table. `to_viewer` is unit; at or below the horizon it counts as at grazing_cosine. Above
/// both horizons of the receiver. The integral over all of the normal's hemisphere is the lobe's
/// own.
[[nodiscard]] LtcPair ltc_of(const Receiver& receiver, glm::dvec3 to_viewer, double roughness);

/// How far off the fit is: no light that is equally bright all over, whatever its shape, gives an
/// integral that differs by more than this share of the one over all directions. Interpolating the
/// table may add a hundredth, and at n.v below 0.02 up to 0.055. Where it is large, sampling is
/// better.
struct LtcError {
  double lobe = 0.0;
  double fresnel = 0.0;
};
[[nodiscard]] LtcError ltc_error(double n_dot_v, double roughness);

/// The lobe's integrals over all directions, as fitted.
struct LtcNorms {
  double lobe = 0.0;
  double fresnel = 0.0;
};
[[nodiscard]] LtcNorms ltc_norms(double n_dot_v, double roughness);

}  // namespace asos
