#pragma once

#include <array>
#include <cstddef>

namespace asos {

/// Fitted linearly transformed cosines (Heitz, Dupuy, Hill and Neubelt 2016) of the GGX lobe times
/// the cosine, by the angle to the viewer and the roughness: of the lobe alone, and of the lobe
/// times Schlick's (1 - v.h)^5. See Ltc for what the numbers mean.
struct LtcEntry {
  float tilt;     ///< from the mirrored direction to the lobe's axis, away from the normal, over
                  ///< alpha
  float width;    ///< alpha over the lobe's half width in the plane of view
  float stretch;  ///< its width across that plane over the width in it
  float lean;     ///< of the cosine's own axis against the lobe's: its slope times n.v
  float norm;     ///< the integral of what was fitted over all directions; of the lobe with Fresnel
                  ///< its fifth root, which is nearly linear in n.v
  float error;    ///< of any light that is equally bright all over: at most this share of the norm
};

inline constexpr std::size_t ltc_cosines = 32;
inline constexpr std::size_t ltc_roughnesses = 32;
/// The grazing_cosine of shading.
inline constexpr double ltc_least_cosine = 1.0 / 512.0;
/// Roughness by roughness, from roughness_floor to 1 in equal steps; in each n.v from the least to
/// 1, growing as t * t * (3 - 2 t) by equal steps of t: the lobe changes fast near to both ends.
using LtcTable = std::array<LtcEntry, ltc_cosines * ltc_roughnesses>;

extern const LtcTable ltc_of_lobe;
extern const LtcTable ltc_of_fresnel;

}  // namespace asos
