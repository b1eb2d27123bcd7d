#pragma once

namespace asos {

/// What exact answers cost, in shadow rays of a small packet: a part that deserves fewer rays takes
/// rays (Allowance::samples_suffice). Measured by tests/bench/prices.cpp; their quartiles over the
/// questions of nine scenes:
///  - a light cut exactly 3 to 34, half of them 4 to 20, a few some hundred: mean 8 to 46;
///  - a patch cut 20 to 150, half of them 25 to 70: mean 50 to 150;
///  - a search for what bounds a hard shadow 2 to 8, by the time of primitives and house;
///  - a search for a penumbra 0.2 to 1.8. But where it finds one the patch is split, and each part
///    is cut again, so that it is reckoned as a cut light (tests/bench/every_scene.cpp: at 5,
///    office takes a fifth longer at the same error).
///
/// And what leaves cost, in samples of a part of the same weight: a part that deserves fewer is
/// sampled and not split for its shading (Allowance::samples_suffice). By
/// tests/bench/every_scene.cpp, where both ways take boxes as long at an EPS of 1/1000, and most
/// scenes two thirds to a third as long by samples at 1/256; a glossy leaf sums up the BRDF over
/// each light, or traces what it mirrors. Soft shadows at 0: boxes and primitives a fifth better at
/// equal error, but scenes of many small parts before three panels take twice as long. Of cells
/// that boundaries cut into many parts, each of these counts as `part`, at 20 the errors of trees
/// and roofs in the sun grow by a tenth, and as its soft shadows.
struct Prices {
  static constexpr double light_window = 20.0;   ///< a light cut along what stands before it
  static constexpr double search = 4.0;          ///< for what bounds a patch's hard shadow
  static constexpr double penumbra_test = 20.0;  ///< a search for a shadow's edges on a patch
  static constexpr double patch = 60.0;          ///< a patch cut along the edges of a hard shadow
  static constexpr double exact_leaf = 16.0;     ///< a leaf that is shaded by its centre
  static constexpr double leaf = 3.0;            ///< a leaf of what is split for its shading
  static constexpr double glossy_leaf = 9.0;     ///< the same of what shows highlights or mirrors
  static constexpr double highlight = 0.3;       ///< of a leaf of one light's highlight
  static constexpr double soft_shadow = 8.0;     ///< of a leaf of one light's soft shadow
  static constexpr double part = 10.0;           ///< a part of a cell that is cut into many
};

}  // namespace asos
