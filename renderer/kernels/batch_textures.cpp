#include "renderer/kernels/batch_textures.h"

#include "renderer/shading/texture_filter.h"
#include "renderer/world/texture_image.h"

namespace asos {
namespace {

TexelPatch patch_at(const TextureBatch::Edges& edges, std::size_t i) {
  return {{edges.right_x[i], edges.right_y[i]}, {edges.down_x[i], edges.down_y[i]}};
}

void set_patch(TextureBatch::Edges& edges, std::size_t i, const TexelPatch& patch) {
  edges.right_x[i] = patch.right.x, edges.right_y[i] = patch.right.y;
  edges.down_x[i] = patch.down.x, edges.down_y[i] = patch.down.y;
}

glm::vec4 value_of(const MeanNormal& normal) {
  return {normal.texel, normal.variance};
}

/// Requests the texels at each point early. Those of large images are in no cache, and points wait
/// longer for them than for everything else.
void prefetch(const TextureBatch& places, const Image& image, const Texture& texture,
              const MipChain& chain) {
  constexpr std::size_t channels = 4;
  for (std::size_t i = 0; i < places.count; ++i) {
    const std::size_t level =
        places.level[i] > 0.0f ? static_cast<std::size_t>(places.level[i]) : 0;
    const TexelAxis u{side_of_level(image.width, level), texture.wrap_u};
    const TexelAxis v{side_of_level(image.height, level), texture.wrap_v};
    const int x = u.texel(static_cast<int>(floor_near(u.place(places.u[i]))));
    const int row = static_cast<int>(floor_near(v.place(places.v[i])));
    for (const int y : {v.texel(row), v.texel(row + 1)}) {
      if (level > 0) {
        __builtin_prefetch(chain[level - 1].texel(x, y));
      } else {
        const std::size_t texel = static_cast<std::size_t>(y) * static_cast<std::size_t>(u.size) +
                                  static_cast<std::size_t>(x);
        __builtin_prefetch(image.rgba.data() + channels * texel);
      }
    }
  }
}

/// Returns the mean of a level's texels by their weights.
template <typename Level>
Channels mean_by(const TexelWeights::Window& window, const Level& level, const Texture& texture,
                 glm::vec2 uv) {
  TexelSum<Level> sum(level, texture);
  const float* weight = window.weight;
  for (int r = 0; r < window.rows; ++r) {
    const int left = static_cast<int>(window.left[static_cast<std::size_t>(r) * window.stride]);
    for (int c = 0; c < window.columns; ++c, weight += window.stride)
      if (*weight > 0.0f) sum.add(left + c, window.top + r, *weight);
  }
  return sum.mean(uv);
}

}  // namespace

void BatchTextures::load_corners(int set) {
  if (set == set_) return;
  set_ = set;
  known_ = false;
  places_.count = points_.count;
  places_.b1 = points_.b1, places_.b2 = points_.b2;
  places_.footprint = points_.footprint;
  places_.side = points_.side, places_.colours = points_.colours;
  for (std::size_t i = 0; i < points_.count; ++i) {
    const CornerTexcoords at = corner_texcoords(*world_, set, points_.triangle[i]);
    places_.u_0[i] = at.at_0.x, places_.v_0[i] = at.at_0.y;
    places_.u_1[i] = at.at_1.x, places_.v_1[i] = at.at_1.y;
    places_.u_2[i] = at.at_2.x, places_.v_2[i] = at.at_2.y;
  }
}

void BatchTextures::find_patches(const Source& from) {
  load_corners(from.use.texcoord);
  const int set = from.use.texcoord;
  const bool has_coordinates = set >= 0 && set <= 1 && !world_->texcoords[set].empty();
  TextureGrid grid;
  grid.width = from.image.width, grid.height = from.image.height;
  grid.levels = has_coordinates ? from.chain.size() : 0;
  grid.wrap_u = from.texture.wrap_u, grid.wrap_v = from.texture.wrap_v;
  grid.filter = from.texture.filter;
  grid.uv_transform = from.use.uv_transform;
  grid.widened = from.kind == TexelKind::color;
  if (known_ && grid == grid_) return;
  grid_ = grid;
  known_ = true;
  find_texture_patches(grid_, places_);
}

glm::vec4 BatchTextures::alone(const Source& from, std::size_t i) const {
  Footprint footprint;
  const TexelPatch edges = patch_at(points_.footprint, i);
  footprint.right = edges.right, footprint.down = edges.down;
  footprint.side = points_.side[i], footprint.colours = points_.colours[i];
  if (from.kind == TexelKind::color) footprint = of_colours(footprint);
  const TexturePlace place{points_.triangle[i], points_.b1[i], points_.b2[i], footprint};
  return from.kind == TexelKind::normal
             ? value_of(filtered_normal(*world_, *mips_, from.use, place))
             : filtered_texture(*world_, *mips_, from.use, {from.kind, cutoff(i)}, place);
}

std::optional<glm::vec4> BatchTextures::without_weights(const Source& from, std::size_t i) {
  const bool normal = from.kind == TexelKind::normal, cover = from.kind == TexelKind::cover;
  if (places_.level[i] < 0.0f) {
    const glm::vec2 at = uv(i);
    const glm::vec4 texel =
        from.texture.filter == Filter::nearest
            ? nearest(from.texels, at, from.texture.wrap_u, from.texture.wrap_v)
            : bilinear(from.texels, at, from.texture.wrap_u, from.texture.wrap_v);
    return normal ? glm::vec4(glm::vec3(texel), 0.0f) : texel;
  }
  LevelPatch found{static_cast<std::size_t>(places_.level[i]), patch_at(places_.patch, i)};
  if (found.level == 0) {
    if (from.texture.filter == Filter::nearest) return alone(from, i);
    const float longest = found.patch.longest();
    if (normal) {
      if (longest <= longest_normals_by_points)
        return value_of(mean_of_normals(from.texels, uv(i), found.patch, from.texture));
      found = coarser(found, from.texels);
    } else if (cover && longest <= longest_seen_by_points) {
      return mean_of_seen(from.texels, cutoff(i), uv(i), found.patch, from.texture);
    } else if (!cover && is_by_points(found.patch)) {
      return mean_of_points(from.texels, uv(i), found.patch, from.texture);
    }
  }
  // This form of the comparison is false for NaN.
  if (!(found.patch.longest() <= longest_in_lanes)) return alone(from, i);
  const std::size_t task = patches_.count++;
  tasks_[task] = {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(found.level)};
  patches_.u[task] = places_.u[i], patches_.v[task] = places_.v[i];
  patches_.width[task] = static_cast<float>(side_of_level(from.image.width, found.level));
  patches_.height[task] = static_cast<float>(side_of_level(from.image.height, found.level));
  set_patch(patches_.patch, task, found.patch);
  return std::nullopt;
}

glm::vec4 BatchTextures::weighted(const Source& from, std::size_t task) const {
  const auto [i, level] = tasks_[task];
  const TexelWeights::Window window = weights_.window(task);
  const glm::vec2 at = uv(i);
  const auto mean = [&](const auto& shown) { return mean_by(window, shown, from.texture, at); };
  if (level == 0) return mean_of_texels(ImageLevel{from.texels}, from.kind, cutoff(i), mean);
  const ChainLevel texels{from.chain[level - 1]};
  if (from.kind == TexelKind::normal) return value_of(mean_normal(mean(NormalMoments{texels})));
  return mean_of_texels(texels, from.kind, cutoff(i), mean);
}

void BatchTextures::look_up(const TextureUse& use, TexelKind kind, std::span<glm::vec4> found) {
  static const MipChain none;
  const Image* image = image_of(*world_, use.texture);
  if (!image) {
    const float last = kind == TexelKind::normal ? 0.0f : 1.0f;
    std::fill_n(found.begin(), points_.count, glm::vec4(1.0f, 1.0f, 1.0f, last));
    return;
  }
  const bool linear = kind == TexelKind::data || kind == TexelKind::normal;
  const Texture& texture = world_->textures[static_cast<std::size_t>(use.texture)];
  const Source from{use,
                    kind,
                    *image,
                    texture,
                    mips_ ? mips_->chain(texture.image, kind) : none,
                    Texels(*image, linear ? Encoding::linear : Encoding::srgb)};
  find_patches(from);
  prefetch(places_, from.image, from.texture, from.chain);
  patches_.count = 0;
  for (std::size_t i = 0; i < points_.count; ++i)
    if (const auto value = without_weights(from, i)) found[i] = *value;
  if (patches_.count == 0) return;
  find_texel_weights(grid_, patches_, weights_);
  for (std::size_t k = 0; k < patches_.count; ++k) found[tasks_[k].point] = weighted(from, k);
}

}  // namespace asos
