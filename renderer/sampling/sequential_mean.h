#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace asos {

/// The stopping rule of a mean that is sampled in rounds. Each round doubles the number of samples.
struct SamplingGoal {
  double standard_error = 0.0;  ///< allowed error; negative: take `most`
  std::uint32_t least = 16;     ///< samples of the first round, at most `most`
  std::uint32_t most = 16;
  /// Whether the allowed error grows with the root of the number of samples, if `least` do not meet
  /// it. One more sample then reduces a picture's squared error by the same amount in every pixel
  /// (Neyman 1934).
  bool grows = true;

  [[nodiscard]] double allowed_error(std::uint32_t taken) const {
    const double times = static_cast<double>(taken) / static_cast<double>(std::max(1u, least));
    return (grows ? std::sqrt(times) : 1.0) * standard_error;
  }
  /// Returns the total number of samples after the next round.
  [[nodiscard]] std::uint32_t after_next_round(std::uint32_t taken) const {
    return taken == 0 ? least : 2 * taken;
  }
  [[nodiscard]] bool exhausted(std::uint32_t taken) const { return after_next_round(taken) > most; }
  [[nodiscard]] bool met(std::uint32_t taken, double error) const {
    return exhausted(taken) || error <= allowed_error(taken);
  }
};

/// The weighted mean of a sequence of samples, each well distributed among those before it, and its
/// standard error. The error is estimated from the variance of parts of the sequence, in order,
/// since each part is as well distributed as its size allows. SamplingGoal is the stopping rule.
class SequentialMean {
 public:
  struct Sum {
    glm::dvec3 value{0.0};  ///< times weight
    double weight = 0.0;

    Sum& operator+=(const Sum& other) {
      value += other.value;
      weight += other.weight;
      return *this;
    }
    [[nodiscard]] glm::dvec3 mean() const {
      return weight > 0.0 ? value / weight : glm::dvec3(0.0);
    }
  };

  void clear() { *this = {}; }
  void add(glm::dvec3 value, double weight = 1.0) {
    if (in_last_ == per_sum_) start_sum();
    sums_[used_ - 1] += {weight * value, weight};
    ++in_last_;
    ++count_;
  }

  [[nodiscard]] std::uint32_t count() const { return count_; }
  [[nodiscard]] glm::dvec3 mean() const { return all().mean(); }
  [[nodiscard]] double weight() const { return all().weight; }
  /// Returns the error in the worst channel; infinite before two parts have a weight.
  [[nodiscard]] double standard_error() const {
    return standard_error_of(std::span(sums_).first(used_), mean(), [](glm::dvec3 off) {
      return std::max({off.x, off.y, off.z});
    });
  }

  /// Returns the standard error of the mean of consecutive sums, from the variance of up to `parts`
  /// groups of them. `shown` converts a difference of values, as absolute values, to an error.
  template <typename Shown>
  [[nodiscard]] static double standard_error_of(std::span<const Sum> sums, glm::dvec3 mean,
                                                Shown&& shown) {
    double all = 0.0;
    for (const Sum& sum : sums) all += sum.weight;
    double squares = 0.0, weights2 = 0.0;
    int found = 0;
    for (std::size_t p = 0; p < parts; ++p) {
      Sum part;
      for (std::size_t k = p * sums.size() / parts; k < (p + 1) * sums.size() / parts; ++k)
        part += sums[k];
      if (!(part.weight > 0.0)) continue;
      const double share = part.weight / all;
      const double off = share * shown(glm::abs(part.mean() - mean));
      squares += off * off;
      weights2 += share * share;
      ++found;
    }
    if (found < 2) return std::numeric_limits<double>::infinity();
    // For n parts of equal weight this is the root of sum (off / n)^2 n / (n - 1).
    return std::sqrt(squares / (1.0 - weights2));
  }

  /// Fewer parts agree by chance too often, which ends sampling too early.
  static constexpr std::size_t parts = 8;
  /// Number of stored sums: with more samples, each sum has more of them.
  static constexpr std::size_t most_sums = 2 * parts;

 private:
  [[nodiscard]] Sum all() const {
    Sum sum;
    for (std::size_t i = 0; i < used_; ++i) sum += sums_[i];
    return sum;
  }
  void start_sum() {
    if (used_ == most_sums) {
      for (std::size_t i = 0; i < parts; ++i) {
        const Sum pair = sums_[2 * i];
        sums_[i] = pair;
        sums_[i] += sums_[2 * i + 1];
      }
      used_ = parts;
      per_sum_ *= 2;
    }
    sums_[used_++] = {};
    in_last_ = 0;
  }

  std::array<Sum, most_sums> sums_{};
  std::size_t used_ = 0;
  std::uint32_t per_sum_ = 1, in_last_ = 1, count_ = 0;
};

}  // namespace asos
