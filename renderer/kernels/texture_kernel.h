#pragma once

#include "renderer/kernels/shading_points.h"
#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// The parts of a texture, and of a material's use of it, that determine its footprints.
struct TextureGrid {
  int width = 1;
  int height = 1;
  std::size_t levels = 0;  ///< of its mip chain; 0: all places are points
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
  Filter filter = Filter::linear;
  glm::mat3 uv_transform{1.0f};
  bool widened = false;  ///< footprints are those of colours, as of_colours returns them

  bool operator==(const TextureGrid&) const = default;
};

/// Places of a batch on a texture, and patches of its texels. Lanes beyond `count` are undefined.
struct TextureBatch {
  using Floats = ShadingPoints::Floats;
  struct Edges {
    Floats right_x{}, right_y{}, down_x{}, down_y{};
  };

  std::size_t count = 0;
  Floats u_0{}, v_0{}, u_1{}, v_1{}, u_2{}, v_2{};  ///< coordinates of a triangle's corners
  Floats b1{}, b2{};
  Edges footprint;  ///< x and y are the changes of b1 and b2, as in Footprint
  Floats side{};
  Floats colours{};  ///< factor of the footprint for colours
  Floats u{}, v{};   ///< output: transformed coordinates
  Floats level{};    ///< output: as in LevelPatch; -1: a point
  Edges patch;       ///< output: in texels of the level
};

/// Computes the coordinates and the patches of a batch. The bits are those of patch_in, whatever
/// the instruction set.
void find_texture_patches(const TextureGrid& texture, TextureBatch& batch);

/// Patches in levels of a texture whose texels are interpolated.
struct PatchBatch {
  std::size_t count = 0;
  TextureBatch::Floats u{}, v{};
  TextureBatch::Floats width{}, height{};  ///< of the level
  TextureBatch::Edges patch;
};

/// Weights of texels over patches: as a TexelWindow visits them, row by row.
class TexelWeights {
 public:
  /// The texels of one patch; steps in the arrays are `stride` apart.
  struct Window {
    int rows = 0;
    int columns = 0;      ///< most texels of a row; weights of others are not above 0
    int top = 0;          ///< y of the first row
    const float* left;    ///< x of each row's first texel
    const float* weight;  ///< row by row
    std::size_t stride = 1;
  };
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] Window window(std::size_t i) const {
    const Group& group = groups_[i / lanes_];
    const float* at = &values_[group.first] + i % lanes_;
    return {group.rows,
            group.columns,
            static_cast<int>(at[0]),
            at + lanes_,
            at + lanes_ * static_cast<std::size_t>(1 + group.rows),
            lanes_};
  }

  /// For the kernel: begins anew, with so many patches in a group.
  void clear(std::size_t lanes, std::size_t count) {
    lanes_ = lanes, count_ = count;
    groups_.clear();
    values_.clear();
  }
  /// Adds a group: `lanes` values for the first row, for each row's first texel, and for each
  /// texel.
  [[nodiscard]] float* add_group(int rows, int columns) {
    const std::size_t first = values_.size();
    groups_.push_back({rows, columns, first});
    values_.resize(first + lanes_ * static_cast<std::size_t>(1 + rows + rows * columns));
    return &values_[first];
  }

 private:
  struct Group {
    int rows, columns;
    std::size_t first;
  };
  std::size_t lanes_ = 1, count_ = 0;
  std::vector<Group> groups_;
  std::vector<float> values_;
};

/// Longest edge, in texels, of a patch for find_texel_weights.
inline constexpr float longest_in_lanes = 8.0f;

/// Computes the weights of patches whose edges are at most longest_in_lanes. The bits are those of
/// TexelWindow, whatever the instruction set.
void find_texel_weights(const TextureGrid& texture, const PatchBatch& patches,
                        TexelWeights& weights);

}  // namespace asos
