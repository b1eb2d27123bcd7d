#include "renderer/methods/eye_caster.h"
#include "renderer/methods/method.h"
#include "renderer/pyray/hit_list.h"
#include "renderer/pyray/safety_net.h"
#include "renderer/pyray/subdivide.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <span>
#include <vector>

// Adaptive supersampling in object space: a block of pixels is one fat pyray (CGF'98 section 6.4)
// that fetches its boundaries once and hands them down to its pixels, which subdivide.

namespace asos {
namespace {

constexpr int pixels_in_block = block_size * block_size;

std::uint64_t pixel_seed(int x, int y) {
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32 |
          static_cast<std::uint32_t>(y)) *
         0x9e3779b97f4a7c15ULL;
}

// Memory that is worth keeping from one block to the next. Holds no result.
struct Workspace {
  HitLists lists;
  Subdivider subdivider;
  std::array<HitLists::List, 4> descent;  // one for each size of fat pyray: 8, 4, 2, 1 pixels
  std::array<HitLists::List, pixels_in_block> pixel_list;
  HitLists::List scratch;
  std::vector<Root> bounded;
};

class BlockRenderer {
 public:
  BlockRenderer(const RenderScene& scene, const View& view, const RenderSettings& settings,
                PixelRect block, const std::stop_token& stop, Workspace& work)
      : scene_(scene),
        settings_(settings),
        block_(block),
        work_(work),
        frame_(view.frame(block.x, block.y, block_size, block_size)),
        caster_(scene, view, frame_, {block.x, block.y, block_size, block_size}, pixels_in_block,
                stop, result_.statistics) {}

  BlockResult run() {
    look_through_centres();
    const float finest = pixel_side / static_cast<float>(1 << settings_.max_level);
    work_.lists.reset(scene_.features, frame_, finest);
    descend({0.0f, 0.0f, 1.0f}, 0, 0, block_size, work_.lists.root());
    find_missed_splits();
    render_pixels();
    return std::move(result_);
  }

 private:
  static constexpr float pixel_side = 1.0f / block_size;

  static std::uint32_t index(int x, int y) {
    return static_cast<std::uint32_t>(y * block_size + x);
  }
  static Square pixel_square(int x, int y) {
    return {static_cast<float>(x) * pixel_side, static_cast<float>(y) * pixel_side, pixel_side};
  }

  // Every pixel needs its centre's sample: coherent rays, traced together. Sample number i is that
  // of pixel i.
  void look_through_centres() {
    std::array<glm::vec2, pixels_in_block> centres;
    for (int y = 0; y < block_size; ++y) {
      for (int x = 0; x < block_size; ++x) {
        const Square s = pixel_square(x, y);
        centres[index(x, y)] = {s.centre_u(), s.centre_v()};
      }
    }
    (void)caster_.probe(centres);
  }

  // Hands the hit list of a fat pyray down to its pixels. `parent` may be the list of any square
  // that holds this one.
  void descend(const Square& square, int x, int y, int size, const HitLists::List& parent) {
    // Any sample inside the square can hide what lies behind it.
    const Cover cover = caster_.cover(index(x + size / 2, y + size / 2));
    const HidingPlane hiding = HidingPlane::of(cover, frame_, square.side);
    const auto depth = static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(size)));
    HitLists::List& list = size == 1 ? work_.pixel_list[index(x, y)] : work_.descent[depth];
    work_.lists.refine(square, hiding, parent, list);
    const bool clear = std::all_of(list.begin(), list.end(), [&](std::uint32_t i) {
      return work_.lists.hidden(i, square, hiding);
    });
    if (size == 1) {
      bounded_[index(x, y)] = !clear;
      return;
    }
    if (clear) {
      for (int v = y; v < y + size; ++v) {
        for (int u = x; u < x + size; ++u) {
          work_.pixel_list[index(u, v)].clear();
          bounded_[index(u, v)] = false;
        }
      }
      return;
    }
    const int half = size / 2;
    for (int i = 0; i < 4; ++i)
      descend(square.quarter(i), x + (i & 1) * half, y + (i >> 1) * half, half, list);
  }

  // Neighbours that show different surfaces without a boundary in either pixel.
  void find_missed_splits() {
    for (int y = 0; y < block_.height; ++y) {
      for (int x = 0; x < block_.width; ++x) {
        if (x + 1 < block_.width) compare(x, y, x + 1, y);
        if (y + 1 < block_.height) compare(x, y, x, y + 1);
      }
    }
  }

  void compare(int x0, int y0, int x1, int y1) {
    const std::uint32_t a = index(x0, y0);
    const std::uint32_t b = index(x1, y1);
    if (bounded_[a] || bounded_[b]) return;
    if (caster_.surface(a) == caster_.surface(b)) return;
    // A cut-out's outline is in its texture, where no edge can be found; the samples find it.
    by_samples_[a] = by_samples_[b] = true;
    if (caster_.opaque(a) && caster_.opaque(b) && !touches_boundary(x0, y0) &&
        !touches_boundary(x1, y1))
      missed_[a] = missed_[b] = true;
  }

  // Whether a boundary runs along the very border of a pixel, which neither side counts as its own.
  bool touches_boundary(int x, int y) {
    const Square own = pixel_square(x, y);
    const float border = own.side / 256.0f;
    const Square wide{own.u - border, own.v - border, own.side + 2.0f * border};
    const HidingPlane hiding = HidingPlane::of(caster_.cover(index(x, y)), frame_, wide.side);
    work_.lists.refine(wide, hiding, work_.lists.root(), work_.scratch);
    return !std::all_of(work_.scratch.begin(), work_.scratch.end(),
                        [&](std::uint32_t i) { return work_.lists.hidden(i, wide, hiding); });
  }

  // Clear pixels are one sample each, bounded ones are subdivided together, missed ones by the
  // safety net.
  void render_pixels() {
    SubdivisionRules rules;
    rules.max_level = settings_.max_level;
    rules.eps = settings_.eps;
    rules.exact_leaves = settings_.leaf == Leaf::exact;
    rules.jitter = settings_.jitter;
    std::array<Root, pixels_in_block> roots;
    std::array<SubdivisionOutcome, pixels_in_block> outcomes{};
    for (int y = 0; y < block_.height; ++y) {
      for (int x = 0; x < block_.width; ++x) {
        const std::uint32_t i = index(x, y);
        roots[i].square = pixel_square(x, y);
        roots[i].id = i;
        roots[i].centre = i;
        roots[i].seed = pixel_seed(block_.x + x, block_.y + y);
        if (bounded_[i]) {
          roots[i].list = work_.pixel_list[i];
        } else if (by_samples_[i]) {
          outcomes[i] = split_by_samples(roots[i], rules.max_level, caster_);
        } else {
          caster_.leaf(i, i, 1.0);
          outcomes[i].pyrays_by_level[0] = 1;
        }
      }
    }
    subdivide_bounded(roots, rules, outcomes);
    publish(outcomes);
  }

  void subdivide_bounded(std::span<const Root> roots, const SubdivisionRules& rules,
                         std::span<SubdivisionOutcome> outcomes) {
    std::vector<Root>& bounded = work_.bounded;
    bounded.clear();
    for (const Root& root : roots)
      if (!root.list.empty()) bounded.push_back(root);
    const auto done = work_.subdivider.run(work_.lists, bounded, rules, caster_);
    for (std::size_t k = 0; k < done.size(); ++k) outcomes[bounded[k].id] = done[k];
  }

  void publish(std::span<const SubdivisionOutcome> outcomes) {
    RenderStatistics& statistics = result_.statistics;
    // Centres beyond the picture's border were traced with the others and do not count.
    statistics.eye_rays -=
        static_cast<std::uint64_t>(pixels_in_block - block_.width * block_.height);
    result_.tile.rect = block_;
    for (int y = 0; y < block_.height; ++y) {
      for (int x = 0; x < block_.width; ++x) {
        const std::uint32_t i = index(x, y);
        const SubdivisionOutcome& outcome = outcomes[i];
        for (std::size_t k = 0; k < outcome.pyrays_by_level.size(); ++k)
          statistics.pyrays_by_level[k] += outcome.pyrays_by_level[k];
        statistics.split_pixels += outcome.deepest > 0;
        statistics.missed_splits += missed_[i];
        statistics.saturated_pixels += outcome.saturated;
        statistics.unresolved_area += outcome.unresolved_area;
        result_.tile.radiance.push_back(caster_.colour(i));
        result_.tile.split_level.push_back(static_cast<std::uint8_t>(outcome.deepest));
      }
    }
  }

  const RenderScene& scene_;
  const RenderSettings& settings_;
  PixelRect block_;
  Workspace& work_;
  Frame frame_;
  BlockResult result_;
  EyeCaster caster_;
  std::array<bool, pixels_in_block> bounded_{};  // a boundary that may be visible crosses the pixel
  std::array<bool, pixels_in_block> by_samples_{};  // splits by what its samples say
  std::array<bool, pixels_in_block> missed_{};      // and should not have had to
};

}  // namespace

BlockResult render_block_asos(const RenderScene& scene, const View& view,
                              const RenderSettings& settings, PixelRect block,
                              const std::stop_token& stop) {
  thread_local Workspace work;
  return BlockRenderer(scene, view, settings, block, stop, work).run();
}

}  // namespace asos
