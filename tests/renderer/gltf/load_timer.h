#pragma once

#include "renderer/gltf/load.h"
#include "tests/renderer/gltf/gltf_builder.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <ctime>
#include <string>

namespace asos::test {

/// No file may take longer to load or to be refused, whatever is in it, in any build.
inline constexpr double longest_load_seconds = 5.0;

/// Loads a file and expects it to stay within that time. Processor time is what is measured: that
/// of all threads, so no less than an idle machine's clock would show, and independent of what else
/// the machine does. A load that waits instead of working runs into the test's own time limit.
inline Result<Scene> load_in_time(const std::string& path, const LoadOptions& options = {}) {
  const std::clock_t start = std::clock();
  Result<Scene> scene = load_scene(path, options);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_LT(seconds, longest_load_seconds) << path;
  return scene;
}

/// The same for a file that holds what was built, named test.glb.
inline Result<Scene> load_in_time(const GltfBuilder& builder) {
  const TemporaryFolder folder;
  return load_in_time(folder.write("test.glb", builder.glb()));
}

}  // namespace asos::test
