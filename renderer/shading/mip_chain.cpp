#include "renderer/shading/mip_chain.h"

#include "renderer/shading/bilinear.h"
#include "renderer/shading/texture.h"
#include "renderer/tasks.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace asos {
namespace {

/// Returns the k-th of n x n places that cover a texel evenly.
glm::vec2 place_in_texel(const Texels& texels, int x, int y, int k, int n) {
  const glm::vec2 in_texel = (glm::vec2(k % n, k / n) + 0.5f) / static_cast<float>(n);
  return (glm::vec2(x, y) + in_texel) / glm::vec2(texels.width, texels.height);
}

/// Returns the mean of the unit normals at n x n places in a texel. At borders it clamps; a
/// wrapping texture differs only at its very edge.
glm::vec3 mean_normal(const Texels& texels, int x, int y, int n) {
  glm::vec3 sum(0.0f);
  for (int k = 0; k < n * n; ++k) {
    sum += unit_normal(bilinear(texels, place_in_texel(texels, x, y, k, n), Wrap::clamp_to_edge,
                                Wrap::clamp_to_edge));
  }
  return sum / static_cast<float>(n * n);
}

/// Returns mean and variance of the normals within a texel of a normal map. Places between texels
/// have unit normals, not mixtures of the texels' normals.
glm::vec4 normals_of_texel(const Image& image, int x, int y) {
  constexpr int few = 2, many = 4;
  // Cosine to the texel's own normal above which normals count as equal.
  constexpr float even = 1.0f - 1e-3f;
  const Texels texels(image, Encoding::linear);
  glm::vec3 mean = mean_normal(texels, x, y, few);
  if (glm::dot(mean, unit_normal(texels.at(x, y))) < even) mean = mean_normal(texels, x, y, many);
  return {0.5f + 0.5f * mean, std::max(0.0f, 1.0f - glm::dot(mean, mean))};
}

glm::vec4 first_level_texel(const Image& image, TexelKind kind, int x, int y) {
  if (!image.low.empty() && kind != TexelKind::normal) {
    const Encoding encoding = kind == TexelKind::data ? Encoding::linear : Encoding::srgb;
    return Texels(image, encoding).at(x, y);
  }
  const std::uint8_t* p =
      image.rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                               static_cast<std::size_t>(x));
  const glm::vec4 bytes = glm::vec4(p[0], p[1], p[2], p[3]) * (1.0f / 255.0f);
  switch (kind) {
    case TexelKind::color:
    case TexelKind::cover:
      return {srgb_byte_to_linear(p[0]), srgb_byte_to_linear(p[1]), srgb_byte_to_linear(p[2]),
              bytes.a};
    case TexelKind::data:
      break;
    case TexelKind::normal:
      return normals_of_texel(image, x, y);
  }
  return bytes;
}

/// The weighted mean of texels, according to their kind; the weights are fractions of a box.
class Mean {
 public:
  explicit Mean(TexelKind kind) : kind_(kind) {}

  void add(glm::vec4 texel, float share) {
    weight_ += share;
    sum_ += share * texel;
    if (kind_ == TexelKind::cover) colour_ += share * texel.a * glm::vec3(texel);
    if (kind_ != TexelKind::normal) return;
    const glm::vec3 n = 2.0f * glm::vec3(texel) - 1.0f;
    second_moment_ += share * (texel.a + glm::dot(n, n));
  }

  [[nodiscard]] glm::vec4 value() const {
    glm::vec4 mean = sum_ / weight_;
    if (kind_ == TexelKind::cover && sum_.a > 0.0f) mean = glm::vec4(colour_ / sum_.a, mean.a);
    if (kind_ == TexelKind::normal) {
      const glm::vec3 n = 2.0f * glm::vec3(mean) - 1.0f;
      mean.a = second_moment_ / weight_ - glm::dot(n, n);
    }
    return mean;
  }

 private:
  TexelKind kind_;
  float weight_ = 0.0f;
  glm::vec4 sum_{0.0f};
  glm::vec3 colour_{0.0f};
  float second_moment_ = 0.0f;
};

/// The texels of a row of `from` that fall into texel `i` of a row of `to`, with their fractions.
/// There are up to three, since an odd size is halved and rounded down.
struct TexelSpan {
  int first;
  int last;
  double lo;
  double hi;

  TexelSpan(int i, int from, int to)
      : lo(static_cast<double>(i) * from / to), hi(static_cast<double>(i + 1) * from / to) {
    first = static_cast<int>(lo);
    last = std::min(from - 1, static_cast<int>(std::ceil(hi)) - 1);
  }
  [[nodiscard]] float share(int texel) const {
    return static_cast<float>(std::min(hi, texel + 1.0) - std::max(lo, static_cast<double>(texel)));
  }
};

template <typename TexelAt>
MipLevel halved(int width, int height, TexelKind kind, const TexelAt& texel) {
  MipLevel level;
  level.width = std::max(1, width / 2);
  level.height = std::max(1, height / 2);
  level.rgba.resize(4 * static_cast<std::size_t>(level.width) *
                    static_cast<std::size_t>(level.height));
  in_tasks(static_cast<std::size_t>(level.height), [&](std::size_t row) {
    const auto y = static_cast<int>(row);
    const TexelSpan rows(y, height, level.height);
    std::uint16_t* out =
        level.rgba.data() + 4 * static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width);
    for (int x = 0; x < level.width; ++x) {
      const TexelSpan columns(x, width, level.width);
      Mean mean(kind);
      for (int v = rows.first; v <= rows.last; ++v)
        for (int u = columns.first; u <= columns.last; ++u)
          mean.add(texel(u, v), rows.share(v) * columns.share(u));
      const glm::vec4 value = glm::clamp(mean.value(), 0.0f, 1.0f);
      for (int k = 0; k < 4; ++k) *out++ = static_cast<std::uint16_t>(value[k] * 65535.0f + 0.5f);
    }
  });
  return level;
}

using ImageUse = std::pair<int, TexelKind>;

void add_use(std::set<ImageUse>& uses, const World& world, const TextureUse& use, TexelKind kind) {
  if (!use.used() || static_cast<std::size_t>(use.texture) >= world.textures.size()) return;
  const int image = world.textures[static_cast<std::size_t>(use.texture)].image;
  if (image >= 0 && static_cast<std::size_t>(image) < world.images.size())
    uses.emplace(image, kind);
}

void add_uses(std::set<ImageUse>& uses, const World& world, const RenderFeatures& render_features,
              const Material& m) {
  add_use(uses, world, m.base_color_texture, base_color_kind(m));
  if (m.unlit) {
    if (m.stroke && render_features.emission)
      add_use(uses, world, m.emissive_texture, emissive_kind(m));
    return;
  }
  for (const TextureUse* use :
       {&m.metallic_roughness_texture, &m.occlusion_texture, &m.specular_texture,
        &m.transmission_texture, &m.coat.texture, &m.coat.roughness_texture,
        &m.sheen.roughness_texture, &m.film.texture, &m.film.thickness_texture,
        &m.diffuse_transmission.texture})
    add_use(uses, world, *use, TexelKind::data);
  add_use(uses, world, m.specular_color_texture, TexelKind::color);
  add_use(uses, world, m.sheen.color_texture, TexelKind::color);
  add_use(uses, world, m.diffuse_transmission.color_texture, TexelKind::color);
  if (render_features.normal_maps) {
    add_use(uses, world, m.normal_texture, TexelKind::normal);
    add_use(uses, world, m.coat.normal_texture, TexelKind::normal);
  }
  if (render_features.emission) add_use(uses, world, m.emissive_texture, emissive_kind(m));
}

}  // namespace

TexelKind base_color_kind(const Material& material) {
  const bool covers_all = material.alpha_mode == AlphaMode::opaque ||
                          (material.alpha_mode == AlphaMode::mask && material.alpha_cutoff <= 0.0f);
  return covers_all ? TexelKind::color : TexelKind::cover;
}

TexelKind emissive_kind(const Material& material) {
  const bool covers = material.emissive_texture.same_place(material.base_color_texture);
  return covers ? base_color_kind(material) : TexelKind::color;
}

MipChain make_mip_chain(const Image& image, TexelKind kind) {
  MipChain chain;
  if (image.width <= 0 || image.height <= 0 || image.rgba.empty()) return chain;
  if (image.width == 1 && image.height == 1) return chain;
  chain.push_back(halved(image.width, image.height, kind,
                         [&](int x, int y) { return first_level_texel(image, kind, x, y); }));
  while (chain.back().width > 1 || chain.back().height > 1) {
    const MipLevel& finer = chain.back();
    MipLevel coarser =
        halved(finer.width, finer.height, kind, [&](int x, int y) { return finer.at(x, y); });
    chain.push_back(std::move(coarser));
  }
  return chain;
}

MipChains::MipChains(const World& world, const RenderFeatures& render_features,
                     const MipChains* known) {
  if (!render_features.mip_chains) return;
  std::set<ImageUse> uses;
  for (const Part& part : world.parts) {
    if (!part.shows_nothing())
      add_uses(uses, world, render_features, world.materials[part.material]);
  }
  chains_.resize(world.images.size());
  for (const auto& [image, kind] : uses) {
    const auto i = static_cast<std::size_t>(image), k = static_cast<std::size_t>(kind);
    if (known && i < known->chains_.size()) chains_[i][k] = known->chains_[i][k];
    if (!chains_[i][k])
      chains_[i][k] = std::make_shared<const MipChain>(make_mip_chain(world.images[i], kind));
  }
}

const MipChain& MipChains::chain(int image, TexelKind kind) const {
  static const MipChain none;
  const auto i = static_cast<std::size_t>(image);
  if (i >= chains_.size()) return none;
  const Shared& chain = chains_[i][static_cast<std::size_t>(kind)];
  return chain ? *chain : none;
}

std::size_t MipChains::memory_bytes() const {
  std::size_t bytes = chains_.capacity() * sizeof(chains_[0]);
  for (const auto& kinds : chains_) {
    for (const Shared& chain : kinds) {
      if (!chain) continue;
      for (const MipLevel& level : *chain) bytes += level.rgba.capacity() * sizeof(std::uint16_t);
    }
  }
  return bytes;
}

}  // namespace asos
