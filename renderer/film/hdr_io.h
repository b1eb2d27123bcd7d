#pragma once

#include "renderer/film/rgbe.h"
#include "renderer/film/size_check.h"
#include "renderer/result.h"

#include <string>
#include <vector>

namespace asos {

/// Rows from top to bottom, as they are in the file: a third of the memory of their radiance.
struct HdrImage {
  int width = 0;
  int height = 0;
  std::vector<Rgbe> pixels;
  glm::vec3 scale{1.0f};  ///< makes radiance of pixels: what EXPOSURE and COLORCORR say is undone
};

/// A Radiance picture (.hdr, .pic; RGBE, packed or not) whose rows run from top to bottom. `check`
/// is asked before anything of the picture's size is made. Errors name the file: what is none, has
/// another order of rows, ends too early, has runs that do not fit their row, or so many pixels in
/// so few bytes that their memory would be out of proportion; an EXPOSURE or COLORCORR that is
/// none.
[[nodiscard]] Result<HdrImage> read_hdr(const std::string& path, const SizeCheck& check = {});

}  // namespace asos
