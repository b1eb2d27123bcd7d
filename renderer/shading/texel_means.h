#pragma once

#include "renderer/shading/bilinear.h"
#include "renderer/shading/channels.h"
#include "renderer/shading/level_patch.h"
#include "renderer/shading/mip_levels.h"
#include "renderer/shading/texel_window.h"
#include "renderer/shading/texture.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

// Means of texels, for filters of single places and of batches.

namespace asos {

/// One axis of a level.
struct TexelAxis {
  int size;
  Wrap wrap;

  /// Converts a coordinate of any size to texels. Places far outside the level become a nearer one
  /// with the same texel.
  [[nodiscard]] float place(float u) const {
    if (!std::isfinite(u)) u = 0.0f;
    if (wrap == Wrap::repeat) u -= floor_near(u);
    if (wrap == Wrap::mirrored_repeat) u -= 2.0f * floor_near(0.5f * u);
    const float at = u * static_cast<float>(size) - 0.5f;
    const float outside = 2.0f * TexelBudget().most;
    return std::clamp(at, -outside, static_cast<float>(2 * size) + outside);
  }

  [[nodiscard]] int texel(int i) const {
    if (i >= 0 && i < size) return i;
    if (wrap == Wrap::clamp_to_edge) return i < 0 ? 0 : size - 1;
    const int period = wrap == Wrap::repeat ? size : 2 * size;
    const int within = i % period < 0 ? i % period + period : i % period;
    return within < size ? within : period - 1 - within;
  }
};

// Levels of texels: each has a width, a height and texels in some meaning.

/// An image's own texels.
struct ImageLevel {
  Texels texels;
  int width = texels.width;
  int height = texels.height;

  [[nodiscard]] Channels at(int x, int y) const { return channels_of(texels.at(x, y)); }
};

/// A level of a mip chain.
struct ChainLevel {
  const MipLevel& level;
  int width = level.width;
  int height = level.height;

  [[nodiscard]] Channels at(int x, int y) const {
    const std::uint16_t* p = level.texel(x, y);
    return Channels{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]),
                    static_cast<float>(p[3])} *
           MipLevel::unit;
  }
};

/// Colours multiplied by their coverage, which is the last component.
template <typename Level>
struct Premultiplied {
  const Level& level;
  std::optional<float> cutoff;
  int width = level.width;
  int height = level.height;

  [[nodiscard]] Channels at(int x, int y) const {
    const Channels texel = level.at(x, y);
    const float seen = cutoff ? (texel[3] >= *cutoff ? 1.0f : 0.0f) : texel[3];
    return Channels{seen * texel[0], seen * texel[1], seen * texel[2], seen};
  }
};

/// Normals of a mip chain as moments that can be averaged: the mean and, last, the mean square.
struct NormalMoments {
  ChainLevel level;
  int width = level.width;
  int height = level.height;

  [[nodiscard]] Channels at(int x, int y) const {
    const Channels texel = level.at(x, y);
    const Channels n = 2.0f * texel - 1.0f, square = n * n;
    return Channels{n[0], n[1], n[2], texel[3] + (square[0] + square[1] + square[2])};
  }
};

/// A map's own normals, each of length 1, as such moments.
struct UnitNormals {
  Texels texels;
  int width = texels.width;
  int height = texels.height;

  [[nodiscard]] Channels at(int x, int y) const {
    return channels_of({unit_normal(texels.at(x, y)), 1.0f});
  }
};

/// Adds up texels of a level by weights.
template <typename Level>
class TexelSum {
 public:
  TexelSum(const Level& level, const Texture& texture)
      : level_(level), u_{level.width, texture.wrap_u}, v_{level.height, texture.wrap_v} {}

  void add(int x, int y, float share) {
    sum_ += share * level_.at(u_.texel(x), v_.texel(y));
    weight_ += share;
  }
  /// Returns the mean, or the value at `uv` if no texel was added.
  [[nodiscard]] Channels mean(glm::vec2 uv) const {
    return weight_ > 0.0f ? sum_ / weight_ : bilinear_channels(level_, uv, u_.wrap, v_.wrap);
  }

 private:
  const Level& level_;
  TexelAxis u_, v_;
  Channels sum_{};
  float weight_ = 0.0f;
};

/// Returns the mean of a level's texels as `mean(level)` computes it. With alpha blending or
/// cut-off, colours are weighted by coverage, since invisible texels have a colour, too.
template <typename Level, typename Mean>
[[nodiscard]] glm::vec4 mean_of_texels(const Level& level, TexelKind kind,
                                       std::optional<float> cutoff, const Mean& mean) {
  if (kind == TexelKind::cover) {
    const Channels seen = mean(Premultiplied<Level>{level, cutoff});
    if (seen[3] > 0.0f) {
      const float alpha = cutoff ? mean(level)[3] : seen[3];
      return {seen[0] / seen[3], seen[1] / seen[3], seen[2] / seen[3], alpha};
    }
  }
  return vec4_of(mean(level));
}

/// The finest level of a bilinear texture around a patch. Each texel is decoded once if there are
/// few enough.
class TexelBlock {
 public:
  TexelBlock(const Texels& texels, glm::vec2 uv, const TexelPatch& patch, const Texture& texture)
      : texels_(texels),
        u_{texels.width, texture.wrap_u},
        v_{texels.height, texture.wrap_v},
        centre_(u_.place(uv.x), v_.place(uv.y)) {
    const glm::vec2 half = 0.5f * (glm::abs(patch.right) + glm::abs(patch.down));
    x_ = static_cast<int>(floor_near(centre_.x - half.x));
    y_ = static_cast<int>(floor_near(centre_.y - half.y));
    across_ = static_cast<int>(floor_near(centre_.x + half.x)) + 2 - x_;
    const int along = static_cast<int>(floor_near(centre_.y + half.y)) + 2 - y_;
    decoded_ = across_ * along <= most;
    if (!decoded_) return;
    Channels* next = known_.data();
    for (int y = 0; y < along; ++y) {
      const int row = v_.texel(y_ + y);
      for (int x = 0; x < across_; ++x) *next++ = decode(u_.texel(x_ + x), row);
    }
  }

  /// Returns the bilinear value at this offset from the patch's centre, in texels.
  [[nodiscard]] Channels at(glm::vec2 off) const {
    const glm::vec2 place = centre_ + off;
    const float left = floor_near(place.x), top = floor_near(place.y);
    const int x = static_cast<int>(left), y = static_cast<int>(top);
    const float fx = place.x - left, fy = place.y - top;
    if (!decoded_) {
      return mixed(mixed(texel(x, y), texel(x + 1, y), fx),
                   mixed(texel(x, y + 1), texel(x + 1, y + 1), fx), fy);
    }
    const Channels* above = &known_[static_cast<std::size_t>((y - y_) * across_ + x - x_)];
    const Channels* below = above + across_;
    return mixed(mixed(above[0], above[1], fx), mixed(below[0], below[1], fx), fy);
  }

 private:
  static constexpr int most = 64;

  [[nodiscard]] Channels decode(int column, int row) const {
    return channels_of(texels_.at(column, row));
  }
  [[nodiscard]] Channels texel(int x, int y) const { return decode(u_.texel(x), v_.texel(y)); }

  const Texels& texels_;
  TexelAxis u_, v_;
  glm::vec2 centre_;  // in texels
  int x_ = 0, y_ = 0, across_ = 0;
  bool decoded_ = false;
  std::array<Channels, most> known_;
};

/// A normal map's mean over a footprint and the variance that the mean leaves out. The mean is
/// encoded like the texels and has any length. The variance is the mean squared distance of the
/// unit normals from their mean, 0 to 1; 0 if the footprint is a point.
struct MeanNormal {
  glm::vec3 texel{0.5f, 0.5f, 1.0f};
  float variance = 0.0f;
};
[[nodiscard]] inline MeanNormal mean_normal(Channels moments) {
  const glm::vec3 mean(moments[0], moments[1], moments[2]);
  return {0.5f + 0.5f * mean, std::max(0.0f, moments[3] - glm::dot(mean, mean))};
}

// Means over a patch of a bilinear texture's finest level, by points half a texel apart. Used where
// values between texels are no mixture of texels, or where the patch is oblique and covers few
// texels.

[[nodiscard]] glm::vec4 mean_of_points(const Texels& texels, glm::vec2 uv, const TexelPatch& patch,
                                       const Texture& texture);
/// Returns the mean colour of the visible part and the mean alpha; if nothing is visible, the mean
/// of all.
[[nodiscard]] glm::vec4 mean_of_seen(const Texels& texels, std::optional<float> cutoff,
                                     glm::vec2 uv, const TexelPatch& patch, const Texture& texture);
/// Returns the mean of a map's unit normals and their variance.
[[nodiscard]] MeanNormal mean_of_normals(const Texels& texels, glm::vec2 uv,
                                         const TexelPatch& patch, const Texture& texture);

/// Patches of unit normals, and of colours weighted by coverage, are sampled at several points up
/// to these sizes, in texels. Neither is linear between texels, so a single point is not their
/// mean.
inline constexpr float longest_normals_by_points = 4.0f;
inline constexpr float longest_seen_by_points = 16.0f;

[[nodiscard]] inline bool is_aslant(const TexelPatch& patch) {
  const auto turned = [](glm::vec2 edge) {
    return std::min(std::abs(edge.x), std::abs(edge.y)) > 0.05f * glm::length(edge);
  };
  return turned(patch.right) || turned(patch.down);
}

/// Returns whether TexelWindow would use a rotated tent for each texel. That gives the right width,
/// but not the right places of texels, which is visible in patches with few of them.
[[nodiscard]] inline bool is_by_points(const TexelPatch& patch) {
  constexpr float longest_by_points = 2.0f;
  return patch.longest() <= longest_by_points && is_aslant(patch);
}

}  // namespace asos
