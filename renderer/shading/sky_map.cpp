#include "renderer/shading/sky_map.h"

#include "renderer/shading/texture_filter.h"
#include "renderer/tasks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tbb/task_arena.h>
#include <utility>

namespace asos {
namespace {

constexpr double pi = std::numbers::pi;

/// For a picture with more texels than this, the second level is computed on access. Storing it
/// would take another two thirds of the picture's memory.
constexpr std::size_t large_picture = std::size_t{1} << 23;
/// Directions are sampled by texels of half a degree.
constexpr int distribution_rows = 360;

/// Makes rows without texels; row `r` has columns_of(r) columns.
template <typename ColumnsOf>
SkyRows empty_rows(int rows, const ColumnsOf& columns_of) {
  SkyRows level;
  level.start.push_back(0);
  for (int r = 0; r < rows; ++r)
    level.start.push_back(level.start.back() + static_cast<std::uint32_t>(columns_of(r)));
  return level;
}

SkyRows reduced_rows(int rows, int most_columns) {
  if (rows == 1) return empty_rows(1, [](int) { return 1; });
  return empty_rows(rows, [&](int r) {
    const double square = 2.0 * rows * std::sin(pi * (r + 0.5) / rows);
    return std::clamp(static_cast<int>(std::lround(square)), 1, most_columns);
  });
}

/// Returns the integral of a row of `n` texels over u from `lo` to `hi` turns.
template <typename Texel>
glm::dvec3 row_integral(int n, double lo, double hi, const Texel& texel) {
  const double from = lo * n, to = hi * n;
  const int last = std::min(n, static_cast<int>(std::ceil(to)));
  glm::dvec3 sum(0.0);
  for (int i = static_cast<int>(from); i < last; ++i)
    sum += std::max(0.0, std::min(to, i + 1.0) - std::max(from, static_cast<double>(i))) *
           glm::dvec3(texel(i));
  return sum / static_cast<double>(n);
}

glm::dvec3 row_integral(const SkyRows& level, int row, double lo, double hi) {
  return row_integral(level.columns(row), lo, hi, [&](int i) { return level.texel(row, i); });
}

void find_poles(SkyRows& level) {
  level.zenith = row_integral(level, 0, 0.0, 1.0);
  level.nadir = row_integral(level, level.rows() - 1, 0.0, 1.0);
}

/// Returns a texel of a level with as many rows as the picture: the mean of the texels that it
/// covers.
glm::vec3 mean_in_row(const SkyRows& picture, int row, int column, int columns) {
  const double lo = static_cast<double>(column) / columns;
  const double hi = static_cast<double>(column + 1) / columns;
  return row_integral(picture, row, lo, hi) / (hi - lo);
}

/// Returns whether a row with this many columns is computed on access instead of stored.
bool is_made_anew(int columns, int picture_columns) {
  constexpr int most_covered = 8;
  return most_covered * columns >= picture_columns;
}

/// Returns the stored rows of a large picture's second level, which are those near the poles. The
/// other rows have no texels.
SkyRows polar_rows(const SkyRows& picture, const SkyRows& shape) {
  const int width = picture.columns(0);
  SkyRows kept;
  kept.start.push_back(0);
  for (int r = 0; r < shape.rows(); ++r) {
    const int n = shape.columns(r);
    if (!is_made_anew(n, width))
      for (int i = 0; i < n; ++i) kept.texels.add(mean_in_row(picture, r, i, n));
    kept.start.push_back(static_cast<std::uint32_t>(kept.texels.size()));
  }
  return kept;
}

/// Fills `coarse` with means of `fine` by solid angle, on all processors. `texel(row, column)`
/// returns the texels of `fine`.
template <typename Texel>
void fill_with_means(const SkyRows& fine, SkyRows& coarse, const Texel& texel) {
  const int rows = coarse.rows();
  std::vector<glm::vec3> means(coarse.start.back());
  const double ratio = static_cast<double>(fine.rows()) / rows;
  const auto height_at = [&](double fine_row) { return std::cos(pi * fine_row / fine.rows()); };
  const auto fill_row = [&](std::size_t row) {
    const int r = static_cast<int>(row);
    const double from = r * ratio, to = (r + 1) * ratio;
    const int first = static_cast<int>(from);
    const int last = std::min(fine.rows(), static_cast<int>(std::ceil(to)));
    std::vector<double> shares;
    for (int k = first; k < last; ++k)
      shares.push_back(height_at(std::max(from, static_cast<double>(k))) -
                       height_at(std::min(to, k + 1.0)));
    const int n = coarse.columns(r);
    for (int i = 0; i < n; ++i) {
      const double lo = static_cast<double>(i) / n, hi = static_cast<double>(i + 1) / n;
      glm::dvec3 sum(0.0);
      double weight = 0.0;
      for (int k = first; k < last; ++k) {
        const double share = shares[static_cast<std::size_t>(k - first)];
        sum += share *
               row_integral(fine.columns(k), lo, hi, [&](int column) { return texel(k, column); });
        weight += share * (hi - lo);
      }
      means[coarse.start[row] + static_cast<std::size_t>(i)] = sum / weight;
    }
  };
  // A thread that waits here must not begin another task: that may wait for this picture.
  tbb::this_task_arena::isolate([&] { in_tasks(static_cast<std::size_t>(rows), fill_row); });
  coarse.texels = std::move(means);
  find_poles(coarse);
}

}  // namespace

SkyPlace sky_place(glm::dvec3 d) {
  // atan2 rather than acos, which is inaccurate near the poles.
  return {0.5 + std::atan2(d.x, -d.z) / (2.0 * pi), std::atan2(std::hypot(d.x, d.z), d.y) / pi};
}

namespace {

template <typename Texel>
glm::vec3 look_up(const SkyRows& rows, double u, double v, const Texel& texel) {
  if (!std::isfinite(u) || !std::isfinite(v))
    return glm::vec3(std::numeric_limits<float>::quiet_NaN());
  const double turns = u - std::floor(u);
  const auto along_row = [&](int row) {
    const int n = rows.columns(row);
    const double x = turns * n - 0.5;
    const double left = std::floor(x);
    const int i = (static_cast<int>(left) + n) % n;
    return glm::mix(glm::dvec3(texel(row, i)), glm::dvec3(texel(row, (i + 1) % n)), x - left);
  };
  const double y = v * rows.rows() - 0.5;
  const int last = rows.rows() - 1;
  if (y < 0.0) return glm::mix(rows.zenith, along_row(0), 1.0 + 2.0 * y);
  if (y >= last) return glm::mix(along_row(last), rows.nadir, std::min(1.0, 2.0 * (y - last)));
  const int row = static_cast<int>(y);
  return glm::mix(along_row(row), along_row(row + 1), y - row);
}

}  // namespace

glm::vec3 SkyRows::at(double u, double v) const {
  return look_up(*this, u, v, [this](int row, int column) { return texel(row, column); });
}

SkyMap::SkyMap(int width, int height, SkyTexels texels)
    : distribution_(std::make_unique<Distribution>()) {
  const bool large = texels.size() >= large_picture;
  levels_.push_back(empty_rows(height, [&](int) { return width; }));
  levels_.front().texels = std::move(texels);
  find_poles(levels_.front());
  for (int rows = height; rows >= 1; rows /= 2) {
    const SkyRows& finer = levels_.back();
    SkyRows level = reduced_rows(rows, width);
    if (large && levels_.size() == 1) {
      polar_ = polar_rows(finer, level);
      level.zenith = row_integral(polar_, 0, 0.0, 1.0);
      level.nadir = row_integral(polar_, rows - 1, 0.0, 1.0);
    } else if (large && levels_.size() == 2) {
      fill_with_means(finer, level, [this](int r, int i) { return second_texel(r, i); });
    } else {
      fill_with_means(finer, level, [&finer](int r, int i) { return finer.texel(r, i); });
    }
    levels_.push_back(std::move(level));
  }
}

const SkyRows& SkyMap::rows_below(int rows) const {
  return *std::find_if(levels_.begin() + 1, levels_.end(),
                       [rows](const SkyRows& level) { return level.rows() <= rows; });
}

const SkyDistribution& SkyMap::distribution() const {
  std::call_once(distribution_->once,
                 [this] { distribution_->made.emplace(rows_below(distribution_rows)); });
  return *distribution_->made;
}

glm::vec3 SkyMap::second_texel(int row, int column) const {
  return polar_.columns(row) > 0 ? polar_.texel(row, column)
                                 : mean_in_row(levels_[0], row, column, levels_[1].columns(row));
}

glm::vec3 SkyMap::level_at(std::size_t level, double u, double v) const {
  if (level != 1 || polar_.start.empty()) return levels_[level].at(u, v);
  return look_up(levels_[1], u, v, [this](int r, int i) { return second_texel(r, i); });
}

glm::vec3 SkyMap::mean(glm::dvec3 direction, double side) const {
  const auto [u, v] = sky_place(direction);
  const SkyRows& picture = levels_.front();
  if (!(side > 0.0)) return picture.at(u, v);
  // The texel size is in heights of the picture's rows. Below one, rows near the poles blend to
  // fewer columns. A bilinear look-up of texels of side s has a variance of s^2 / 4, and a box of
  // side w has w^2 / 12.
  const double texel = side / std::numbers::sqrt3 * picture.rows() / pi;
  if (texel < 1.0) {
    const glm::dvec3 sharp = picture.at(u, v);
    return glm::mix(sharp, glm::dvec3(level_at(1, u, v)), texel);
  }
  const double level = std::min(std::log2(texel), static_cast<double>(levels_.size() - 2));
  const auto finer = static_cast<std::size_t>(level);
  const std::size_t coarser = std::min(finer + 1, levels_.size() - 2);
  return glm::mix(glm::dvec3(level_at(1 + finer, u, v)), glm::dvec3(level_at(1 + coarser, u, v)),
                  level - static_cast<double>(finer));
}

std::size_t SkyMap::memory_bytes() const {
  const auto bytes_of = [](const SkyRows& level) {
    return level.texels.memory_bytes() + level.start.capacity() * sizeof(std::uint32_t);
  };
  std::size_t bytes = bytes_of(polar_);
  for (const SkyRows& level : levels_) bytes += bytes_of(level);
  return bytes;
}

}  // namespace asos
