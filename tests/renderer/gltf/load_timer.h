#pragma once

#include "renderer/gltf/load.h"
#include "tests/renderer/gltf/gltf_builder.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <ctime>
#include <string>

namespace asos::test {

/// Time limit to load or reject any file, in every kind of build.
inline constexpr double longest_load_seconds = 5.0;

/// Loads a file and expects it to stay within that limit of CPU time of all threads. This is at
/// least the wall-clock time of an idle machine, and independent of other load. A load that blocks
/// runs into the test's own time limit.
inline Result<Scene> load_in_time(const std::string& path, const LoadOptions& options = {}) {
  const std::clock_t start = std::clock();
  Result<Scene> scene = load_scene(path, options);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_LT(seconds, longest_load_seconds) << path;
  return scene;
}

/// Loads a built file, written as test.glb, with the same expectation.
inline Result<Scene> load_in_time(const GltfBuilder& builder) {
  const TemporaryFolder folder;
  return load_in_time(folder.write("test.glb", builder.glb()));
}

}  // namespace asos::test
