#include "renderer/scene/posable_scene.h"
#include "tests/fuzz/gltf_mutator.h"
#include "tests/fuzz/harness.h"
#include "tests/support/loaded_scene.h"

#include <string>
#include <string_view>

// Any file is either rejected with an error, or a scene that keeps the guarantees of scene.h: at
// rest, at times of its animations, with a material variant, and for another of its scenes.

namespace asos::fuzz {
namespace {

/// Checks the file's other scenes and its variants.
std::string broken_promise_of_choices(const SceneContents& contents, const std::string& path) {
  std::string broken;
  if (!contents.variants.empty())
    broken = test::broken_promise_of(load_scene(path, {.variant = contents.variants.back()}), path);
  if (broken.empty() && contents.scenes.size() > 1)
    broken = test::broken_promise_of(
        load_scene(path, {.scene = std::to_string(contents.scenes.size() - 1)}), path);
  return broken;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string path = input_file("scene.glb", data, size);
  const Result<Scene> scene = load_scene(path, {.keep_posable = true});
  std::string broken = test::broken_promise_of(scene, path);
  if (broken.empty() && scene && scene->rig)
    broken = test::broken_promise_of(scene->rig->pose(ClipTime{0, 0.5}), path);
  if (broken.empty() && scene) broken = broken_promise_of_choices(scene->contents, path);
  require(broken.empty(), broken);
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most_bytes, unsigned int seed) {
  const std::string_view file(reinterpret_cast<const char*>(data), size);
  return mutated(seed % 8 == 0 ? "" : mutated_gltf(file, seed), data, size, most_bytes);
}

}  // namespace asos::fuzz
