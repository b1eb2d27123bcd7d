#pragma once

#include "tests/bench/bench_support.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace asos::bench {

/// RMSE over pixels and channels of radiance clipped to 0..1.
struct KnownError {
  double rmse = 0.0;
  bool known = true;  ///< the squared error exceeds two standard deviations of its noise
};

/// Error of the picture's mean, over pixels and channels, of radiance clipped to 0..1.
struct Bias {
  double off = 0.0;
  double stray = 0.0;  ///< standard deviation due to the reference's noise
  double worst = 0.0;  ///< mean over the channels of the worst pixel
  std::size_t worst_pixel = 0;
};

/// A reference of two halves with independent noise: Sobol samples of two seeds that no other
/// benchmark uses. The squared error is the mean product of the errors against both halves; its
/// expectation does not contain the reference's noise.
class HalvedReference {
 public:
  /// `samples`: per pixel, of both halves together.
  static HalvedReference rendered(Snapshot snapshot, int samples);
  /// Reads the reference from `path` if it was written before; otherwise renders and writes it.
  static Result<HalvedReference> kept(const std::string& path, const Snapshot& snapshot,
                                      int samples);
  /// Reads a reference. Fails if a file is missing or has another size than `size`.
  static Result<HalvedReference> read(const std::string& path, PictureSize size);

  /// Writes the halves to PATH-1.exr and PATH-2.exr.
  [[nodiscard]] Result<void> write(const std::string& path) const;

  /// Returns the error; if it is uncertain, the smallest certain one.
  [[nodiscard]] KnownError error_of(const Film& film) const;
  /// Returns the expected squared error of each pixel, mean over the channels: below 0 where the
  /// reference's noise exceeds it.
  [[nodiscard]] std::vector<double> squared_errors(const Film& film) const;
  /// The 99th percentile over pixels (nearest rank) of the displayed error (sRGB, 0 to 1) against
  /// the mean of both halves: the root mean square over the channels.
  [[nodiscard]] double display_p99(const Film& film) const;
  [[nodiscard]] Bias bias_of(const Film& film) const;

 private:
  std::array<Film, 2> halves_;
};

}  // namespace asos::bench
