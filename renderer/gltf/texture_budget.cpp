#include "renderer/gltf/texture_budget.h"

#include "renderer/gltf/pictures/picture.h"

#include <algorithm>
#include <cstddef>

namespace asos::gltf {

namespace {

// A texel takes 4 bytes and its mip levels 3 to 8, so a file of a few bytes takes up to 200 MB.
// JPEG and WebP need about one bit per pixel for detailed pictures.
constexpr std::uint64_t free_texels = std::uint64_t{1} << 24;
constexpr std::uint64_t texels_per_byte = 8;
constexpr int most_shrink = 4096;

std::uint64_t texels_of(const DecodedImageSize& claim, int shrink) {
  return static_cast<std::uint64_t>(shrunk(claim.width, shrink)) *
         static_cast<std::uint64_t>(shrunk(claim.height, shrink));
}

/// Returns a limit for the number of texels per picture, chosen so that all pictures together fit
/// `most`. Smaller pictures keep their size.
std::uint64_t fair_share(std::vector<std::uint64_t> texels, std::uint64_t most) {
  std::sort(texels.begin(), texels.end());
  std::uint64_t left = most, share = most;
  for (std::size_t i = 0; i < texels.size(); ++i) {
    share = left / (texels.size() - i);
    if (texels[i] > share) break;
    left -= texels[i];
  }
  return share;
}

}  // namespace

std::uint64_t most_texels(std::uint64_t picture_bytes) {
  return free_texels + texels_per_byte * picture_bytes;
}

std::vector<int> shrinks_of(std::span<const DecodedImageSize> claims) {
  std::vector<std::uint64_t> texels;
  std::uint64_t bytes = 0, all = 0;
  for (const DecodedImageSize& claim : claims) {
    texels.push_back(texels_of(claim, 1));
    all += texels.back();
    bytes += claim.bytes;
  }
  std::vector<int> shrinks(claims.size(), 1);
  if (all <= most_texels(bytes)) return shrinks;
  const std::uint64_t share = fair_share(std::move(texels), most_texels(bytes));
  for (std::size_t i = 0; i < claims.size(); ++i)
    while (texels_of(claims[i], shrinks[i]) > share && shrinks[i] < most_shrink) shrinks[i] *= 2;
  return shrinks;
}

}  // namespace asos::gltf
