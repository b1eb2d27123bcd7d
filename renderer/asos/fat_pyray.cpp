#include "renderer/asos/fat_pyray.h"

#include "renderer/asos/split_causes.h"
#include "renderer/asos/subdivision_rules.h"
#include "renderer/pyray/safety_net.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

namespace asos {
namespace {

std::uint64_t pixel_seed(int x, int y) {
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32 |
          static_cast<std::uint32_t>(y)) *
         0x9e3779b97f4a7c15ULL;
}

// The square of `size` x `size` pixels from (x, y) on of a frame in which `pixel` is a pixel's
// side, with what a wide filter adds around.
Square filtered(double x, double y, int size, double pixel, double filter_width) {
  const double beyond = 0.5 * (filter_width - 1.0);
  return {static_cast<float>((x - beyond) * pixel), static_cast<float>((y - beyond) * pixel),
          static_cast<float>((size + 2.0 * beyond) * pixel)};
}

// The block with what the filters of its outermost pixels, and their cones, reach beyond it: cones
// more the farther from the picture's middle they are.
PixelRect framed(const View& view, PixelRect block, const RenderSettings& settings) {
  const int fat = settings.asos.fat;
  const Detector detector(view.frame(block.x, block.y, fat, fat), settings.asos.detect);
  const double side = 1.0 / fat;
  double beyond = 0.5 * (settings.filter_width - 1.0);  // in pixels
  if (settings.asos.detect == Detection::cone) {
    for (const int x : {0, fat - 1}) {
      for (const int y : {0, fat - 1}) {
        const Square own = filtered(x, y, 1, side, settings.filter_width);
        beyond =
            std::max(beyond, 0.5 * (static_cast<double>(detector.reach(own).side) / side - 1.0));
      }
    }
  }
  const int border = static_cast<int>(std::ceil(beyond));
  return {block.x - border, block.y - border, fat + 2 * border, fat + 2 * border};
}

}  // namespace

FatPyray::FatPyray(const RenderScene& scene, const View& view, const RenderSettings& settings,
                   PixelRect block, const std::stop_token& stop, FatPyrayWorkspace& work)
    : scene_(scene),
      settings_(settings),
      block_(block),
      framed_(framed(view, block, settings)),
      work_(work),
      frame_(view.frame(framed_.x, framed_.y, framed_.width, framed_.height)),
      detector_(frame_, settings.asos.detect),
      shader_(shader_of(scene, settings, view)),
      caster_(scene, Viewer::camera(view, shader_, settings.filter_width), settings, frame_,
              framed_, static_cast<std::size_t>(settings.asos.fat * settings.asos.fat), work.eye,
              stop, result_.statistics) {
  const auto pixels = static_cast<std::size_t>(settings.asos.fat * settings.asos.fat);
  outcomes_.resize(pixels);
  bounded_.resize(pixels);
  by_samples_.resize(pixels);
  missed_.resize(pixels);
  work_.pixel_list.resize(std::max(pixels, work_.pixel_list.size()));
}

BlockResult FatPyray::run() {
  look_through_centres();
  work_.lists.reset(scene_.features, frame_,
                    pixel_square(0, 0).side / static_cast<float>(1 << settings_.asos.max_level));
  descend(0, 0, settings_.asos.fat, work_.lists.root());
  find_missed_splits();
  render_pixels();
  publish();
  return std::move(result_);
}

BlockResult FatPyray::run(PixelTrace& into) {
  trace_ = &into;
  const std::uint32_t traced = index(into.x - block_.x, into.y - block_.y);
  work_.subdivider.trace(traced, subdivision_);
  caster_.log_leaves(traced);
  work_.eye.shadows.log = &log_;
  BlockResult result = run();
  work_.eye.shadows.log = nullptr;
  finish_trace();
  into.radiance = caster_.colour(traced);
  return result;
}

Square FatPyray::square_of(int x, int y, int size) const {
  return filtered(block_.x - framed_.x + x, block_.y - framed_.y + y, size, 1.0 / framed_.width,
                  settings_.filter_width);
}

// Every pixel needs its centre's sample: coherent rays, traced together. Sample number i is that of
// pixel i.
void FatPyray::look_through_centres() {
  work_.centres.clear();
  for (int y = 0; y < settings_.asos.fat; ++y) {
    for (int x = 0; x < settings_.asos.fat; ++x) {
      const Square s = pixel_square(x, y);
      work_.centres.emplace_back(s.centre_u(), s.centre_v());
    }
  }
  (void)caster_.probe(work_.centres);
  caster_.gather_surfaces(settings_.asos.fat);
}

// Hands the hit list of a fat pyray down to its pixels. `parent` may be the list of any square that
// holds this one.
void FatPyray::descend(int x, int y, int size, const HitLists::List& parent) {
  const Square square = square_of(x, y, size);
  // Any sample inside the square can hide what lies behind it.
  const Cover cover = caster_.cover(index(x + size / 2, y + size / 2));
  const Square reach = detector_.reach(square);
  const HidingPlane hiding = HidingPlane::of(cover, frame_, reach.side);
  const auto depth = static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(size)));
  HitLists::List& list = size == 1 ? work_.pixel_list[index(x, y)] : work_.descent[depth];
  work_.lists.refine(reach, hiding, parent, list, true);
  std::erase_if(list, [&](std::uint32_t i) {
    return work_.lists.entry(i).is_segment() && !detector_.near(work_.lists.segment(i), square);
  });
  const bool clear = std::all_of(list.begin(), list.end(), [&](std::uint32_t i) {
    return work_.lists.hidden(i, reach, hiding);
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
  for (int i = 0; i < 4; ++i) descend(x + (i & 1) * half, y + (i >> 1) * half, half, list);
}

// Neighbours that show different surfaces without a boundary in either pixel.
void FatPyray::find_missed_splits() {
  for (int y = 0; y < block_.height; ++y) {
    for (int x = 0; x < block_.width; ++x) {
      if (x + 1 < block_.width) compare(x, y, x + 1, y);
      if (y + 1 < block_.height) compare(x, y, x, y + 1);
    }
  }
}

void FatPyray::compare(int x0, int y0, int x1, int y1) {
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
bool FatPyray::touches_boundary(int x, int y) {
  const Square own = pixel_square(x, y);
  const float border = own.side / 256.0f;
  const Square wide{own.u - border, own.v - border, own.side + 2.0f * border};
  const HidingPlane hiding = HidingPlane::of(caster_.cover(index(x, y)), frame_, wide.side);
  work_.lists.refine(wide, hiding, work_.lists.root(), work_.scratch);
  return !std::all_of(work_.scratch.begin(), work_.scratch.end(),
                      [&](std::uint32_t i) { return work_.lists.hidden(i, wide, hiding); });
}

// Clear pixels are one sample each, bounded and unevenly shaded ones are subdivided together,
// missed ones by the safety net.
void FatPyray::render_pixels() {
  work_.split_roots.clear();
  for (int y = 0; y < block_.height; ++y) {
    for (int x = 0; x < block_.width; ++x) {
      const std::uint32_t i = index(x, y);
      Root root;
      root.square = pixel_square(x, y);
      root.id = i;
      root.centre = i;
      root.seed = pixel_seed(block_.x + x, block_.y + y);
      if (bounded_[i]) {
        root.list = work_.pixel_list[i];
        work_.split_roots.push_back(root);
      } else if (by_samples_[i]) {
        outcomes_[i] = split_by_samples(root, settings_.asos.max_level, caster_);
      } else if (settings_.asos.max_level > 0 &&
                 caster_.uneven(i, 1.0, {root.square, {}}) != Unevenness::none) {
        work_.split_roots.push_back(root);
      } else {
        caster_.leaf(i, i, 1.0, {root.square, {}});
        outcomes_[i].pyrays_by_level[0] = 1;
      }
    }
  }
  const auto done =
      work_.subdivider.run(work_.lists, work_.split_roots, rules_of(settings_), caster_);
  for (std::size_t k = 0; k < done.size(); ++k) outcomes_[work_.split_roots[k].id] = done[k];
}

void FatPyray::publish() {
  RenderStatistics& statistics = result_.statistics;
  // Centres beyond the picture's border were traced with the others and do not count.
  statistics.eye_rays -= static_cast<std::uint64_t>(settings_.asos.fat * settings_.asos.fat -
                                                    block_.width * block_.height);
  result_.tile.rect = block_;
  for (int y = 0; y < block_.height; ++y) {
    for (int x = 0; x < block_.width; ++x) {
      const std::uint32_t i = index(x, y);
      const SubdivisionOutcome& outcome = outcomes_[i];
      for (std::size_t k = 0; k < outcome.pyrays_by_level.size(); ++k)
        statistics.pyrays_by_level[k] += outcome.pyrays_by_level[k];
      statistics.split_pixels += outcome.deepest > 0;
      statistics.missed_splits += missed_[i];
      statistics.uneven_pixels += outcome.uneven_shading || outcome.uneven_shadow;
      statistics.saturated_pixels += outcome.saturated;
      statistics.unresolved_area += outcome.unresolved_area;
      result_.tile.radiance.push_back(caster_.colour(i));
      result_.tile.split_level.push_back(static_cast<std::uint8_t>(outcome.deepest));
      const SplitCause cause =
          cause_of({outcome, by_samples_[i] != 0, caster_.shadow_cut(i), caster_.mirror_cut(i)});
      result_.tile.cause.push_back(cause);
      if (cause != SplitCause::none) ++statistics.pixels_by_cause[static_cast<std::size_t>(cause)];
    }
  }
  publish_rays();
}

// Each cell that was examined has a sample of its own. What else the block cast, as to find out
// whether a patch is evenly lit, its pixels share.
void FatPyray::publish_rays() {
  std::uint64_t told = 0;
  for (int y = 0; y < block_.height; ++y) {
    for (int x = 0; x < block_.width; ++x) {
      const std::uint32_t i = index(x, y);
      const auto& cells = outcomes_[i].pyrays_by_level;
      const std::uint64_t rays =
          std::accumulate(cells.begin(), cells.end(), caster_.rays_of_leaves(i));
      told += rays;
      result_.tile.rays.push_back(static_cast<float>(rays));
    }
  }
  const std::uint64_t all = result_.statistics.rays();
  if (all <= told) return;
  const float shared =
      static_cast<float>(all - told) / static_cast<float>(block_.width * block_.height);
  for (float& rays : result_.tile.rays) rays += shared;
}

}  // namespace asos
