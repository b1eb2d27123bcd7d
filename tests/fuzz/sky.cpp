#include "renderer/shading/sky.h"

#include "tests/fuzz/harness.h"

#include <glm/glm.hpp>

#include <cmath>

// Any .hdr or .exr is either rejected with an error, or a sky with finite radiance in all
// directions.

namespace asos::fuzz {

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const bool is_exr = size > 0 && data[0] == 0x76;
  const std::string path = input_file(is_exr ? "sky.exr" : "sky.hdr", data, size);
  const auto sky = read_sky(path, 30.0);
  if (!sky) {
    require(sky.error().subject == path && !sky.error().reason.empty(), "the error names the file");
    return 0;
  }
  for (const glm::vec3 direction : {glm::vec3(0, 1, 0), glm::vec3(0, -1, 0), glm::vec3(0, 0, -1),
                                    glm::normalize(glm::vec3(-1, 0.1, 1))}) {
    const glm::vec3 step = 0.01f * glm::vec3(direction.y, direction.z, direction.x);
    for (const glm::vec3& seen :
         {(*sky)->radiance(direction), (*sky)->radiance(direction, step, step),
          (*sky)->around(direction, 0.3f), (*sky)->ambient(direction)}) {
      for (int c = 0; c < 3; ++c)
        require(seen[c] >= 0.0f && std::isfinite(seen[c]), "radiance is finite and not negative");
    }
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most_bytes, unsigned int /*seed*/) {
  return LLVMFuzzerMutate(data, size, most_bytes);
}

}  // namespace asos::fuzz
