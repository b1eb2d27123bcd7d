#include "renderer/scene/rig.h"
#include "tests/fuzz/gltf_mutator.h"
#include "tests/fuzz/harness.h"
#include "tests/support/loaded_scene.h"

#include <string_view>

// Any file is a scene that keeps the promises of scene.h, at rest and at times, or is refused in
// words.

namespace asos::fuzz {

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string path = input_file("scene.glb", data, size);
  const Result<Scene> scene = load_scene(path, {.keep_rig = true});
  std::string broken = test::broken_promise_of(scene, path);
  if (broken.empty() && scene && scene->rig)
    broken = test::broken_promise_of(scene->rig->pose(ClipTime{0, 0.5}), path);
  require(broken.empty(), broken);
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most_bytes, unsigned int seed) {
  const std::string_view file(reinterpret_cast<const char*>(data), size);
  return mutated(seed % 8 == 0 ? "" : mutated_gltf(file, seed), data, size, most_bytes);
}

}  // namespace asos::fuzz
