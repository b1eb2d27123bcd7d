#include "tests/fuzz/gltf_mutator.h"
#include "tests/fuzz/harness.h"
#include "tests/support/loaded_scene.h"

#include <string_view>

// Any file is a scene that keeps the promises of scene.h, or is refused in words.

namespace asos::fuzz {

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string path = input_file("scene.glb", data, size);
  const std::string broken = test::broken_promise_of(load_scene(path), path);
  require(broken.empty(), broken);
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most_bytes, unsigned int seed) {
  const std::string_view file(reinterpret_cast<const char*>(data), size);
  return mutated(seed % 8 == 0 ? "" : mutated_gltf(file, seed), data, size, most_bytes);
}

}  // namespace asos::fuzz
