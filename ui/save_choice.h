#pragma once

#include <glm/glm.hpp>

#include <string>

namespace asos {

/// A person's choice of what to save, and how.
struct SaveChoice {
  enum class What {
    picture,    ///< rendered to the end, at any size, without anything over it
    seen,       ///< the picture's area of the window, with all that lies over it
    window,     ///< all of the window
    turntable,  ///< a whole turn, frame by frame
    clip,       ///< the animation, frame by frame
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
  std::string stem;    ///< the file's path without its ending; empty: the next that is free
  bool show = false;   ///< the dialog
  bool asked = false;  ///< the dialog was answered: to be saved now

  [[nodiscard]] bool as_exr() const { return exr && what == What::picture; }
  [[nodiscard]] bool is_movie() const { return what == What::turntable || what == What::clip; }
  /// The file, or the first of a movie's frames.
  [[nodiscard]] std::string path() const {
    if (is_movie()) return stem + (mp4 ? ".mp4" : "-0000.png");
    return stem + (as_exr() ? ".exr" : ".png");
  }
};

}  // namespace asos
