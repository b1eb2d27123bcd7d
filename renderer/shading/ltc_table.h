#pragma once

#include <array>
#include <cstddef>

namespace asos {

/// Fitted linearly transformed cosines (Heitz, Dupuy, Hill and Neubelt 2016) of the GGX lobe times
/// the cosine, by the angle to the viewer and the roughness: of the lobe alone, and of the lobe
/// times Schlick's (1 - v.h)^5. See Ltc for what the numbers mean.
///
/// `error`, over all roughnesses, on average and at most: of the lobe 0.02 and 0.06 for n.v from
/// 0.5, 0.05 and 0.10 from 0.34, 0.08 and 0.16 from 0.17, 0.13 and 0.24 from 0.05, 0.19 and 0.37
/// below, where a lobe bends as no transformed cosine does; of all that a dielectric mirrors
/// Schlick's part adds as much at grazing angles and less than 0.005 from n.v 0.5 on. A light of a
/// usual shape is less off than the worst one: the tests' lights in all places by 0.2 % of their
/// mean up to 40 degrees of view, 0.5 % at 60, 0.8 % at 70, 1.4 % at 80; a single one by at most 4,
/// 13, 19 and 24 % of that mean. The broad lobes of roughness 0.45 to 0.6 at 80 degrees are the
/// worst: 7 % on average, 62 % for a small light in the mirrored direction.
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
