#pragma once

#include <array>

namespace asos {

/// A row of CGF'98 table 2, or an image of its section 7.4: what was rendered, how long it took
/// there, and what it is measured on here.
struct PaperCase {
  const char* figure;
  const char* image;
  const char* settings;
  double asos_minutes;
  double rival_minutes;  ///< stochastic sampling; 0: none published
  int rival_spp;         ///< of the stochastic picture that was called comparable; 0: none
  const char* scene;     ///< the built-in scene; empty where the program cannot render the case
  int max_level;
  double eps;
  const char* missing;  ///< what the program lacks for it
};

/// In the paper's order. House is the paper's scene in kind only, and so is office.
inline constexpr std::array paper_cases{
    PaperCase{"10", "Office", "MAX 2, EPS 1/8", 23.65, 73.70, 16, "builtin:office", 2, 0.125, ""},
    PaperCase{"11", "Office", "MAX 3, EPS 1/8", 27.71, 383.10, 64, "builtin:office", 3, 0.125, ""},
    PaperCase{"12", "Office", "MAX 4, EPS 1/8", 35.98, 0.0, 0, "builtin:office", 4, 0.125, ""},
    PaperCase{"14", "House with textures", "MAX 2, EPS 0, TR 2", 158.01, 0.0, 0, "", 2, 0.0,
              "texture resampling TR"},
    PaperCase{"15", "House with textures", "MAX 2, EPS 0, TR 4", 353.55, 539.42, 16, "", 2, 0.0,
              "texture resampling TR"},
    PaperCase{"16", "Reflected house", "MAX 2, EPS 1/8", 49.19, 308.26, 16, "", 2, 0.125,
              "reflections"},
    PaperCase{"17", "Reflected house", "MAX 3, EPS 1/8", 92.25, 0.0, 0, "", 3, 0.125,
              "reflections"},
    PaperCase{"18", "House, blurred reflection, N 32", "MAX 3, EPS 1/8", 182.83, 0.0, 0, "", 3,
              0.125, "blurred reflections"},
    PaperCase{"19", "House, blurred reflection, N 64", "MAX 3, EPS 1/8", 225.90, 0.0, 0, "", 3,
              0.125, "blurred reflections"},
    PaperCase{"20", "Office, metallic desk", "MAX 3, EPS 1/8", 28.74, 0.0, 0, "", 3, 0.125,
              "blurred reflections, two bounces"},
    PaperCase{"21", "Sphere, cylinder and cone", "MAX 3, EPS 1/8, 6 bounces", 2.48, 0.0, 0, "", 3,
              0.125, "reflections, six bounces"},
};

/// The house as this program has it, without TR: measured, with no published figure beside it.
inline constexpr const char* plain_house = "builtin:house";

}  // namespace asos
