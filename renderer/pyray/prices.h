#pragma once

namespace asos {

/// What exact answers cost, in shadow rays of a small packet: a part that deserves fewer rays takes
/// rays (Budget::rays_suffice). Measured by tests/bench/prices.cpp; their quartiles over the
/// questions of nine scenes:
///  - a light cut exactly 3 to 34, half of them 4 to 20, a few some hundred: mean 8 to 46;
///  - a patch cut 20 to 150, half of them 25 to 70: mean 50 to 150;
///  - a search for a penumbra 0.2 to 1.8. But where it finds one the patch is split, and each part
///    is cut again, so that it is reckoned as a cut light (tests/bench/every_scene.cpp: at 5,
///    office takes a fifth longer at the same error).
struct Prices {
  static constexpr double light_window = 20.0;   ///< a light cut along what stands before it
  static constexpr double penumbra_test = 20.0;  ///< a search for a shadow's edges on a patch
  static constexpr double patch = 60.0;          ///< a patch cut along the edges of a hard shadow
};

}  // namespace asos
