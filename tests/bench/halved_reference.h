#pragma once

#include "tests/bench/bench_support.h"

#include <array>
#include <cstddef>
#include <string>

namespace asos::bench {

/// A root mean square error, over pixels and channels, of radiance clipped to 0..1.
struct KnownError {
  double rmse = 0.0;
  bool known =
      true;  ///< its square is more than twice what the reference's noise makes it stray by
};

/// What a picture's mean, over pixels and channels, of radiance clipped to 0..1 is off by.
struct Bias {
  double off = 0.0;
  double stray = 0.0;  ///< what the reference's noise makes that stray by: one standard deviation
  double worst = 0.0;  ///< of a pixel's mean over the channels
  std::size_t worst_pixel = 0;
};

/// A picture's truth from two halves whose noise is independent: Sobol samples of two seeds that no
/// other benchmark uses. A squared error is the mean product of the errors against both of them,
/// whose expectation has none of the reference's noise.
class HalvedReference {
 public:
  /// `samples`: of a pixel, in both halves together.
  static HalvedReference rendered(Snapshot snapshot, int samples);
  /// The same, read from `path` where it was written before, else rendered and written.
  static Result<HalvedReference> kept(const std::string& path, const Snapshot& snapshot,
                                      int samples);
  /// Reads what `write` wrote. Fails if a file is missing or of another size than `size`.
  static Result<HalvedReference> read(const std::string& path, PictureSize size);

  /// Writes the halves to PATH-1.exr and PATH-2.exr.
  [[nodiscard]] Result<void> write(const std::string& path) const;

  /// What is not known is the least that would have been.
  [[nodiscard]] KnownError error_of(const Film& film) const;
  /// The 99th percentile over pixels, by nearest rank, of the error of what is displayed (sRGB, 0
  /// to 1) against the mean of both halves: the root mean square over the channels.
  [[nodiscard]] double display_p99(const Film& film) const;
  [[nodiscard]] Bias bias_of(const Film& film) const;

 private:
  std::array<Film, 2> halves_;
};

/// In a folder of what benchmarks keep: what the names of all files begin with that are of a
/// scene's pictures of a size, by references of so many samples.
[[nodiscard]] std::string kept_path(const std::string& folder, const std::string& scene,
                                    PictureSize size, int samples, bool sky_shadows);

}  // namespace asos::bench
