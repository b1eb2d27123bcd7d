#include "renderer/shading/mip_levels.h"

#include "renderer/shading/channels.h"
#include "renderer/shading/normal_rows.h"
#include "renderer/shading/texture.h"
#include "renderer/tasks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace asos {
namespace {

using Integers [[gnu::vector_size(16)]] = int;

/// The texels of a row of `from` texels that fall into texel `i` of a row of `to`, and their
/// fractions of it. There are up to three, since an odd size is halved and rounded down.
struct BoxSpan {
  int first;
  int count;
  std::array<float, 3> share{};

  BoxSpan(int i, int from, int to) {
    const double ratio = static_cast<double>(from) / to, lo = i * ratio, hi = (i + 1) * ratio;
    first = static_cast<int>(lo);
    count = std::min(from, static_cast<int>(std::ceil(hi))) - first;
    for (int k = 0; k < count; ++k) {
      const double begin = first + k;
      share[static_cast<std::size_t>(k)] =
          static_cast<float>((std::min(hi, begin + 1.0) - std::max(lo, begin)) / ratio);
    }
  }
};

/// The rows of an image of colours or data.
class ImageRows {
 public:
  ImageRows(const Image& image, TexelKind kind)
      : texels_(image, kind == TexelKind::data ? Encoding::linear : Encoding::srgb) {}

  [[nodiscard]] auto row(int y) const {
    return [this, y](int x) { return channels_of(texels_.at(x, y)); };
  }

 private:
  Texels texels_;
};

/// The rows of a normal map, as those of a level.
class MapRows {
 public:
  MapRows(const Image& image, TexelKind) : normals_(image) {}

  [[nodiscard]] auto row(int y) {
    return
        [p = normals_.row(y)](int x) { return channels_of(p + 4 * static_cast<std::size_t>(x)); };
  }

 private:
  NormalRows normals_;
};

/// The rows of a level.
class LevelRows {
 public:
  LevelRows(const MipLevel& level, TexelKind) : level_(level) {}

  [[nodiscard]] auto row(int y) const {
    return [p = level_.texel(0, y)](int x) {
      const std::uint16_t* const at = p + 4 * static_cast<std::size_t>(x);
      return MipLevel::unit *
             __builtin_convertvector((Integers{at[0], at[1], at[2], at[3]}), Channels);
    };
  }

 private:
  const MipLevel& level_;
};

/// Returns the square of the length of a texel's normal.
float normal_square(Channels texel) {
  const Channels normal = 2.0f * texel - 1.0f, square = normal * normal;
  return square[0] + square[1] + square[2];
}

/// The mean of a box of texels.
template <TexelKind kind>
class BoxMean {
 public:
  void add(Channels texel, float share) {
    mean_ += share * texel;
    if constexpr (kind == TexelKind::cover) seen_ += share * texel[3] * texel;
    if constexpr (kind == TexelKind::normal) square_ += share * (texel[3] + normal_square(texel));
  }

  /// Writes the texel of a level.
  void write(std::uint16_t* out) const {
    Channels texel = mean_;
    if constexpr (kind == TexelKind::cover) {
      if (mean_[3] > 0.0f) texel = seen_ / mean_[3];
      texel[3] = mean_[3];
    }
    if constexpr (kind == TexelKind::normal)
      texel[3] = std::max(0.0f, square_ - normal_square(mean_));
    const Integers rounded = __builtin_convertvector(65535.0f * texel + 0.5f, Integers);
    for (int c = 0; c < 4; ++c) out[c] = static_cast<std::uint16_t>(rounded[c]);
  }

 private:
  Channels mean_{};
  Channels seen_{};      // times alpha
  float square_ = 0.0f;  // mean square of normals
};

/// Makes one row of a level with even sides from two of a finer one.
template <TexelKind kind, typename Row>
void halve(const Row& above, const Row& below, int width, std::uint16_t* out) {
  for (int x = 0; x < width; ++x, out += 4) {
    BoxMean<kind> mean;
    mean.add(above(2 * x), 0.25f);
    mean.add(above(2 * x + 1), 0.25f);
    mean.add(below(2 * x), 0.25f);
    mean.add(below(2 * x + 1), 0.25f);
    mean.write(out);
  }
}

/// Makes one row of a level by the areas of texels.
template <TexelKind kind, typename Rows>
void halve_by_areas(Rows& rows, const BoxSpan& span, const std::vector<BoxSpan>& columns,
                    std::uint16_t* out) {
  for (const BoxSpan& column : columns) {
    BoxMean<kind> mean;
    for (int v = 0; v < span.count; ++v) {
      const auto row = rows.row(span.first + v);
      for (int u = 0; u < column.count; ++u)
        mean.add(row(column.first + u), span.share[static_cast<std::size_t>(v)] *
                                            column.share[static_cast<std::size_t>(u)]);
    }
    mean.write(out);
    out += 4;
  }
}

/// Makes the level after `finer`, an image or a level.
template <TexelKind kind, typename Rows, typename Finer>
MipLevel halved(const Finer& finer) {
  constexpr std::size_t fewest_rows = 64;  // of a task, since each has buffers
  MipLevel level;
  level.width = std::max(1, finer.width / 2);
  level.height = std::max(1, finer.height / 2);
  const std::size_t row = 4 * static_cast<std::size_t>(level.width);
  level.rgba.resize(row * static_cast<std::size_t>(level.height));
  const bool even = finer.width % 2 == 0 && finer.height % 2 == 0;
  std::vector<BoxSpan> columns;
  for (int x = 0; x < level.width && !even; ++x) columns.emplace_back(x, finer.width, level.width);
  const auto make_rows = [&](std::size_t begin, std::size_t end) {
    Rows rows(finer, kind);
    for (std::size_t i = begin; i < end; ++i) {
      const auto y = static_cast<int>(i);
      std::uint16_t* const out = level.rgba.data() + i * row;
      if (even) {
        halve<kind>(rows.row(2 * y), rows.row(2 * y + 1), level.width, out);
      } else {
        halve_by_areas<kind>(rows, BoxSpan(y, finer.height, level.height), columns, out);
      }
    }
  };
  in_task_ranges(static_cast<std::size_t>(level.height), fewest_rows, make_rows);
  return level;
}

template <TexelKind kind, typename Rows>
std::vector<MipLevel> levels_of(const Image& image) {
  std::vector<MipLevel> levels{halved<kind, Rows>(image)};
  while (levels.back().width > 1 || levels.back().height > 1) {
    MipLevel coarser = halved<kind, LevelRows>(levels.back());
    levels.push_back(std::move(coarser));
  }
  return levels;
}

}  // namespace

std::size_t mip_levels_of(const Image& image) {
  if (image.width <= 0 || image.height <= 0 || image.rgba.empty()) return 0;
  return static_cast<std::size_t>(
      std::bit_width(static_cast<unsigned>(std::max(image.width, image.height))) - 1);
}

std::vector<MipLevel> make_mip_levels(const Image& image, TexelKind kind) {
  if (mip_levels_of(image) == 0) return {};
  switch (kind) {
    case TexelKind::color:
      return levels_of<TexelKind::color, ImageRows>(image);
    case TexelKind::cover:
      return levels_of<TexelKind::cover, ImageRows>(image);
    case TexelKind::data:
      return levels_of<TexelKind::data, ImageRows>(image);
    case TexelKind::normal:
      return levels_of<TexelKind::normal, MapRows>(image);
  }
  return {};
}

}  // namespace asos
