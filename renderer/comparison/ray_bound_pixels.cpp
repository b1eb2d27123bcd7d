#include "renderer/comparison/ray_bound_pixels.h"

#include "renderer/comparison/method.h"
#include "renderer/pyray/detection.h"
#include "renderer/pyray/hit_list.h"
#include "renderer/rays/surface_kind.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

namespace asos {
namespace {

constexpr float pixel_side = 1.0f / static_cast<float>(block_size);
constexpr std::size_t sizes = 4;  // of ray bounds: 1, 2, 4 and 8 pixels
static_assert(1 << (sizes - 1) == block_size);

class RayBounds {
 public:
  RayBounds(const RenderScene& scene, const View& view, PixelRect block,
            std::span<const Hit> centres)
      : scene_(scene),
        block_(block),
        centres_(centres),
        frame_(view.frame(block.x, block.y, block_size, block_size)),
        detector_(frame_),
        bounded_(centres.size(), 0) {
    // Many boundaries in one pixel need not be told apart.
    lists_.reset(scene.features, frame_, pixel_side);
  }

  std::vector<std::uint8_t> find() {
    descend({0.0f, 0.0f, 1.0f}, 0, 0, block_size, lists_.root());
    return std::move(bounded_);
  }

 private:
  // Looks for boundaries around the size x size pixels from (x, y) among those of a larger bound.
  void descend(const Square& square, int x, int y, int size, const HitLists::List& parent) {
    if (x >= block_.width || y >= block_.height) return;
    const HidingPlane hiding =
        HidingPlane::of(cover(x + size / 2, y + size / 2), frame_, square.side);
    HitLists::List& list =
        list_of_size_[static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(size)))];
    lists_.refine(square, hiding, parent, list, true);
    std::erase_if(list, [&](std::uint32_t i) {
      return lists_.entry(i).is_segment() && !detector_.near(lists_.segment(i), square);
    });
    if (std::all_of(list.begin(), list.end(),
                    [&](std::uint32_t i) { return lists_.hidden(i, square, hiding); }))
      return;
    if (size == 1) {
      bounded_[index(x, y)] = 1;
      return;
    }
    const int half = size / 2;
    for (int i = 0; i < 4; ++i)
      descend(square.quarter(i), x + (i & 1) * half, y + (i >> 1) * half, half, list);
  }

  // The plane of the surface in a pixel's middle, where nothing is seen through it.
  [[nodiscard]] Cover cover(int x, int y) const {
    if (x >= block_.width || y >= block_.height) return Cover::none();
    const Hit& hit = centres_[index(x, y)];
    if (!hit.valid()) return Cover::none();
    const World& world = scene_.world;
    if (surface_kind(world.material_of(hit.triangle)) != SurfaceKind::opaque) return Cover::none();
    return cover_of(frame_, world, scene_.features, hit);
  }

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y * block_.width + x);
  }

  const RenderScene& scene_;
  PixelRect block_;
  std::span<const Hit> centres_;
  Frame frame_;
  Detector detector_;
  HitLists lists_;
  std::array<HitLists::List, sizes> list_of_size_;
  std::vector<std::uint8_t> bounded_;
};

}  // namespace

std::vector<std::uint8_t> pixels_with_boundaries(const RenderScene& scene, const View& view,
                                                 PixelRect block, std::span<const Hit> centres) {
  return RayBounds(scene, view, block, centres).find();
}

}  // namespace asos
