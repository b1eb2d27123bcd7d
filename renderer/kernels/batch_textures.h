#pragma once

#include "renderer/kernels/texture_kernel.h"
#include "renderer/shading/mip_chain.h"
#include "renderer/shading/texel_means.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace asos {

/// Looks up textures at the points of a batch, with the bits of filtered_texture and
/// filtered_normal: patches and weights in lanes, texels by channels. Nearest texels are filtered
/// one by one, and so are patches longer than longest_in_lanes.
class BatchTextures {
 public:
  /// The points, to be filled before the first look-up.
  struct Points {
    std::size_t count = 0;
    std::array<std::uint32_t, ShadingPoints::size> triangle;
    TextureBatch::Floats b1, b2;
    TextureBatch::Edges footprint;
    TextureBatch::Floats side;
    TextureBatch::Floats colours;
    bool masked = false;          ///< colours have a cut-off
    TextureBatch::Floats cutoff;  ///< as in TexelUse
  };
  [[nodiscard]] Points& points() { return points_; }
  /// Begins with other points.
  void start(const World& world, const MipChains* mips) {
    world_ = &world, mips_ = mips;
    set_ = no_set;
  }
  /// Returns the mean at each point; for a map, MeanNormal::texel and, last, its variance. `found`
  /// has room for all points.
  void look_up(const TextureUse& use, TexelKind kind, std::span<glm::vec4> found);

 private:
  static constexpr int no_set = -100;

  /// A texture that is looked up.
  struct Source {
    const TextureUse& use;
    TexelKind kind;
    const Image& image;
    const Texture& texture;
    const MipChain& chain;
    Texels texels;
  };
  void find_patches(const Source& from);
  void load_corners(int set);
  [[nodiscard]] std::optional<float> cutoff(std::size_t i) const {
    return points_.masked ? std::optional(points_.cutoff[i]) : std::nullopt;
  }
  [[nodiscard]] glm::vec2 uv(std::size_t i) const { return {places_.u[i], places_.v[i]}; }
  [[nodiscard]] glm::vec4 alone(const Source& from, std::size_t i) const;
  /// Returns the value at point i, or nothing if its patch needs weights, which it adds.
  [[nodiscard]] std::optional<glm::vec4> without_weights(const Source& from, std::size_t i);
  [[nodiscard]] glm::vec4 weighted(const Source& from, std::size_t task) const;

  const World* world_ = nullptr;
  const MipChains* mips_ = nullptr;
  Points points_;
  TextureBatch places_;
  int set_ = no_set;    // of texture coordinates in places_
  TextureGrid grid_;    // of the patches in places_
  bool known_ = false;  // whether there are any
  PatchBatch patches_;
  struct Task {
    std::uint32_t point, level;
  };
  std::array<Task, ShadingPoints::size> tasks_;
  TexelWeights weights_;
};

}  // namespace asos
