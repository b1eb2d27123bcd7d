#include "renderer/shading/texture_filter.h"

#include "renderer/scene/scene.h"
#include "renderer/shading/bilinear.h"
#include "renderer/shading/level_patch.h"
#include "renderer/shading/texel_means.h"
#include "renderer/shading/texel_window.h"
#include "renderer/shading/texture.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace asos {
namespace {

/// The integral of a texture of nearest texels over a parallelogram: the area of each texel inside
/// it. It is exact, but slower than a TexelWindow, which is exact only along the texels' rows.
class TexelAreas {
 public:
  /// `centre` is in texels, with texel centres at whole numbers.
  TexelAreas(glm::vec2 centre, const TexelPatch& patch) {
    const glm::vec2 r = 0.5f * patch.right, d = 0.5f * patch.down;
    for (const glm::vec2 corner : {centre - r - d, centre + r - d, centre + r + d, centre - r + d})
      all_.add(corner);
  }

  /// Calls visit(x, y, area) for every texel with an area, row by row. Indices are not wrapped.
  template <typename Visit>
  void for_each(const Visit& visit) const {
    for_each_part(all_, 1, [&](int y, const Polygon& row) {
      for_each_part(row, 0, [&](int x, const Polygon& part) {
        const float area = part.area();
        if (area > 0.0f) visit(x, y, area);
      });
    });
  }

 private:
  /// A convex polygon: a parallelogram cut by four lines.
  struct Polygon {
    std::array<glm::vec2, 8> corners{};
    std::size_t count = 0;

    void add(glm::vec2 corner) { corners[count++] = corner; }
    [[nodiscard]] float area() const {
      float twice = 0.0f;
      for (std::size_t i = 2; i < count; ++i) {
        const glm::vec2 p = corners[i - 1] - corners[0], q = corners[i] - corners[0];
        twice += p.x * q.y - p.y * q.x;
      }
      return 0.5f * std::abs(twice);
    }
    /// Returns the part where `sign` times a coordinate is at least `sign` times `bound`.
    [[nodiscard]] Polygon beyond(int axis, float bound, float sign) const {
      Polygon part;
      for (std::size_t i = 0; i < count; ++i) {
        const glm::vec2 from = corners[i], to = corners[i + 1 < count ? i + 1 : 0];
        const float a = sign * (from[axis] - bound), b = sign * (to[axis] - bound);
        if (a >= 0.0f) part.add(from);
        if ((a >= 0.0f) != (b >= 0.0f)) part.add(from + a / (a - b) * (to - from));
      }
      return part;
    }
  };

  // Cuts a polygon at the borders of texels along an axis.
  template <typename Visit>
  static void for_each_part(const Polygon& all, int axis, const Visit& visit) {
    if (all.count < 3) return;
    float lo = all.corners[0][axis], hi = lo;
    for (std::size_t i = 1; i < std::min(all.count, all.corners.size()); ++i) {
      lo = std::min(lo, all.corners[i][axis]);
      hi = std::max(hi, all.corners[i][axis]);
    }
    const int first = static_cast<int>(floor_near(lo + 0.5f));
    const int last = static_cast<int>(floor_near(hi + 0.5f));
    Polygon rest = all;
    for (int i = first; i < last; ++i) {
      const float end = static_cast<float>(i) + 0.5f;
      visit(i, rest.beyond(axis, end, -1.0f));
      rest = rest.beyond(axis, end, 1.0f);
    }
    visit(last, rest);
  }

  Polygon all_;
};

// Patches of nearest texels up to this size, in texels, are integrated exactly. In larger ones the
// exact areas cost more than they improve.
constexpr float longest_in_areas = 8.0f;

/// Returns the mean of a level's texels over a patch around `uv`.
template <typename Level>
Channels mean_of(const Level& level, glm::vec2 uv, const TexelPatch& patch, TexelShape shape,
                 const Texture& texture) {
  const TexelAxis u{level.width, texture.wrap_u}, v{level.height, texture.wrap_v};
  const glm::vec2 centre(u.place(uv.x), v.place(uv.y));
  TexelSum<Level> sum(level, texture);
  const auto add = [&](int x, int y, float share) { sum.add(x, y, share); };
  if (shape == TexelShape::box && patch.longest() <= longest_in_areas && is_aslant(patch)) {
    TexelAreas(centre, patch).for_each(add);
  } else {
    TexelWindow(centre, patch, shape).for_each(add);
  }
  return sum.mean(uv);
}

/// Returns whether a patch lies within a single nearest texel, as most small ones do.
bool in_one_texel(const Image& image, glm::vec2 uv, const TexelPatch& patch,
                  const Texture& texture) {
  const glm::vec2 half = 0.5f * (glm::abs(patch.right) + glm::abs(patch.down));
  const auto in_one = [](float place, float reach) {
    return floor_near(place - reach + 0.5f) == floor_near(place + reach + 0.5f);
  };
  return in_one(TexelAxis{image.width, texture.wrap_u}.place(uv.x), half.x) &&
         in_one(TexelAxis{image.height, texture.wrap_v}.place(uv.y), half.y);
}

TexelShape shape_of(const Texture& texture, std::size_t level) {
  return level == 0 && texture.filter == Filter::nearest ? TexelShape::box : TexelShape::tent;
}

glm::vec2 lookup_uv(const World& world, const TextureUse& use, const TexturePlace& place) {
  const glm::vec2 middle = glm::vec2(place.b1, place.b2) + place.footprint.offset;
  const glm::vec2 uv = texcoord_at(world, use.texcoord, place.triangle, middle.x, middle.y);
  return {use.uv_transform * glm::vec3(uv, 1.0f)};
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

/// Returns the mean of a level's colours or data.
template <typename Level>
glm::vec4 mean_of(const Level& level, const TexelUse& texels, glm::vec2 uv, const TexelPatch& patch,
                  TexelShape shape, const Texture& texture) {
  return mean_of_texels(level, texels.kind, texels.cutoff, [&](const auto& shown) {
    return mean_of(shown, uv, patch, shape, texture);
  });
}

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
    return mean_of(ChainLevel{chain[found.level - 1]}, texels, uv, found.patch, shape, texture);
  const Texels finest(*image_of(world, use.texture), encoding);
  const bool tents = shape == TexelShape::tent;
  if (tents && texels.kind == TexelKind::cover && found.patch.longest() <= longest_seen_by_points)
    return mean_of_seen(finest, texels.cutoff, uv, found.patch, texture);
  if (tents && texels.kind != TexelKind::cover && is_by_points(found.patch))
    return mean_of_points(finest, uv, found.patch, texture);
  return mean_of(ImageLevel{finest}, texels, uv, found.patch, shape, texture);
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
  const Channels moments =
      found.level > 0
          ? mean_of(NormalMoments{{chain[found.level - 1]}}, uv, found.patch, shape, texture)
          : mean_of(UnitNormals{Texels(*image_of(world, use.texture), Encoding::linear)}, uv,
                    found.patch, shape, texture);
  return mean_normal(moments);
}

}  // namespace asos
