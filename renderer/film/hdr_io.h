#pragma once

#include "renderer/film/rgbe.h"
#include "renderer/film/size_check.h"
#include "renderer/result.h"

#include <string>
#include <vector>

namespace asos {

/// The rows of a Radiance picture, from top to bottom, encoded as in the file: a third of the
/// memory of their radiance.
struct HdrImage {
  int width = 0;
  int height = 0;
  std::vector<Rgbe> pixels;
  glm::vec3 scale{1.0f};  ///< factor from pixels to radiance, which undoes EXPOSURE and COLORCORR
};

/// Reads a Radiance picture (.hdr, .pic; RGBE, compressed or not) whose rows run from top to
/// bottom. Calls `check` before it allocates the picture. Errors name the file: another format,
/// another order of rows, an early end, runs that do not fit their row, an invalid EXPOSURE or
/// COLORCORR, and more pixels than so few bytes can plausibly hold.
[[nodiscard]] Result<HdrImage> read_hdr(const std::string& path, const SizeCheck& check = {});

}  // namespace asos
