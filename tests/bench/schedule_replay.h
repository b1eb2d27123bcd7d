#pragma once

#include "renderer/study/curves.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace asos::bench {

/// The measured times and errors of a picture's parts. Arrays have a value per pixel, row by row.
/// Squared errors are means over the channels, against a reference.
struct MeasuredPicture {
  /// The picture after so many samples per pixel.
  struct Round {
    int samples = 0;
    std::vector<double> squared_error;
    std::vector<double> changed;  ///< squared change since the round before; empty for the first
  };
  int width = 0, height = 0;
  std::vector<Round> rounds;                ///< each has four times the samples of the one before
  double seconds = 0.0;                     ///< of the second round: the schedules begin with it
  std::vector<double> sample_seconds;       ///< of a single sample
  std::vector<double> exact_squared_error;  ///< of the method's final picture
  std::vector<double> exact_seconds;        ///< of the pixel as a part of its 8x8 block
};

/// An order of work after the second round of samples. Work with the largest expected reduction of
/// the squared error per second comes first. The expected squared error of a pixel is a sixth of
/// its change, 0.6 times the maximum over 3x3 pixels plus 0.4 times its own.
struct Schedule {
  enum class Exact { none, blocks, pixels };
  bool samples = true;          ///< pixels go from n to 4n samples
  Exact exact = Exact::blocks;  ///< the unit of the method's own work
  /// Blocks are ordered by their true times. Otherwise by those that StepQueue would expect, with
  /// the right sum over the picture.
  bool times_known = true;
  /// Samples of a block's pixels take at most this fraction of the block's time.
  double most_samples = std::numeric_limits<double>::infinity();
  // With Exact::pixels, a block is visited several times, each for some of its pixels.
  double search = 0.0;  ///< fraction of the block's time that each visit repeats
  double dearer = 1.0;  ///< time of a pixel relative to `exact_seconds`
  int visits = 3;       ///< maximum for a block; the last takes all pixels that remain
};

/// Replays a schedule. Returns the RMSE over time, from the second round to the end.
[[nodiscard]] std::vector<CurvePoint> replayed(const MeasuredPicture& picture,
                                               const Schedule& schedule);

/// Returns the error at a moment, with a squared error that is linear between two points.
[[nodiscard]] double replayed_error_at(const std::vector<CurvePoint>& curve, double seconds);

}  // namespace asos::bench
