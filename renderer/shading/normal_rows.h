#pragma once

#include "renderer/scene/scene.h"
#include "renderer/shading/texture.h"

#include <array>
#include <cstddef>
#include <vector>

namespace asos {

/// Rows of a normal map's texels: the mean over each texel of the unit normals of a bilinear
/// look-up. At borders it clamps; a wrapping texture differs only at its very edge.
class NormalRows {
 public:
  explicit NormalRows(const Image& image);

  /// Returns the means and variances of a row of texels, as in MipLevel::at. They remain until four
  /// other rows are read.
  [[nodiscard]] const float* row(int y);

 private:
  /// Three components, each with a row of values.
  using Vectors = std::array<std::vector<float>, 3>;
  template <typename Values>
  struct KnownRow {
    int y = -1;
    Values values;
  };

  const Vectors& map(int y);
  void find_means(int y);
  void refine_bent(const Vectors& above, const Vectors& here, const Vectors& below);

  Texels texels_;
  std::size_t width_;
  std::array<KnownRow<Vectors>, 4> maps_;             // with one more texel at either end
  std::array<KnownRow<std::vector<float>>, 4> rows_;  // the results
  Vectors between_, means_;                           // of the row that is being made
  std::vector<float> bend_;                           // of each texel, see find_bend
  std::vector<std::size_t> bent_;
};

}  // namespace asos
