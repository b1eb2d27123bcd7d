#include "renderer/shading/texture_filter.h"

#include "renderer/shading/bilinear.h"
#include "renderer/shading/texel_areas.h"
#include "renderer/shading/texel_window.h"
#include "renderer/shading/texture.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace asos {
namespace {

/// A level, and a patch of it.
struct LevelPatch {
  std::size_t level = 0;
  TexelPatch patch;

  [[nodiscard]] bool point() const { return patch.right == glm::vec2(0.0f); }
};

// Less than this is not seen, and keeps areas above 0.
constexpr float thinnest = 1.0f / 32.0f;
// Nearest texels end at once, however large they are in the picture; by less the places of larger
// textures are not told apart.
constexpr float least_of_nearest = 1e-4f;
// Longer edges are all the same, for every texture repeats itself along them; the fourth powers of
// these are finite.
constexpr float longest_edge = 1e9f;

/// An edge as long as it has to be for the variance along it, w^2 / 12, to be right: a tent of
/// texels that are boxes themselves adds 1/4 to it, the finest level's own tent would have added
/// 1/6 of its texels.
glm::vec2 less_of_texels(glm::vec2 edge, float texels) {
  const float length2 = glm::dot(edge, edge);
  if (!(length2 > 1e-30f)) return {};  // what it would be divided by is no number
  const float left2 = length2 + 2.0f / (texels * texels) - 3.0f;
  return edge * std::sqrt(std::max(left2, thinnest * thinnest) / length2);
}

/// About how many texels count for it.
float held(const TexelPatch& patch) {
  return (glm::length(patch.right) + 2.0f) * (glm::length(patch.down) + 2.0f);
}

/// The patch with both edges long enough for an area, and short enough for the number of texels
/// where not even the coarsest level is coarse enough: there it repeats itself.
TexelPatch bounded(TexelPatch patch, float least, float most) {
  const float longest = held(patch) > most ? std::sqrt(most) : most;
  const auto within = [&](glm::vec2 edge, glm::vec2 other) {
    const float length = glm::length(edge);
    if (length >= least) return edge * std::min(1.0f, longest / length);
    return least / glm::length(other) * glm::vec2(-other.y, other.x);
  };
  const bool right_first = glm::length(patch.right) >= glm::length(patch.down);
  if (!right_first) std::swap(patch.right, patch.down);
  patch.down = within(patch.down, patch.right);
  patch.right = within(patch.right, patch.down);
  if (!right_first) std::swap(patch.right, patch.down);
  return patch;
}

/// `patch` in the finest level's texels. Coarser ones are taken while it stays wide enough, or
/// holds too many.
LevelPatch patch_in(const MipChain& chain, const Image& image, Filter filter, TexelPatch patch,
                    TexelBudget budget) {
  const bool nearest = filter == Filter::nearest;
  const float longest = patch.longest();
  const float squares = glm::dot(patch.right, patch.right) + glm::dot(patch.down, patch.down);
  if (!(longest > (nearest ? least_of_nearest : least_footprint)) || !std::isfinite(squares))
    return {};
  if (longest > longest_edge) {
    const float shorter = longest_edge / longest;
    patch = {shorter * patch.right, shorter * patch.down};
  }
  if (patch.area() < 0.5f * glm::length(patch.right) * glm::length(patch.down))
    patch = principal_axes(patch);
  LevelPatch found{0, patch};
  for (std::size_t level = 1; level <= chain.size(); ++level) {
    const MipLevel& texels = chain[level - 1];
    const glm::vec2 scale(static_cast<float>(texels.width) / static_cast<float>(image.width),
                          static_cast<float>(texels.height) / static_cast<float>(image.height));
    const TexelPatch coarser{scale * patch.right, scale * patch.down};
    const float width = std::min(glm::length(coarser.right), glm::length(coarser.down));
    if (width < budget.across && held(found.patch) <= budget.most) break;
    found = {level, coarser};
  }
  if (found.level > 0) {
    const float texels = std::ldexp(1.0f, static_cast<int>(found.level));
    found.patch.right = less_of_texels(found.patch.right, texels);
    found.patch.down = less_of_texels(found.patch.down, texels);
  }
  const bool in_areas = nearest && found.level == 0;
  found.patch = bounded(found.patch, in_areas ? 0.1f * least_of_nearest : thinnest, budget.most);
  return found;
}

/// One axis of a level.
struct Axis {
  int size;
  Wrap wrap;

  /// A coordinate of any size in texels, near the level: what is that far outside is all the same.
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

bool aslant(const TexelPatch& patch) {
  const auto turned = [](glm::vec2 edge) {
    return std::min(std::abs(edge.x), std::abs(edge.y)) > 0.05f * glm::length(edge);
  };
  return turned(patch.right) || turned(patch.down);
}

// Up to so many texels a patch of nearest ones is cut where they end: of more of them, where each
// lies shows less than that costs.
constexpr float longest_in_areas = 8.0f;

/// The mean over a patch around `uv` of a level's texels.
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

/// Whether a patch shows one of the nearest texels only, as most small ones do.
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

// Up to so many texels a patch's edges are looked at by points.
constexpr float longest_by_points = 2.0f;

/// Whether a window over the texels would take a rotated tent for each: right for how wide what is
/// seen comes out, but not for where texels lie, which shows in patches of few of them.
bool by_points(const TexelPatch& patch) {
  return patch.longest() <= longest_by_points && aslant(patch);
}

/// Visits a grid of points of a patch, half a texel apart and `fewest` along each edge at least, by
/// how far they lie from its middle in a texture of that size; how many they are.
template <typename Visit>
int for_each_point(const TexelPatch& patch, int fewest, glm::vec2 size, const Visit& visit) {
  const auto count = [fewest](glm::vec2 edge) {
    return std::max(fewest, 1 + static_cast<int>(2.0f * glm::length(edge)));
  };
  const int across = count(patch.right), along = count(patch.down);
  for (int y = 0; y < along; ++y) {
    for (int x = 0; x < across; ++x) {
      const auto middle = [](int i, int n) {
        return (static_cast<float>(i) + 0.5f) / static_cast<float>(n) - 0.5f;
      };
      visit((middle(x, across) * patch.right + middle(y, along) * patch.down) / size);
    }
  }
  return across * along;
}

/// The mean over such a patch of the bilinear texture.
glm::vec4 mean_of_points(const Texels& texels, glm::vec2 uv, const TexelPatch& patch,
                         const Texture& texture) {
  glm::vec4 sum(0.0f);
  const int count = for_each_point(
      patch, 1, glm::vec2(texels.width, texels.height),
      [&](glm::vec2 off) { sum += bilinear(texels, uv + off, texture.wrap_u, texture.wrap_v); });
  return sum / static_cast<float>(count);
}

/// The same patch of the finest level, in the next one.
LevelPatch coarser(const LevelPatch& patch, const MipChain& chain, const Texels& finest) {
  const MipLevel& texels = chain.front();
  const glm::vec2 scale(static_cast<float>(texels.width) / static_cast<float>(finest.width),
                        static_cast<float>(texels.height) / static_cast<float>(finest.height));
  return {1, bounded({less_of_texels(scale * patch.patch.right, 2.0f),
                      less_of_texels(scale * patch.patch.down, 2.0f)},
                     thinnest, TexelBudget().most)};
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
  return patch_in(chain, *image, filter, {size * (turn * steps.right), size * (turn * steps.down)},
                  TexelBudget::of(place.footprint.side));
}

/// A level of colours, each times what is seen of it, which comes last.
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

/// The mean of a level's texels; where alpha blends or cuts, the colour is that of what is seen,
/// for the rest has a colour, too.
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

/// A level of normals as moments: the mean and, last, the mean square, so that they may be mixed.
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

// Up to so many texels what is no mean of texels is looked at by points: between them lie no
// mixtures of their normals, nor of what alpha shows of them, but normals and colours of their own,
// which bend, so that one point is not their mean.
constexpr float longest_normals_by_points = 4.0f;
constexpr float longest_seen_by_points = 16.0f;

/// The mean colour of what is seen of a bilinear texture over such a patch, by points half a texel
/// apart, and the mean alpha; nothing is seen: the mean of all.
glm::vec4 mean_of_seen(const Texels& texels, const TexelUse& use, glm::vec2 uv,
                       const TexelPatch& patch, const Texture& texture) {
  glm::vec4 sum(0.0f), seen(0.0f);
  const int count =
      for_each_point(patch, 2, glm::vec2(texels.width, texels.height), [&](glm::vec2 off) {
        const glm::vec4 texel = bilinear(texels, uv + off, texture.wrap_u, texture.wrap_v);
        const float share = use.cutoff ? (texel.a >= *use.cutoff ? 1.0f : 0.0f) : texel.a;
        sum += texel;
        seen += share * glm::vec4(glm::vec3(texel), 1.0f);
      });
  const float alpha = sum.a / static_cast<float>(count);
  const glm::vec3 colour =
      seen.a > 0.0f ? glm::vec3(seen) / seen.a : glm::vec3(sum) / static_cast<float>(count);
  return {colour, alpha};
}

/// The mean of a bilinear map's unit normals over such a patch, by points half a texel apart, and
/// the variance about it.
MeanNormal mean_of_normals(const Texels& texels, glm::vec2 uv, const TexelPatch& patch,
                           const Texture& texture) {
  glm::vec3 sum(0.0f);
  const int count =
      for_each_point(patch, 2, glm::vec2(texels.width, texels.height), [&](glm::vec2 off) {
        sum += unit_normal(bilinear(texels, uv + off, texture.wrap_u, texture.wrap_v));
      });
  const glm::vec3 mean = sum / static_cast<float>(count);
  return {0.5f + 0.5f * mean, std::max(0.0f, 1.0f - glm::dot(mean, mean))};
}

/// The finest level's, each of length 1.
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
    // The next level knows what lies between the texels of this one.
    found = coarser(found, chain, finest);
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
