#pragma once

#include "renderer/study/ladders.h"
#include "renderer/study/plan.h"

#include <array>

namespace asos {

/// A row of CGF'98 table 2 (section 7.5), or an image of its section 7.4: its settings and times
/// there, and the scene that represents it here.
struct PaperCase {
  const char* figure;
  const char* image;
  const char* settings;  ///< as in sections 7.1 to 7.4
  const char* quality;   ///< of ASOS's picture, in the authors' words; empty: none in table 2
  double asos_minutes;
  double rival_minutes = 0.0;  ///< stochastic sampling; 0: none published
  /// Samples of the stochastic picture that was called comparable; 0: none.
  int rival_spp = 0;
  const char* source;  ///< the built-in scene: similar in kind to the paper's
  int max_level;
  double eps;
  int texture_resolution = 1;
  int bounces = 0;             ///< 0: the program's default
  double blur_exponent = 0.0;  ///< N, with DFRMIN 0.05 and DFRMAX 1; 0: the materials' own
};

/// In the paper's order. Times: table 2; for figures 20 and 21 section 7.4. Settings and samples:
/// section 7.1 (office), 7.2 (textures), 7.3 (reflections), 7.4 (secondary reflections).
inline constexpr std::array paper_cases{
    PaperCase{.figure = "10",
              .image = "Office",
              .settings = "MAX 2, EPS 1/8",
              .quality = "poor",
              .asos_minutes = 23.65,
              .rival_minutes = 73.70,
              .rival_spp = 16,
              .source = "builtin:office",
              .max_level = 2,
              .eps = 0.125},
    PaperCase{.figure = "11",
              .image = "Office",
              .settings = "MAX 3, EPS 1/8",
              .quality = "good",
              .asos_minutes = 27.71,
              .rival_minutes = 383.10,
              .rival_spp = 64,
              .source = "builtin:office",
              .max_level = 3,
              .eps = 0.125},
    PaperCase{.figure = "12",
              .image = "Office",
              .settings = "MAX 4, EPS 1/8",
              .quality = "very good",
              .asos_minutes = 35.98,
              .source = "builtin:office",
              .max_level = 4,
              .eps = 0.125},
    PaperCase{.figure = "14",
              .image = "House with textures",
              .settings = "MAX 2, EPS 0, TR 2",
              .quality = "good",
              .asos_minutes = 158.01,
              .source = "builtin:house-textured",
              .max_level = 2,
              .eps = 0.0,
              .texture_resolution = 2},
    PaperCase{.figure = "15",
              .image = "House with textures",
              .settings = "MAX 2, EPS 0, TR 4",
              .quality = "very good",
              .asos_minutes = 353.55,
              .rival_minutes = 539.42,
              .rival_spp = 16,
              .source = "builtin:house-textured",
              .max_level = 2,
              .eps = 0.0,
              .texture_resolution = 4},
    PaperCase{.figure = "16",
              .image = "Reflected house",
              .settings = "MAX 2, EPS 1/8",
              .quality = "good",
              .asos_minutes = 49.19,
              .rival_minutes = 308.26,
              .rival_spp = 16,
              .source = "builtin:house-mirror",
              .max_level = 2,
              .eps = 0.125},
    PaperCase{.figure = "17",
              .image = "Reflected house",
              .settings = "MAX 3, EPS 1/8",
              .quality = "very good",
              .asos_minutes = 92.25,
              .source = "builtin:house-mirror",
              .max_level = 3,
              .eps = 0.125},
    PaperCase{.figure = "18",
              .image = "House, blurred reflection",
              .settings = "MAX 3, EPS 1/8, DFR 0.05 to 1, N 32",
              .quality = "very good",
              .asos_minutes = 182.83,
              .source = "builtin:house-mirror",
              .max_level = 3,
              .eps = 0.125,
              .blur_exponent = 32.0},
    PaperCase{.figure = "19",
              .image = "House, blurred reflection",
              .settings = "MAX 3, EPS 1/8, DFR 0.05 to 1, N 64",
              .quality = "very good",
              .asos_minutes = 225.90,
              .source = "builtin:house-mirror",
              .max_level = 3,
              .eps = 0.125,
              .blur_exponent = 64.0},
    PaperCase{.figure = "20",
              .image = "Office, metallic desk",
              .settings = "MAX 3, EPS 1/8, two bounces",
              .quality = "",
              .asos_minutes = 28.74,
              .source = "builtin:office-metal",
              .max_level = 3,
              .eps = 0.125,
              .bounces = 2},
    PaperCase{.figure = "21",
              .image = "Sphere, cylinder and cone",
              .settings = "MAX 3, EPS 1/8, 6 bounces",
              .quality = "",
              .asos_minutes = 2.48,
              .source = "builtin:solids",
              .max_level = 3,
              .eps = 0.125,
              .bounces = 6},
};

/// Returns the scene and look for a case's reference. asos_rung() returns the case's setting of an
/// ASOS method.
[[nodiscard]] StudyScene scene_of(const PaperCase& row);
[[nodiscard]] LadderStep asos_rung(const PaperCase& row, const std::string& method,
                                   const RenderSettings& base);

}  // namespace asos
