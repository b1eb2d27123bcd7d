#pragma once

#include <glm/glm.hpp>

#include <string>

namespace asos {

/// A person's choice of what to save, and how.
struct SaveChoice {
  enum class What {
    picture,  ///< rendered to the end, at any size, without anything over it
    seen,     ///< the picture's area of the window, with all that lies over it
    window,   ///< all of the window
  };
  static constexpr int largest_side = 32768;

  What what = What::picture;
  bool exr = false;    ///< linear radiance; of `picture` only
  glm::ivec2 size{0};  ///< of `picture`, in pixels; 0: as it is shown
  std::string stem;    ///< the file's path without its ending; empty: the next that is free
  bool show = false;   ///< the dialog
  bool asked = false;  ///< the dialog was answered: to be saved now

  [[nodiscard]] bool as_exr() const { return exr && what == What::picture; }
  [[nodiscard]] std::string path() const { return stem + (as_exr() ? ".exr" : ".png"); }
};

}  // namespace asos
