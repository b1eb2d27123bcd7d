#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace asos {

/// What is known of one place.
struct KnownValue {
  glm::dvec2 at{0.0};
  glm::dvec3 value{0.0};
  double variance = 1.0;  ///< of its noise, in each channel
};

/// How values run over a surface of a block: a polynomial of the place, of degree 2 where there are
/// values enough, else 1, by least squares of what noise leaves uncertain.
class Course {
 public:
  /// Values that tell a course: so many leave some over by which it is judged. None: they are too
  /// few, or lie along a line.
  static constexpr std::size_t fewest = 5, fewest_bent = 9;
  [[nodiscard]] static std::optional<Course> through(std::span<const KnownValue> values);

  [[nodiscard]] glm::dvec3 at(glm::dvec2 place) const;
  /// How far the values lie off it: the mean square by their noise, in the worst channel, for each
  /// of those left over. 1 is expected where noise is all that they are off by.
  [[nodiscard]] double misfit() const { return misfit_; }

 private:
  static constexpr std::size_t most_terms = 6;
  using Terms = std::array<double, most_terms>;
  [[nodiscard]] Terms terms_at(glm::dvec2 place) const;

  std::size_t count_ = 0;  // of its terms
  glm::dvec2 middle_{0.0};
  double scale_ = 1.0;
  std::array<glm::dvec3, most_terms> factors_{};
  double misfit_ = 0.0;
};

}  // namespace asos
