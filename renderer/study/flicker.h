#pragma once

#include "renderer/film/film.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace asos {

/// How the errors of a method vary from picture to picture of an animation. A pixel's error in a
/// frame is its clipped_difference from the frame's true picture, channel by channel. With e of F
/// frames and their mean m in each channel of each pixel,
///   flicker = sqrt(mean of (e - m)^2),  steady = sqrt(mean of m^2),  rmse = sqrt(mean of e^2)
/// over frames, pixels and channels, so that rmse^2 = flicker^2 + steady^2: an error that stays
/// where it is does not flicker.
///
/// The true picture is known by two halves of a reference whose noise is independent. Each square
/// is estimated by the product of the two errors against them, whose expectation is the square
/// without the reference's noise. What comes out below 0 counts as 0.
class FlickerMeter {
 public:
  /// Adds the next frame. All films are of one size.
  void add(const Film& film, const Film& first_half, const Film& second_half);
  /// Against a picture that is taken to be true.
  void add(const Film& film, const Film& reference) { add(film, reference, reference); }

  [[nodiscard]] int frames() const { return frames_; }
  [[nodiscard]] double rmse() const;
  [[nodiscard]] double flicker() const;
  [[nodiscard]] double steady() const;
  /// The root mean square of how the error changes from each frame to the next; 0 for one frame.
  /// Errors that are as independent as samples drawn anew change by sqrt(2) times their flicker.
  [[nodiscard]] double step() const;
  /// The flicker of each pixel, over its channels.
  [[nodiscard]] std::vector<double> map() const;

 private:
  [[nodiscard]] double mean_scatter() const;
  [[nodiscard]] double mean_steady() const;

  struct Errors {  // against both halves
    std::array<glm::dvec3, 2> of{glm::dvec3(0.0), glm::dvec3(0.0)};
  };
  int frames_ = 0;
  std::vector<Errors> means_, last_;  // a pixel each
  std::vector<glm::dvec3> scatter_;   // Welford's sums of products
  double step_sum_ = 0.0;
};

/// Flicker below this is hardly known. `halves`: those of the references, one against the other, so
/// that a pixel's variance over time is twice that of one half, v. A sum of n products of the
/// halves' noise over F frames strays by sqrt(sum of v^2 / 3F) / n; the floor squared is twice
/// that.
[[nodiscard]] double flicker_floor(const FlickerMeter& halves);

}  // namespace asos
