#include "renderer/shading/texture_filter.h"

#include "renderer/scene/scene.h"
#include "renderer/shading/bilinear.h"
#include "renderer/shading/level_patch.h"
#include "renderer/shading/texel_areas.h"
#include "renderer/shading/texel_window.h"
#include "renderer/shading/texture.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace asos {
namespace {

/// One axis of a level.
struct Axis {
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
    auto next = known_.begin();
    for (int y = 0; y < along; ++y)
      for (int x = 0; x < across_; ++x) *next++ = decode(x_ + x, y_ + y);
  }

  /// Returns the bilinear value at this offset from the patch's centre, in texels.
  [[nodiscard]] glm::vec4 at(glm::vec2 off) const {
    const glm::vec2 place = centre_ + off;
    const float left = floor_near(place.x), top = floor_near(place.y);
    const int x = static_cast<int>(left), y = static_cast<int>(top);
    const float fx = place.x - left, fy = place.y - top;
    return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), fx),
                    glm::mix(texel(x, y + 1), texel(x + 1, y + 1), fx), fy);
  }

 private:
  static constexpr int most = 64;

  [[nodiscard]] glm::vec4 decode(int x, int y) const {
    return texels_.at(u_.texel(x), v_.texel(y));
  }
  [[nodiscard]] glm::vec4 texel(int x, int y) const {
    if (!decoded_) return decode(x, y);
    return known_[static_cast<std::size_t>((y - y_) * across_ + x - x_)];
  }

  const Texels& texels_;
  Axis u_, v_;
  glm::vec2 centre_;  // in texels
  int x_ = 0, y_ = 0, across_ = 0;
  bool decoded_ = false;
  std::array<glm::vec4, most> known_;
};

// Means over a patch of a bilinear texture's finest level, by points half a texel apart. Used where
// values between texels are no mixture of texels, or where the patch is oblique and covers few
// texels.

/// Visits a grid of points of a patch, half a texel apart and at least `fewest` along each edge. A
/// point is its offset from the patch's centre, in texels. Returns their number.
template <typename Visit>
int for_each_point(const TexelPatch& patch, int fewest, const Visit& visit) {
  const auto count = [fewest](glm::vec2 edge) {
    return std::max(fewest, 1 + static_cast<int>(2.0f * glm::length(edge)));
  };
  const int across = count(patch.right), along = count(patch.down);
  for (int y = 0; y < along; ++y) {
    for (int x = 0; x < across; ++x) {
      const auto middle = [](int i, int n) {
        return (static_cast<float>(i) + 0.5f) / static_cast<float>(n) - 0.5f;
      };
      visit(middle(x, across) * patch.right + middle(y, along) * patch.down);
    }
  }
  return across * along;
}

// Returns the mean over the whole patch.
glm::vec4 mean_of_points(const Texels& texels, glm::vec2 uv, const TexelPatch& patch,
                         const Texture& texture) {
  const TexelBlock block(texels, uv, patch, texture);
  glm::vec4 sum(0.0f);
  const int count = for_each_point(patch, 1, [&](glm::vec2 off) { sum += block.at(off); });
  return sum / static_cast<float>(count);
}

// Returns the mean colour of the visible part and the mean alpha; if nothing is visible, the mean
// of all.
glm::vec4 mean_of_seen(const Texels& texels, const TexelUse& use, glm::vec2 uv,
                       const TexelPatch& patch, const Texture& texture) {
  const TexelBlock block(texels, uv, patch, texture);
  glm::vec4 sum(0.0f), seen(0.0f);
  const int count = for_each_point(patch, 2, [&](glm::vec2 off) {
    const glm::vec4 texel = block.at(off);
    const float share = use.cutoff ? (texel.a >= *use.cutoff ? 1.0f : 0.0f) : texel.a;
    sum += texel;
    seen += share * glm::vec4(glm::vec3(texel), 1.0f);
  });
  const float alpha = sum.a / static_cast<float>(count);
  const glm::vec3 colour =
      seen.a > 0.0f ? glm::vec3(seen) / seen.a : glm::vec3(sum) / static_cast<float>(count);
  return {colour, alpha};
}

// Returns the mean of a map's unit normals and their variance.
MeanNormal mean_of_normals(const Texels& texels, glm::vec2 uv, const TexelPatch& patch,
                           const Texture& texture) {
  const TexelBlock block(texels, uv, patch, texture);
  glm::vec3 sum(0.0f);
  const int count =
      for_each_point(patch, 2, [&](glm::vec2 off) { sum += unit_normal(block.at(off)); });
  const glm::vec3 mean = sum / static_cast<float>(count);
  return {0.5f + 0.5f * mean, std::max(0.0f, 1.0f - glm::dot(mean, mean))};
}

bool aslant(const TexelPatch& patch) {
  const auto turned = [](glm::vec2 edge) {
    return std::min(std::abs(edge.x), std::abs(edge.y)) > 0.05f * glm::length(edge);
  };
  return turned(patch.right) || turned(patch.down);
}

// Patches of nearest texels up to this size, in texels, are integrated exactly. In larger ones the
// exact areas cost more than they improve.
constexpr float longest_in_areas = 8.0f;

/// Returns the mean of a level's texels over a patch around `uv`.
template <typename Level>
glm::vec4 mean_of(const Level& level, glm::vec2 uv, const TexelPatch& patch, TexelShape shape,
                  const Texture& texture) {
  const Axis u{level.width, texture.wrap_u}, v{level.height, texture.wrap_v};
  glm::vec4 sum(0.0f);
  float weight = 0.0f;
  const glm::vec2 centre(u.place(uv.x), v.place(uv.y));
  const auto add = [&](int x, int y, float share) {
    sum += share * level.at(u.texel(x), v.texel(y));
    weight += share;
  };
  if (shape == TexelShape::box && patch.longest() <= longest_in_areas && aslant(patch)) {
    TexelAreas(centre, patch).for_each(add);
  } else {
    TexelWindow(centre, patch, shape).for_each(add);
  }
  return weight > 0.0f ? sum / weight : bilinear(level, uv, texture.wrap_u, texture.wrap_v);
}

/// Returns whether a patch lies within a single nearest texel, as most small ones do.
bool in_one_texel(const Image& image, glm::vec2 uv, const TexelPatch& patch,
                  const Texture& texture) {
  const glm::vec2 half = 0.5f * (glm::abs(patch.right) + glm::abs(patch.down));
  const auto in_one = [](float place, float reach) {
    return floor_near(place - reach + 0.5f) == floor_near(place + reach + 0.5f);
  };
  return in_one(Axis{image.width, texture.wrap_u}.place(uv.x), half.x) &&
         in_one(Axis{image.height, texture.wrap_v}.place(uv.y), half.y);
}

TexelShape shape_of(const Texture& texture, std::size_t level) {
  return level == 0 && texture.filter == Filter::nearest ? TexelShape::box : TexelShape::tent;
}

glm::vec2 lookup_uv(const World& world, const TextureUse& use, const TexturePlace& place) {
  const glm::vec2 middle = glm::vec2(place.b1, place.b2) + place.footprint.offset;
  const glm::vec2 uv = texcoord_at(world, use.texcoord, place.triangle, middle.x, middle.y);
  return {use.uv_transform * glm::vec3(uv, 1.0f)};
}

// Patches up to this size, in texels, are sampled by points.
constexpr float longest_by_points = 2.0f;

/// Returns whether TexelWindow would use a rotated tent for each texel. That gives the right width,
/// but not the right places of texels, which is visible in patches with few of them.
bool by_points(const TexelPatch& patch) {
  return patch.longest() <= longest_by_points && aslant(patch);
}

LevelPatch patch_for(const World& world, const MipChain& chain, const TextureUse& use,
                     const TexturePlace& place) {
  if (place.footprint.point() || use.texcoord < 0 || use.texcoord > 1 || chain.empty()) return {};
  const Image* image = image_of(world, use.texture);
  if (!image) return {};
  if (!world.is_face(place.triangle) && world.texcoords[use.texcoord].empty()) return {};
  const CornerTexcoords at = corner_texcoords(world, use.texcoord, place.triangle);
  const Steps<glm::vec2> steps(place.footprint, at.at_0, at.at_1, at.at_2);
  const glm::mat2 turn(use.uv_transform);
  const glm::vec2 size(image->width, image->height);
  const Filter filter = world.textures[static_cast<std::size_t>(use.texture)].filter;
  return patch_in(chain.size(), *image, filter,
                  {size * (turn * steps.right), size * (turn * steps.down)},
                  TexelBudget::of(place.footprint.side));
}

/// A level of colours multiplied by their coverage, which is the last component.
template <typename Level>
struct Premultiplied {
  const Level& level;
  std::optional<float> cutoff;
  int width = level.width;
  int height = level.height;

  [[nodiscard]] glm::vec4 at(int x, int y) const {
    const glm::vec4 texel = level.at(x, y);
    const float seen = cutoff ? (texel.a >= *cutoff ? 1.0f : 0.0f) : texel.a;
    return {seen * glm::vec3(texel), seen};
  }
};

/// Returns the mean of a level's texels. With alpha blending or cut-off, colours are weighted by
/// coverage, since invisible texels have a colour, too.
template <typename Level>
glm::vec4 mean_of(const Level& level, const TexelUse& texels, glm::vec2 uv, const TexelPatch& patch,
                  TexelShape shape, const Texture& texture) {
  if (texels.kind == TexelKind::cover) {
    const glm::vec4 seen =
        mean_of(Premultiplied<Level>{level, texels.cutoff}, uv, patch, shape, texture);
    if (seen.a > 0.0f) {
      const float alpha = texels.cutoff ? mean_of(level, uv, patch, shape, texture).a : seen.a;
      return {glm::vec3(seen) / seen.a, alpha};
    }
  }
  return mean_of(level, uv, patch, shape, texture);
}

/// A level of normals as moments that can be averaged: the mean and, last, the mean square.
struct Moments {
  const MipLevel& level;
  int width = level.width;
  int height = level.height;

  [[nodiscard]] glm::vec4 at(int x, int y) const {
    const glm::vec4 texel = level.at(x, y);
    const glm::vec3 n = 2.0f * glm::vec3(texel) - 1.0f;
    return {n, texel.a + glm::dot(n, n)};
  }
};

// Patches of unit normals, and of colours weighted by coverage, are sampled at several points up to
// these sizes, in texels. Neither is linear between texels, so a single point is not their mean.
constexpr float longest_normals_by_points = 4.0f;
constexpr float longest_seen_by_points = 16.0f;

/// The finest level of normals, each of length 1.
struct UnitNormals {
  Texels texels;
  int width = texels.width;
  int height = texels.height;

  [[nodiscard]] glm::vec4 at(int x, int y) const { return {unit_normal(texels.at(x, y)), 1.0f}; }
};

const MipChain& chain_of(const World& world, const MipChains& mips, const TextureUse& use,
                         TexelKind kind) {
  static const MipChain none;
  if (!image_of(world, use.texture)) return none;
  return mips.chain(world.textures[static_cast<std::size_t>(use.texture)].image, kind);
}

}  // namespace

glm::vec4 filtered_texture(const World& world, const MipChains& mips, const TextureUse& use,
                           const TexelUse& texels, const TexturePlace& place) {
  const Encoding encoding = texels.kind == TexelKind::data ? Encoding::linear : Encoding::srgb;
  const glm::vec2 uv = lookup_uv(world, use, place);
  const MipChain& chain = chain_of(world, mips, use, texels.kind);
  const LevelPatch found = patch_for(world, chain, use, place);
  if (found.point()) return sample_texture(world, use.texture, uv, encoding);
  const Texture& texture = world.textures[static_cast<std::size_t>(use.texture)];
  const TexelShape shape = shape_of(texture, found.level);
  if (shape == TexelShape::box &&
      in_one_texel(*image_of(world, use.texture), uv, found.patch, texture))
    return sample_texture(world, use.texture, uv, encoding);
  if (found.level > 0)
    return mean_of(chain[found.level - 1], texels, uv, found.patch, shape, texture);
  const Texels finest(*image_of(world, use.texture), encoding);
  const bool tents = shape == TexelShape::tent;
  if (tents && texels.kind == TexelKind::cover && found.patch.longest() <= longest_seen_by_points)
    return mean_of_seen(finest, texels, uv, found.patch, texture);
  if (tents && texels.kind != TexelKind::cover && by_points(found.patch))
    return mean_of_points(finest, uv, found.patch, texture);
  return mean_of(finest, texels, uv, found.patch, shape, texture);
}

MeanNormal filtered_normal(const World& world, const MipChains& mips, const TextureUse& use,
                           const TexturePlace& place) {
  const glm::vec2 uv = lookup_uv(world, use, place);
  const MipChain& chain = chain_of(world, mips, use, TexelKind::normal);
  LevelPatch found = patch_for(world, chain, use, place);
  if (found.point())
    return {glm::vec3(sample_texture(world, use.texture, uv, Encoding::linear)), 0.0f};
  const Texture& texture = world.textures[static_cast<std::size_t>(use.texture)];
  if (found.level == 0 && texture.filter != Filter::nearest) {
    const Texels finest(*image_of(world, use.texture), Encoding::linear);
    if (found.patch.longest() <= longest_normals_by_points)
      return mean_of_normals(finest, uv, found.patch, texture);
    // The next level includes interpolated normals between these texels.
    found = coarser(found, finest);
  }
  const TexelShape shape = shape_of(texture, found.level);
  const glm::vec4 moments =
      found.level > 0
          ? mean_of(Moments{chain[found.level - 1]}, uv, found.patch, shape, texture)
          : mean_of(UnitNormals{Texels(*image_of(world, use.texture), Encoding::linear)}, uv,
                    found.patch, shape, texture);
  const glm::vec3 mean(moments);
  return {0.5f + 0.5f * mean, std::max(0.0f, moments.a - glm::dot(mean, mean))};
}

}  // namespace asos
