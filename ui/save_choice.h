#pragma once

#include <glm/glm.hpp>

#include <string>

namespace asos::ui {

/// The user's choice of content, format and path to save.
struct SaveChoice {
  enum class What {
    picture,    ///< rendered to the end at any size, without overlays
    seen,       ///< the picture's area of the window, with all overlays
    window,     ///< all of the window
    turntable,  ///< a full turn, frame by frame
    clip,       ///< an animation, frame by frame
  };
  static constexpr int largest_side = 32768;
  static constexpr int most_frames = 9999;

  What what = What::picture;
  enum class Layers { none, shown, all };
  Layers layers = Layers::none;  ///< in an EXR
  bool exr = false;              ///< linear radiance; of `picture` only
  bool mp4 = false;              ///< of a movie, else PNGs
  int frames = 120;              ///< of a turn
  double fps = 24.0;             ///< of a movie
  glm::ivec2 size{0};            ///< of `picture`, in pixels; 0: as it is shown
  std::string stem;              ///< path without the extension; empty: the next free one
  bool show = false;             ///< the dialog
  bool asked = false;            ///< the dialog was confirmed: save now

  [[nodiscard]] bool as_exr() const { return exr && what == What::picture; }
  [[nodiscard]] bool is_movie() const { return what == What::turntable || what == What::clip; }
  /// Path of the file, or of a movie's first frame.
  [[nodiscard]] std::string path() const {
    if (is_movie()) return stem + (mp4 ? ".mp4" : "-0000.png");
    return stem + (as_exr() ? ".exr" : ".png");
  }
};

}  // namespace asos::ui
