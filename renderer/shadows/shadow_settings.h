#pragma once

namespace asos {

/// How the shadow of a light of some size is found over the patch that a leaf shows (CGF'98
/// sections 4.2 to 4.3.4, whose names these are, but for the first).
enum class ShadowQuality {
  refined,            ///< one pyray from the leaf's sample; leaves are split where its shadow would
                      ///< be off the mean of the patch
  centre,             ///< one pyray from the leaf's sample (4.2)
  supersampling,      ///< pyrays from n x n jittered points of the patch (4.3.1)
  forced,             ///< from the middles of n x n parts of the patch (4.3)
  extended,           ///< one pyray from behind the surface, through as much of the patch as the
                      ///< light's projection covers (4.3.2)
  extended_divided,   ///< the same for each of n x n parts (4.3.3)
  extended_adaptive,  ///< parts until each lies inside the light's projection; then a pyray that
                      ///< holds the part, of which only what passes through it counts (4.3.4)
};

struct ShadowSettings {
  ShadowQuality quality = ShadowQuality::refined;
  int divisions = 2;  ///< n
  int max_level = 3;  ///< MAX of the parent pyray; shadow pyrays get what its levels leave
  double eps = 0.0;   ///< of the parent's root
  bool exact_leaves = true;
  /// Some surfaces of the scene have holes, or let more light through here than there.
  bool see_through = true;
  /// By how much a leaf may be off the mean of its patch before it is split: refined only.
  float most_uneven = 0.0f;
};

}  // namespace asos
