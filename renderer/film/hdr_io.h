#pragma once

#include "renderer/film/size_check.h"
#include "renderer/result.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace asos {

/// Linear radiance, rows from top to bottom.
struct HdrImage {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> radiance;
};

/// A Radiance picture (.hdr, .pic; RGBE, packed or not) whose rows run from top to bottom. `check`
/// is asked before anything of the picture's size is made. Errors name the file: what is none, has
/// another order of rows, ends too early, or has runs that do not fit their row.
[[nodiscard]] Result<HdrImage> read_hdr(const std::string& path, const SizeCheck& check = {});

}  // namespace asos
