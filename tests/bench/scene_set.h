#pragma once

#include "tests/bench/halved_reference.h"
#include "tests/bench/options.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace asos::bench {

/// The scenes of a benchmark, the size of their pictures, and their references.
struct SceneSet {
  PictureSize size;
  int samples = 0;                     ///< of a reference
  std::optional<std::string> cache{};  ///< folder of references; none: they are not kept
  bool sky_shadows = false;            ///< surfaces hide the sky from each other
  std::vector<std::string> names{};    ///< see chosen_scenes

  /// Adds --size, --cache and SCENE.
  void add_to(Options& options, const char* cached = "folder of references");

  /// Prefix of the cached files of a scene.
  [[nodiscard]] std::string path_of(const std::string& name) const;
  [[nodiscard]] Result<HalvedReference> reference_of(const std::string& name,
                                                     const Snapshot& snapshot) const;
  /// Opens a scene and takes its picture (snapshot_of).
  [[nodiscard]] Result<Snapshot> open(const std::string& source) const;
  /// Makes the cache, measures each scene, and reports errors. Returns the exit code.
  int measure(const std::function<Result<void>(const NamedScene&)>& measure_one) const;
};

/// A value of a scene.
struct SceneValue {
  double value = 0.0;
  std::string scene;
};

/// Prints the median of the values that are numbers, `then`, and the `count` scenes with the
/// largest values, or with the smallest.
void print_median(const std::string& what, std::vector<SceneValue> values, const std::string& then,
                  std::size_t count = 5, bool largest = true);

}  // namespace asos::bench
