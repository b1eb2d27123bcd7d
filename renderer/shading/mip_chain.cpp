#include "renderer/shading/mip_chain.h"

#include <set>
#include <tbb/task_arena.h>
#include <utility>

namespace asos {
namespace {

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

MipChain::MipChain(Image image, TexelKind kind)
    : image_(std::move(image)), kind_(kind), size_(mip_levels_of(image_)) {}

void MipChain::make() const {
  const std::scoped_lock lock(making_);
  if (made_.load(std::memory_order_relaxed)) return;
  // In isolation, this thread takes no other task while it waits: such a task could need the lock.
  tbb::this_task_arena::isolate([&] { levels_ = make_mip_levels(image_, kind_); });
  made_.store(true, std::memory_order_release);
}

std::size_t MipChain::memory_bytes() const {
  if (!made_.load(std::memory_order_acquire)) return 0;
  std::size_t bytes = 0;
  for (const MipLevel& level : levels_) bytes += level.rgba.capacity() * sizeof(std::uint16_t);
  return bytes;
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
    if (chains_[i][k] && !chains_[i][k]->is_of(world.images[i])) chains_[i][k].reset();
    if (!chains_[i][k]) chains_[i][k] = std::make_shared<const MipChain>(world.images[i], kind);
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
      if (chain) bytes += chain->memory_bytes();
    }
  }
  return bytes;
}

}  // namespace asos
