#pragma once

#include "renderer/film/film.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace asos {

/// The variation of a method's errors from picture to picture of an animation. A pixel's error e in
/// a frame is its clipped_difference from the frame's true picture, channel by channel. With the
/// mean m of e over the frames in each channel of each pixel,
///   flicker = sqrt(mean of (e - m)^2),  steady = sqrt(mean of m^2),  rmse = sqrt(mean of e^2)
/// over frames, pixels and channels, so that rmse^2 = flicker^2 + steady^2: a constant error does
/// not flicker.
///
/// The true picture is given by two halves of a reference with independent noise. Each square is
/// estimated by the product of the two errors against them, whose expectation is the square without
/// the reference's noise. Results below 0 count as 0.
class FlickerMeter {
 public:
  /// Adds the next frame. All films have the same size.
  void add(const Film& film, const Film& first_half, const Film& second_half);
  /// Adds a frame with a reference without noise.
  void add(const Film& film, const Film& reference) { add(film, reference, reference); }

  [[nodiscard]] int frames() const { return frames_; }
  [[nodiscard]] double rmse() const;
  [[nodiscard]] double flicker() const;
  [[nodiscard]] double steady() const;
  /// Returns the root mean square of the change of the error from each frame to the next; 0 for one
  /// frame. For errors as independent as new samples, it is sqrt(2) times their flicker.
  [[nodiscard]] double step() const;
  /// Returns the flicker of each pixel, over its channels.
  [[nodiscard]] std::vector<double> map() const;

 private:
  [[nodiscard]] double mean_scatter() const;
  [[nodiscard]] double mean_steady() const;

  struct Errors {  // against reference halves
    std::array<glm::dvec3, 2> of{glm::dvec3(0.0), glm::dvec3(0.0)};
  };
  int frames_ = 0;
  std::vector<Errors> means_, last_;  // a pixel each
  std::vector<glm::dvec3> scatter_;   // Welford's sums of products
  double step_sum_ = 0.0;
};

/// Returns the floor below which flicker is dominated by noise. `halves` compares the references'
/// halves with each other, so a pixel's variance over time is twice that of one half, v. A sum of n
/// products of the halves' noise over F frames has the standard deviation sqrt(sum of v^2 / 3F) /
/// n; the squared floor is twice that.
[[nodiscard]] double flicker_floor(const FlickerMeter& halves);

}  // namespace asos
