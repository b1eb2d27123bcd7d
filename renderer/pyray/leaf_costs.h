#pragma once

namespace asos {

/// Measured costs of the ways to determine a leaf, each with the benchmark that sets it. Samples or
/// rays replace an estimator that costs as much (choose).
///
/// - light_pyramid: quartiles 4 and 20 rays, mean 8 to 46 over nine scenes (bench prices)
/// - patch: quartiles 25 and 70 rays, mean 50 to 150 (bench prices)
/// - search: 2 to 8 rays, from the time of primitives and house (bench every-scene)
/// - penumbra_test: 0.2 to 1.8 rays; at 5, office takes a fifth longer (bench every-scene)
/// - exact_leaf: MAX 1 takes as long as 16 Sobol samples (bench every-scene)
/// - leaf: at 8, the same errors and times (bench every-scene)
/// - soft_shadow: at 0, leaves before three panels take twice as long (bench every-scene)
/// - part: at 20, trees and roofs have a tenth more error (bench every-scene)
struct LeafCosts {
  // In shadow rays of a small packet.
  static constexpr double light_pyramid = 20.0;  ///< a light cut along its occluders
  static constexpr double search = 4.0;          ///< the boundaries of a patch's hard shadow
  static constexpr double penumbra_test = 20.0;  ///< the edges of a soft shadow on a patch
  static constexpr double patch = 60.0;          ///< a patch cut along the edges of a hard shadow
  // In samples of a part of the same weight.
  static constexpr double exact_leaf = 16.0;  ///< a leaf's centre with exact shadows
  static constexpr double leaf = 3.0;         ///< one of the leaves of a part that is split
  static constexpr double soft_shadow = 8.0;  ///< one light's soft shadow on a leaf
  static constexpr double part = 10.0;        ///< one of the parts of a cell that is cut into many
};

}  // namespace asos
